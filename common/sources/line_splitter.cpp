#include "common/sources/line_splitter.h"

#include <algorithm>
#include <utility>

namespace aucast::sources {

std::optional<LineSplitter::Line> LineSplitter::next() {
  while (!fed_.empty()) {
    if (std::exchange(after_return_, false) && fed_.starts_with('\n')) {
      fed_.remove_prefix(1);
      continue;
    }
    const std::size_t length = std::min(fed_.find_first_of("\r\n"), fed_.size());
    const std::string_view piece = fed_.substr(0, length);
    const bool ends = length < fed_.size();
    after_return_ = ends && fed_[length] == '\r';
    fed_.remove_prefix(ends ? length + 1 : length);
    const bool skipped = skipping_;
    if (ends) skipping_ = false;
    if (skipped) continue;
    const std::size_t room = bytes_max_ - partial_.size();
    const bool too_long = piece.size() > room;
    partial_ += piece.substr(0, room);
    if (!ends && !too_long) continue;
    skipping_ = !ends;
    return Line{std::exchange(partial_, {}), ++number_, too_long};
  }
  return std::nullopt;
}

bool LineSplitter::drop_partial() {
  skipping_ = false;
  return !std::exchange(partial_, {}).empty();
}

void LineSplitter::restart() {
  drop_partial();
  after_return_ = false;
  number_ = 0;
}

}  // namespace aucast::sources

#include "common/sources/line_splitter.h"

#include <algorithm>
#include <utility>

namespace aucast::sources {

std::optional<LineSplitter::Line> LineSplitter::next() {
  if (fed_.empty()) return std::nullopt;
  if (std::exchange(after_return_, false) && fed_.starts_with('\n')) fed_.remove_prefix(1);
  const std::size_t feed = fed_.find_first_of("\r\n");
  const std::string_view piece = fed_.substr(0, feed);
  const std::size_t room = bytes_max_ - std::min(bytes_max_, partial_.size());
  partial_ += piece.substr(0, room);
  cut_ = cut_ || piece.size() > room;
  const bool ended_by_return = feed != std::string_view::npos && fed_[feed] == '\r';
  fed_.remove_prefix(feed == std::string_view::npos ? fed_.size() : feed + 1);
  if (feed == std::string_view::npos) return std::nullopt;
  after_return_ = ended_by_return;
  return Line{std::exchange(partial_, {}), ++number_, std::exchange(cut_, false)};
}

bool LineSplitter::drop_partial() {
  cut_ = false;
  return !std::exchange(partial_, {}).empty();
}

void LineSplitter::restart() {
  drop_partial();
  after_return_ = false;
  number_ = 0;
}

}  // namespace aucast::sources

#include "tests/unit/protocol/faulty_link.h"

#include <algorithm>

namespace aucast::test {

void FaultyLink::write(std::string_view bytes, Instant now) {
  while (!bytes.empty()) {
    const auto most = static_cast<int>(std::min<std::size_t>(bytes.size(), 64));
    const auto size = static_cast<std::size_t>(seeded_.integer(1, most));
    const auto delay = Milliseconds(seeded_.integer(0, static_cast<int>(delay_max_.count())));
    const Instant before = pieces_.empty() ? now : pieces_.back().due;
    pieces_.push_back({std::max(before, now + delay), std::string(bytes.substr(0, size))});
    bytes.remove_prefix(size);
  }
}

std::string FaultyLink::read(Instant now) {
  std::string bytes;
  while (!pieces_.empty() && pieces_.front().due <= now && now >= down_until_) {
    bytes += pieces_.front().bytes;
    pieces_.pop_front();
    if (seeded_.chance(0.4)) break;
  }
  return bytes;
}

}  // namespace aucast::test

#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

namespace aucast::web {

/// Makes room for one more exchange where there may be `most`, which stand in the order they came:
/// the oldest that is still asking() goes, for one that says nothing must not keep others out; if
/// all have asked, the oldest.
template <typename Exchange>
void make_room(std::vector<std::shared_ptr<Exchange>>& exchanges, std::size_t most) {
  if (exchanges.size() < most) return;
  const auto silent = std::find_if(exchanges.begin(), exchanges.end(),
                                   [](const auto& exchange) { return exchange->asking(); });
  exchanges.erase(silent == exchanges.end() ? exchanges.begin() : silent);
}

}  // namespace aucast::web

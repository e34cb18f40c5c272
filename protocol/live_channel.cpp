#include "protocol/live_channel.h"

#include <algorithm>

#include "protocol/limits.h"

namespace aucast::protocol {

void LiveChannel::limit_window(double mean_ms) {
  const double moments = static_cast<double>(kLiveWindowTime.count()) / std::max(mean_ms, 1.0);
  window_max_ = std::max(static_cast<std::size_t>(moments), std::size_t{2});
}

}  // namespace aucast::protocol

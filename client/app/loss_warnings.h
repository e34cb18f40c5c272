#pragma once

#include <cstdint>
#include <string>

#include "client/playback/playback.h"

namespace aucast::app {

/// Reports each loss of the connection once, if the player tries to connect again.
class LossWarnings {
 public:
  /// Returns a warning about a loss that has not been reported yet; empty if there is none. Call it
  /// often while there is nothing to play.
  [[nodiscard]] std::string look_at(const playback::Playback& playback);

 private:
  std::string said_;          ///< the last warning
  std::uint64_t played_ = 0;  ///< keyframes that were played before it
};

}  // namespace aucast::app

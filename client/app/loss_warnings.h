#pragma once

#include <cstdint>
#include <string>

#include "client/playback/playback.h"

namespace aucast::app {

/// Finds each loss of the connection after which it is tried again, once.
class LossWarnings {
 public:
  /// The warning of a loss that was not told of before; else empty. Call it often while there is
  /// nothing to play.
  [[nodiscard]] std::string look_at(const playback::Playback& playback);

 private:
  std::string said_;          ///< the last warning
  std::uint64_t played_ = 0;  ///< keyframes that were played before it
};

}  // namespace aucast::app

#pragma once

#include <cstdint>
#include <string>

#include "client/playback/playback.h"

namespace aucast::app {

/// Warns on the terminal of each loss of the connection after which it is tried again, once.
class LossWarnings {
 public:
  /// Call it often while there is nothing to play.
  void look_at(const playback::Playback& playback);

 private:
  std::string said_;          ///< the last warning
  std::uint64_t played_ = 0;  ///< keyframes that were played before it
};

}  // namespace aucast::app

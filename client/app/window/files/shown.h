#pragma once

#include <cstdint>

namespace aucast::app {

/// Which session's face the window shows.
enum class Shown : std::uint8_t { Playback, Editor, Composer };

}  // namespace aucast::app

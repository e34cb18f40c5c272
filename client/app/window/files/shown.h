#pragma once

#include <cstdint>

namespace aucast::app {

/// Whose face the window shows.
enum class Shown : std::uint8_t { Playback, Editor, Composer };

}  // namespace aucast::app

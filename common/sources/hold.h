#pragma once

namespace aucast::sources {

/// How long a channel without data keeps its last value, ...
inline constexpr double kHoldSeconds = 0.5;
/// ... and how long it then takes to reach neutral.
inline constexpr double kEaseSeconds = 1.0;

}  // namespace aucast::sources

#pragma once

namespace aucast::sources {

/// A channel without data keeps its last value for so long,
inline constexpr double kHoldSeconds = 0.5;
/// and is then led to neutral in so long.
inline constexpr double kEaseSeconds = 1.0;

}  // namespace aucast::sources

#pragma once

#include <chrono>

namespace aucast {

/// A moment on the steady clock. Pure code takes it as an argument and never reads a clock, so that
/// tests can hand in any moment they like.
using Instant = std::chrono::steady_clock::time_point;
using Duration = std::chrono::steady_clock::duration;
using Milliseconds = std::chrono::milliseconds;

}  // namespace aucast

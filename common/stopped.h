#pragma once

#include <functional>
#if __has_include(<stop_token>)
#include <stop_token>
#endif

#include "common/result.h"

namespace aucast {

#if __has_include(<stop_token>)
using StopToken = std::stop_token;
#else
/// The standard library of the web page (WebAssembly) has no std::stop_token, and nothing stops
/// what the page reads.
struct StopToken {
  [[nodiscard]] static bool stop_requested() { return false; }
};
#endif

/// Asked again and again by a function that waits, on its thread; returns true to end the waiting.
using GivenUp = std::function<bool()>;

/// The error of work that was asked to stop before its end. Nobody waits for its result any more.
[[nodiscard]] inline Error stopped_early() {
  return {ErrorKind::Failed, "stopped before its end"};
}

}  // namespace aucast

#pragma once

#if __has_include(<stop_token>)
#include <stop_token>
#endif

#include "common/result.h"

namespace aucast {

#if __has_include(<stop_token>)
using StopToken = std::stop_token;
#else
/// The page's standard library has none, and what the page reads is never stopped.
struct StopToken {
  [[nodiscard]] static bool stop_requested() { return false; }
};
#endif

/// What work returns that was asked to stop and did not come to its end. Nobody waits for its
/// result any more.
[[nodiscard]] inline Error stopped_early() {
  return {ErrorKind::Failed, "stopped before its end"};
}

}  // namespace aucast

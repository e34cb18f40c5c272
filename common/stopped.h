#pragma once

#include "common/result.h"

namespace aucast {

/// What work returns that was asked to stop and did not come to its end. Nobody waits for its
/// result any more.
[[nodiscard]] inline Error stopped_early() {
  return {ErrorKind::Failed, "stopped before its end"};
}

}  // namespace aucast

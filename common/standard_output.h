#pragma once

#include <string_view>

#include "common/result.h"

namespace aucast {

/// Writes `text` to stdout at once, for a program that may be waiting at the other end of a pipe.
/// Fails with ErrorKind::Failed and the cause if this or earlier output cannot be written.
[[nodiscard]] Result<void> print_now(std::string_view text = {});

}  // namespace aucast

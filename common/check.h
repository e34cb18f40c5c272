#pragma once

#include <cstdio>
#include <cstdlib>

namespace aucast::detail {

[[noreturn]] inline void check_failed(const char* condition, const char* file, int line) {
  std::fprintf(stderr, "%s:%d: broken invariant: %s\n", file, line, condition);
  std::abort();
}

}  // namespace aucast::detail

/// Aborts when a precondition or an invariant does not hold, in release builds too. For programming
/// errors only: what a user, a file or a peer can cause is a Result.
#define AUCAST_CHECK(condition)                        \
  (static_cast<bool>(condition) ? static_cast<void>(0) \
                                : ::aucast::detail::check_failed(#condition, __FILE__, __LINE__))

#pragma once

#include <functional>
#include <stop_token>
#include <system_error>
#include <thread>
#include <utility>

#include "common/result.h"
#include "common/text.h"
#include "common/time.h"

namespace aucast {

/// Starts a thread, which the caller joins. `work` may take a std::stop_token, by which the
/// destructor of the std::jthread, or its owner before that, asks it to stop. Fails with
/// ErrorKind::Failed if the system has no thread left.
template <typename Work>
[[nodiscard]] Result<std::jthread> start_thread(Work work) {
  try {
    return std::jthread(std::move(work));
  } catch (const std::system_error& failure) {
    return Error{ErrorKind::Failed, shortage_text(failure)};
  }
}

/// Waits until `until`, or until a stop is requested.
void sleep_until(const std::stop_token& stop, Instant until);

/// Starts a thread that nobody joins, for a call that cannot be interrupted and may take too long
/// to wait for because a server does not answer: getaddrinfo(), and what libnats does to connect
/// anew. The thread may outlive everything except what `work` owns. `work` reports its result
/// through a link::LoopGate. Whoever no longer wants the result closes the gate.
[[nodiscard]] Result<void> start_unattended(std::function<void()> work);

}  // namespace aucast

#pragma once

#include <functional>
#include <thread>

#include "common/result.h"

namespace aucast {

/// Starts a thread, which the caller joins. Fails with ErrorKind::Failed if the system has no
/// thread left.
[[nodiscard]] Result<std::jthread> start_thread(std::function<void()> work);

/// Starts a thread that nobody joins, for a call that cannot be interrupted and may take too long
/// to wait for because a server does not answer: getaddrinfo(), and what libnats does to connect
/// anew. The thread may outlive everything except what `work` owns. `work` reports its result
/// through a link::LoopGate. Whoever no longer wants the result closes the gate.
[[nodiscard]] Result<void> start_unattended(std::function<void()> work);

}  // namespace aucast

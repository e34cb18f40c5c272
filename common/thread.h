#pragma once

#include <functional>
#include <thread>

#include "common/result.h"

namespace aucast {

/// A thread of its own, which its owner joins. Failed when the system has none left.
[[nodiscard]] Result<std::jthread> start_thread(std::function<void()> work);

/// The same for a call that can neither be interrupted nor waited for, because a server that does
/// not answer may hold it up: getaddrinfo(), and libnats' first connection. The thread may outlive
/// everything except what `work` owns; its result goes through a link::LoopGate, which the owner
/// closes.
[[nodiscard]] Result<void> start_unattended(std::function<void()> work);

}  // namespace aucast

#pragma once

#include <functional>
#include <thread>

#include "common/result.h"

namespace aucast {

/// A thread of its own, which its owner joins. Failed when the system has none left.
[[nodiscard]] Result<std::jthread> start_thread(std::function<void()> work);

/// The same of a call that can neither be broken off nor be waited for, because it takes as long as
/// a server that does not answer: getaddrinfo(), and libnats' first connection. It may outlive all
/// but what `work` owns; what it finds goes through a link::LoopGate, which its owner closes.
[[nodiscard]] Result<void> start_unattended(std::function<void()> work);

}  // namespace aucast

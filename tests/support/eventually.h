#pragma once

#include <chrono>
#include <thread>

namespace aucast::test {

/// Asks every few milliseconds whether the condition holds, for at most `patience`, by default
/// longer than a busy machine needs. Returns whether it holds.
template <typename Condition>
[[nodiscard]] bool eventually(Condition condition,
                              std::chrono::milliseconds patience = std::chrono::seconds(20)) {
  const auto give_up = std::chrono::steady_clock::now() + patience;
  while (!condition()) {
    if (std::chrono::steady_clock::now() >= give_up) return condition();
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return true;
}

}  // namespace aucast::test

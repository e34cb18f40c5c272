#pragma once

#include <chrono>

#include <asio/io_context.hpp>

namespace aucast::test {

/// Lets the loop run until the condition holds, but no longer than 20 s, which is more than a busy
/// machine needs. Returns whether it holds.
template <typename Condition>
[[nodiscard]] bool run_until(asio::io_context& io, Condition condition) {
  const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while (!condition() && std::chrono::steady_clock::now() < give_up) {
    io.run_one_for(std::chrono::milliseconds(100));
  }
  return condition();
}

}  // namespace aucast::test

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>

#include <asio/io_context.hpp>

#include "common/shared.h"

namespace aucast::link {

/// The way from other threads to an event loop: what is posted is carried out there, in its order,
/// until the gate is closed. Whoever may still post holds it; what is carried out may use whatever
/// lives until the gate is closed.
/// Thread: any; close() that of the loop.
class LoopGate : public std::enable_shared_from_this<LoopGate> {
 public:
  using Work = std::function<void()>;
  /// What waits for the loop. More is left out and counted.
  static constexpr std::size_t kBytesMax = std::size_t{4} << 20U;

  /// `on_full`: carried out, too, when something is left out for the first time.
  explicit LoopGate(
      asio::io_context& io, Work on_full = [] {})
      : state_(&io), on_full_(std::move(on_full)) {}

  /// `bytes`: that the work holds, of what may come without end.
  void post(Work work, std::size_t bytes = 0);
  /// Nothing is carried out any more, and the loop is not touched again.
  void close();
  [[nodiscard]] bool is_open() const;
  [[nodiscard]] std::uint64_t left_out() const;

 private:
  struct State {
    asio::io_context* io;  ///< null: closed
    std::size_t waiting_bytes = 0;
    std::uint64_t left_out = 0;
  };

  void pass(State& state, Work work, std::size_t bytes);

  Shared<State> state_;
  const Work on_full_;
};

}  // namespace aucast::link

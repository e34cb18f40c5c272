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
  /// What waits for the loop of that which may come without end. More is left out and counted.
  static constexpr std::size_t kBytesMax = std::size_t{4} << 20U;
  /// What one such work counts for beside its own bytes: about what it takes while it waits, so
  /// that works without a byte have their limit too.
  static constexpr std::size_t kBytesEach = 256;

  /// `on_full`: carried out, too, when something is left out for the first time.
  explicit LoopGate(
      asio::io_context& io, Work on_full = [] {})
      : state_(&io), on_full_(std::move(on_full)) {}

  /// Never left out: for works that are few by themselves, such as the answer to a question.
  void post(Work work);
  /// For works that may come without end. `bytes`: what the work holds that came from outside.
  void post_if_room(Work work, std::size_t bytes);
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

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>

#include <asio/io_context.hpp>

#include "common/shared.h"

namespace aucast::link {

/// The way from other threads to an event loop: work that is posted runs on the loop, in order,
/// until the gate is closed. Every thread that may still post holds a shared_ptr to the gate. The
/// work may use whatever lives until the gate is closed.
/// Thread: any, but for close() only that of the loop.
class LoopGate : public std::enable_shared_from_this<LoopGate> {
 public:
  using Work = std::function<void()>;
  /// How many bytes of work from post_if_room() may wait for the loop. More is left out and
  /// counted.
  static constexpr std::size_t kBytesMax = std::size_t{4} << 20U;
  /// Each waiting piece of such work counts as this many bytes more than its data: about the memory
  /// that the piece itself takes. So pieces without data are limited too.
  static constexpr std::size_t kBytesEach = 256;

  /// `on_full`: runs on the loop when something is left out for the first time.
  explicit LoopGate(
      asio::io_context& io, Work on_full = [] {})
      : state_(&io), on_full_(std::move(on_full)) {}

  /// Posts work that is never left out, because there is little of it, such as the answer to a
  /// question.
  void post(Work work);
  /// The same, but waits until the loop has done the work, or the gate is closed: a thread that
  /// makes much work so has one piece of it waiting. Not for the loop's own thread.
  void post_and_wait(Work work);
  /// Posts work of which any amount may come; leaves it out if kBytesMax would be exceeded.
  /// `bytes`: the size of the data from outside that the work owns.
  void post_if_room(Work work, std::size_t bytes);
  /// From now on no work runs, the loop is not touched, and nobody waits in post_and_wait().
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

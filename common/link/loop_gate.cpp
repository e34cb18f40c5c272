#include "common/link/loop_gate.h"

#include <utility>

#include <asio/post.hpp>

namespace aucast::link {

void LoopGate::post(Work work) {
  state_.with([&](State& state) {
    if (state.io != nullptr) pass(state, std::move(work), 0);
  });
}

void LoopGate::post_and_wait(Work work) {
  const auto done = std::make_shared<bool>(false);  // behind the lock of the state
  post([self = shared_from_this(), done, work = std::move(work)] {
    work();
    self->state_.change([&done](State&) { *done = true; });
  });
  state_.wait([&done](const State& state) { return *done || state.io == nullptr; }, [](State&) {});
}

void LoopGate::post_if_room(Work work, std::size_t bytes) {
  const std::size_t cost = bytes + kBytesEach;
  state_.with([&](State& state) {
    if (state.io == nullptr) return;
    if (state.waiting_bytes + cost <= kBytesMax) {
      pass(state, std::move(work), cost);
    } else if (++state.left_out == 1) {
      pass(state, on_full_, 0);
    }
  });
}

void LoopGate::pass(State& state, Work work, std::size_t bytes) {
  state.waiting_bytes += bytes;
  asio::post(*state.io, [self = shared_from_this(), work = std::move(work), bytes] {
    const bool open = self->state_.with([bytes](State& now) {
      now.waiting_bytes -= bytes;
      return now.io != nullptr;
    });
    if (open) work();
  });
}

void LoopGate::close() {
  state_.change([](State& state) { state.io = nullptr; });
}

bool LoopGate::is_open() const {
  return state_.with([](const State& state) { return state.io != nullptr; });
}

std::uint64_t LoopGate::left_out() const {
  return state_.with([](const State& state) { return state.left_out; });
}

}  // namespace aucast::link

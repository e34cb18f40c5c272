#include "server/engine/loop_gate.h"

#include <utility>

#include <asio/post.hpp>

namespace aucast::server {

void LoopGate::post(Work work, std::size_t bytes) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (io_ == nullptr || waiting_bytes_ + bytes > kBytesMax) return;
  waiting_bytes_ += bytes;
  asio::post(*io_, [self = shared_from_this(), work = std::move(work), bytes] {
    if (self->take(bytes)) work(self->events_);
  });
}

bool LoopGate::take(std::size_t bytes) {
  const std::lock_guard<std::mutex> lock(mutex_);
  waiting_bytes_ -= bytes;
  return io_ != nullptr;
}

bool LoopGate::is_open() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return io_ != nullptr;
}

void LoopGate::close() {
  const std::lock_guard<std::mutex> lock(mutex_);
  io_ = nullptr;
}

}  // namespace aucast::server

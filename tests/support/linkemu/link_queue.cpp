#include "tests/support/linkemu/link_queue.h"

#include <algorithm>
#include <utility>

namespace aucast::linkemu {
namespace {

Duration milliseconds(double count) {
  return std::chrono::duration_cast<Duration>(std::chrono::duration<double, std::milli>(count));
}

}  // namespace

void LinkQueue::put(std::string packet, Instant now) {
  if (down_ || loses_one()) {
    ++lost_;
    return;
  }
  if (waiting_bytes(now) + packet.size() > quality_.queue_bytes) {
    ++too_many_;
    return;
  }
  free_at_ = std::max(free_at_, now);
  if (quality_.kilobits > 0) {
    free_at_ += milliseconds(static_cast<double>(packet.size()) * 8 / quality_.kilobits);
  }
  const double jitter = quality_.jitter_ms * (2 * random() - 1);
  Instant due = free_at_ + milliseconds(std::max(0.0, quality_.delay_ms + jitter));
  if (!packets_.empty()) due = std::max(due, packets_.back().due);
  packets_.push_back({due, free_at_, std::move(packet)});
}

std::optional<std::string> LinkQueue::take(Instant now) {
  if (packets_.empty() || packets_.front().due > now) return std::nullopt;
  std::string bytes = std::move(packets_.front().bytes);
  packets_.pop_front();
  ++passed_;
  return bytes;
}

std::optional<Instant> LinkQueue::next_at() const {
  if (packets_.empty()) return std::nullopt;
  return packets_.front().due;
}

void LinkQueue::set_down(bool down) {
  down_ = down;
  if (!down) return;
  lost_ += packets_.size();
  packets_.clear();
}

/// Two states: losing, which each packet leaves by one in `burst`, and not losing, which is left so
/// often that `loss_percent` of all are lost.
bool LinkQueue::loses_one() {
  const double part = quality_.loss_percent / 100;
  if (part <= 0) return false;
  const double stop = 1 / std::max(quality_.burst, 1.0);
  const double begin = stop * part / std::max(1 - part, 1e-9);
  losing_ = losing_ ? random() >= stop : random() < begin;
  run_ = losing_ ? run_ + 1 : 0;
  longest_ = std::max(longest_, run_);
  return losing_;
}

std::size_t LinkQueue::waiting_bytes(Instant now) const {
  std::size_t bytes = 0;
  for (const Packet& packet : packets_) {
    if (packet.sent > now) bytes += packet.bytes.size();
  }
  return bytes;
}

}  // namespace aucast::linkemu

#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>

#include "client/playback/keyframe_source.h"

namespace aucast::playback {

/// The Receiver and the Playout buffer in one queue, first-in first-out: in front the keyframes of
/// the Playout buffer, behind them those of the Receiver. So a keyframe passes from one to the
/// other without being moved. Invariant: neither holds more than its capacity.
/// Thread: none of its own.
class KeyframeQueue {
 public:
  KeyframeQueue(std::size_t receiver_capacity, std::size_t playout_capacity)
      : receiver_capacity_(receiver_capacity), playout_capacity_(playout_capacity) {}

  /// Puts a keyframe into the Receiver, which must have room().
  void push(const Keyframe& keyframe) {
    keyframes_.push_back(keyframe);
    time_ += time_of(keyframe);
  }
  /// Fills the Playout buffer from the Receiver, if it is empty.
  void fill_playout() {
    if (playout_ == 0) playout_ = std::min(playout_capacity_, keyframes_.size());
  }
  /// Takes the first keyframe of the Playout buffer, which must have one, and refills that when it
  /// runs empty.
  [[nodiscard]] Keyframe pop() {
    const Keyframe first = keyframes_.front();
    remove_first();
    --playout_;
    fill_playout();
    return first;
  }
  /// Drops the oldest of all. The Receiver's oldest follows into the Playout buffer.
  void drop() {
    remove_first();
    playout_ = std::min(playout_, keyframes_.size());
  }

  /// How many more keyframes the Receiver can take.
  [[nodiscard]] std::size_t room() const { return receiver_capacity_ - receiver_fill(); }
  [[nodiscard]] std::size_t receiver_fill() const { return keyframes_.size() - playout_; }
  [[nodiscard]] std::size_t playout_fill() const { return playout_; }
  [[nodiscard]] std::size_t size() const { return keyframes_.size(); }
  /// There must be one.
  [[nodiscard]] const Keyframe& newest() const { return keyframes_.back(); }

  /// The sum of the times of all.
  [[nodiscard]] Milliseconds time() const { return time_; }
  [[nodiscard]] Milliseconds time_of(const Keyframe& keyframe) const {
    return keyframe.time.value_or(untimed_);
  }
  /// The time of a keyframe that has none of its own.
  void set_untimed(Milliseconds untimed) {
    untimed_ = untimed;
    time_ = {};
    for (const Keyframe& keyframe : keyframes_) time_ += time_of(keyframe);
  }

 private:
  void remove_first() {
    time_ -= time_of(keyframes_.front());
    keyframes_.pop_front();
  }

  std::size_t receiver_capacity_;
  std::size_t playout_capacity_;
  std::deque<Keyframe> keyframes_;
  std::size_t playout_ = 0;  ///< how many of them, from the front, are the Playout buffer's
  Milliseconds time_{0};
  Milliseconds untimed_{250};
};

}  // namespace aucast::playback

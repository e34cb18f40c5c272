#pragma once

#include <deque>
#include <optional>
#include <span>

#include "client/face/face.h"
#include "client/face/opposed_channels.h"
#include "common/time.h"

namespace aucast::pipeline {

/// Makes hair swing after the head. Where it hangs is a closed form: a weighted mean of the head's
/// turns, nods and tilts of the last kMemory, as a damped pendulum would have it. So it does not
/// depend on when it was asked for, and what was before kMemory, such as another place of a stream,
/// does not count. While the head has stood still for so long, the hair is at rest to the last bit.
/// It has no clock: time is handed in.
/// Thread: none of its own.
class HairSwing {
 public:
  static constexpr Milliseconds kMemory{600};

  explicit HairSwing(const face::Face& face);

  /// Whether the face has hair that can swing; if not, what is told of its head changes nothing.
  [[nodiscard]] bool can_swing() const { return head_.has_value(); }

  /// The head was moved, and is at `at` as in `activations`, one per channel; in between it goes
  /// straight on. Of two poses of one time the later is where it has jumped to. The times must not
  /// go back.
  void move(Instant at, std::span<const float> activations);
  /// The face is as in `activations` and nobody plays it: if the head is elsewhere than before, it
  /// was put there, with its hair at rest; else the hair settles.
  void put(Instant at, std::span<const float> activations);

  /// The hair hangs at rest until the head moves again.
  void rest() { poses_.clear(); }

  /// Where the hair hangs at `at`, not earlier than the last forget_before(). Before the first pose
  /// the head was always there, and after the last one it stays.
  [[nodiscard]] face::HairSway at(Instant at) const;
  /// Says that at() will not be asked for any time before `at` from now on.
  void forget_before(Instant at);
  /// Whether the hair hangs elsewhere at `at` than it will later.
  [[nodiscard]] bool swings(Instant at) const;

 private:
  /// Of the head.
  struct Degrees {
    double turn = 0;
    double pitch = 0;
    double tilt = 0;
    bool operator==(const Degrees&) const = default;
  };
  struct Pose {
    Instant at;
    Degrees head;
  };

  [[nodiscard]] Degrees head_of(std::span<const float> activations) const;
  [[nodiscard]] Degrees head_at(Instant at) const;

  std::optional<face::HeadPose> head_;  ///< nullopt: the hair does not swing
  double most_deg_ = 0;
  face::OpposedChannels turn_;
  face::OpposedChannels pitch_;
  face::OpposedChannels tilt_;
  std::deque<Pose> poses_;  ///< ascending
};

}  // namespace aucast::pipeline

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "client/playback/keyframe_queue.h"
#include "client/playback/keyframe_source.h"

namespace aucast::playback {

struct BufferOptions {
  static constexpr std::size_t kSetsMax = 10'000;
  static constexpr Milliseconds kDelayMax{60'000};

  std::size_t receiver_capacity = 100;  ///< sets, 1 to kSetsMax
  std::size_t playout_capacity = 30;    ///< sets, 1 to kSetsMax, at most receiver_capacity
  int threshold_percent = 40;           ///< how full the Receiver buffer must be to start, 1-100,
                                        ///< at first and after a stall
  Milliseconds live_delay{300};         ///< live streams wait for this instead, 0 to kDelayMax
  bool by_time = false;                 ///< --buffer auto or Nms: recorded streams wait for
                                        ///< `live_delay` too, and not for the threshold
  bool adapt = false;                   ///< `live_delay` is only the initial value
  bool low_delay = false;               ///< --live: a live keyframe begins as soon as it is there
                                        ///< and is reached at its own Keyframe::due
};

/// The capacity in sets of the Receiver buffer with --buffer auto and --buffer Nms: enough for
/// kDelayMax at 30 sets a second, and some more.
inline constexpr std::size_t kReceiverSetsByTime = 2000;

/// How many sets must be in the Receiver buffer before the Playout buffer is filled:
/// threshold_percent of its capacity, rounded up.
[[nodiscard]] constexpr std::size_t threshold_of(const BufferOptions& options) {
  return (options.receiver_capacity * static_cast<std::size_t>(options.threshold_percent) + 99) /
         100;
}

/// The Receiver and the Playout buffer of the thesis (5.4.4.1-5.4.4.2, figures 5.12-5.15): decides
/// when what they hold is played. What the figures leave open is decided thus: at the end of the
/// stream the buffers are played even below the threshold; a full receiver fills an empty playout
/// whatever the threshold; when the controller's take() refills the playout, the reader can see
/// that there is room(). Invariant: sizes never exceed the capacities; nothing is duplicated or
/// reordered, and nothing of a recorded stream is lost.
///
/// Playing means that the Playout buffer is not empty. When it starts, at first and after a stall,
/// depends on the stream and on the options:
///
/// Recorded: at `threshold_percent`, by the thesis's cases.
///
/// Recorded, `by_time`: with two keyframes and `live_delay`. With `adapt`, each stall doubles
/// `live_delay`, up to 10 s. A `live_delay` of more than 10 s is left as it was set.
///
/// Live: with two keyframes and `live_delay`, or when the receiver is full. A keyframe is played in
/// 95 % of its time if more than `live_delay` plus that time is buffered after it. With `adapt`, it
/// takes 105 % of its time if less than `live_delay` minus twice that time is buffered after it.
/// While playback is waiting and more than `live_delay` + kLiveLagMax is buffered, the oldest are
/// dropped until `live_delay` is left.
///
/// Live, `low_delay`: with one keyframe; pace_percent stays 100. Let `wanted` be the time from the
/// newest keyframe's arrival until it is due, or its own time if it has no due time. While playback
/// is waiting and more than `wanted` + kStandingLagMax is buffered, the oldest are dropped until
/// `wanted` is left.
///
/// Thread: none of its own; the owner serialises the calls.
class KeyframeBuffers {
 public:
  /// For a recorded stream, until set_live(). The options must be in their ranges.
  explicit KeyframeBuffers(BufferOptions options);

  // === The AU reader's side.

  /// Whether store() has taken the keyframe.
  enum class Stored : bool { No, Yes };
  /// Stores a keyframe. A live one is always taken; if the receiver is full, the oldest is dropped.
  /// One of a recorded stream is stored by the thesis's cases:
  ///   A  receiver full, playing: No. Send -1, keep the keyframe and try again when there is room()
  ///   B  receiver full, playout empty: fills the Playout buffer, then stores
  ///   C  room, playing: stores
  ///   D  room, playout empty: stores, and fills the Playout buffer if the receiver had reached the
  ///      threshold before (with `by_time`: once enough time is buffered)
  [[nodiscard]] Stored store(const Keyframe& keyframe);
  /// From now on the stream is live, or recorded.
  void set_live(bool live);
  /// The time of a keyframe that has none of its own; 250 ms at first.
  void set_untimed(Milliseconds time) { queue_.set_untimed(time); }
  /// Sets `live_delay`, clamped to its range.
  void set_delay(Milliseconds delay);
  [[nodiscard]] Milliseconds delay() const { return options_.live_delay; }
  /// How many more keyframes the receiver can take.
  [[nodiscard]] std::size_t room() const { return queue_.room(); }
  /// Starts playing with what is buffered, because nothing will come for a while.
  void release() { queue_.fill_playout(); }
  /// Call it at {-2}, or when nothing more will come for another reason: the buffers are played to
  /// the end. Only keyframes that were kept back in case A may still be stored.
  void end_of_stream();

  // === The playback controller's side.

  /// The next keyframe; refills the Playout buffer from the receiver when it runs empty.
  [[nodiscard]] std::optional<Keyframe> take();
  /// True when take() would return a keyframe.
  [[nodiscard]] bool has_next() const { return queue_.playout_fill() > 0; }
  /// True when the stream has ended and everything has been taken.
  [[nodiscard]] bool finished() const { return ended_ && queue_.size() == 0; }

  [[nodiscard]] std::size_t receiver_fill() const { return queue_.receiver_fill(); }
  [[nodiscard]] std::size_t playout_fill() const { return queue_.playout_fill(); }
  /// The sum of the times of the keyframes in both buffers.
  [[nodiscard]] Milliseconds buffered() const { return queue_.time(); }
  /// How many live keyframes were dropped.
  [[nodiscard]] std::uint64_t dropped() const { return dropped_; }

 private:
  /// How much more than wanted() a live stream may buffer while playback is waiting.
  static constexpr Milliseconds kLiveLagMax{2000};
  /// The same with `low_delay`.
  static constexpr Milliseconds kStandingLagMax{100};

  enum class Kind : std::uint8_t { Recorded, RecordedByTime, Live, LiveLowDelay };

  [[nodiscard]] Stored store_recorded(const Keyframe& keyframe);
  void store_live(const Keyframe& keyframe);
  /// Live and waiting: drops what is too old to be played.
  void catch_up();
  /// Live: how much should be buffered while playback is waiting.
  [[nodiscard]] Milliseconds wanted() const;
  /// By time, or live: whether playing may start after a wait.
  [[nodiscard]] bool enough() const;
  /// Live: how much of its `time` the keyframe that has just been taken gets.
  [[nodiscard]] int pace_percent(Milliseconds time) const;
  void drop();

  BufferOptions options_;
  Kind kind_ = Kind::Recorded;
  KeyframeQueue queue_;
  bool waiting_ = true;  ///< take() found nothing, or was not called yet
  bool ended_ = false;
  std::uint64_t dropped_ = 0;
};

}  // namespace aucast::playback

#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>

#include "client/playback/keyframe_source.h"

namespace aucast::playback {

struct BufferOptions {
  static constexpr std::size_t kSetsMax = 10'000;
  static constexpr Milliseconds kDelayMax{60'000};

  std::size_t receiver_capacity = 100;  ///< sets, 1 to kSetsMax
  std::size_t playout_capacity = 30;    ///< sets, 1 to kSetsMax, at most receiver_capacity
  int threshold_percent = 40;           ///< of the receiver buffer, 1-100; for the first fill and
                                        ///< after a stall
  Milliseconds live_delay{300};         ///< live streams wait for this instead, 0 to kDelayMax
  bool by_time = false;                 ///< --buffer auto or Nms: recorded streams wait for
                                        ///< `live_delay` too, and not for the threshold
  bool adapt = false;                   ///< `live_delay` is only the initial value
  bool low_delay = false;               ///< --live: a live keyframe begins as soon as it is there
                                        ///< and is reached at its own Keyframe::due
};

/// The Receiver buffer of --buffer auto and --buffer Nms, in sets: for kDelayMax at 30 a second,
/// and some more.
inline constexpr std::size_t kReceiverSetsByTime = 2000;

/// How many sets must be in the Receiver buffer before the Playout buffer is filled: the
/// threshold's share of it, rounded up.
[[nodiscard]] constexpr std::size_t threshold_of(const BufferOptions& options) {
  return (options.receiver_capacity * static_cast<std::size_t>(options.threshold_percent) + 99) /
         100;
}

/// The Receiver and the Playout buffer of the thesis (5.4.4.1-5.4.4.2, figures 5.12-5.15), first-in
/// first-out, with the gaps of its figures closed: the end of the stream flushes what is below the
/// threshold; a full receiver with an empty playout fills it whatever the threshold; the
/// controller's refill tells the reader that there is room. Invariant: sizes never exceed the
/// capacities; nothing is duplicated or reordered, and nothing of a recorded stream is lost. A live
/// stream is buffered by time: playing starts when two keyframes and `live_delay` are there, or the
/// receiver is full, first and after a stall. A keyframe is played in 95 % of its time if more than
/// `live_delay` plus that time is buffered besides it; with `adapt`, in 105 % if less than
/// `live_delay` minus twice that time is. The oldest keyframe is dropped for each that overflows
/// the receiver and, while playback is waiting, as many as need be once more than `live_delay` +
/// kLiveLagMax is buffered (then down to `live_delay`). store() always takes a live keyframe: there
/// is no case A. With `low_delay` playing starts with one keyframe, and pace_percent stays 100.
/// While playback is waiting, the oldest are dropped once kStandingLagMax more is buffered than the
/// time from the newest one's arrival until it is due, or its own time if it has no due time (then
/// down to that). With `by_time` a recorded stream waits for two keyframes and `live_delay` as
/// well; with `adapt` each stall doubles `live_delay`, up to 10 s. Thread: none of its own; the
/// owner guards it.
class KeyframeBuffers {
 public:
  /// The options must be in their ranges.
  explicit KeyframeBuffers(BufferOptions options);

  // === The AU reader's side.

  /// Whether store() has taken the keyframe.
  enum class Stored : bool { No, Yes };
  /// Stores a keyframe of a recorded stream by the thesis's cases:
  ///   A  receiver full, playing: No. Send -1, keep the keyframe and try again when there is room()
  ///   B  receiver full, playout empty: fills the Playout buffer, then stores
  ///   C  room, playing: stores
  ///   D  room, playout empty: stores, and fills the Playout buffer if the receiver had reached the
  ///      threshold before (with `by_time`: once enough time is buffered)
  /// Playing means that the Playout buffer is not empty.
  [[nodiscard]] Stored store(const Keyframe& keyframe);
  /// From now on the stream is live and `untimed` is the time of a keyframe that has none of its
  /// own; nullopt: the stream is recorded.
  void set_live(std::optional<Milliseconds> untimed);
  /// The time of a recorded keyframe that has none of its own.
  void set_untimed(Milliseconds time) { untimed_ = time; }
  /// Sets `live_delay`, clamped to its range.
  void set_delay(Milliseconds delay);
  [[nodiscard]] Milliseconds delay() const { return options_.live_delay; }
  /// Free places of the receiver.
  [[nodiscard]] std::size_t room() const;
  /// Nothing will come for a while: starts playing with what is buffered.
  void release();
  /// {-2}, or nothing more will come for another reason: the buffers are played to the end. Only
  /// keyframes that case A had kept back may still be stored.
  void end_of_stream();

  // === The playback controller's side.

  /// The next keyframe; refills the Playout buffer from the receiver when it runs empty.
  [[nodiscard]] std::optional<Keyframe> take();
  /// True when take() would return a keyframe.
  [[nodiscard]] bool has_next() const;
  /// True when the stream has ended and everything has been taken.
  [[nodiscard]] bool finished() const;

  [[nodiscard]] std::size_t receiver_fill() const { return keyframes_.size() - playout_; }
  [[nodiscard]] std::size_t playout_fill() const { return playout_; }
  /// The sum of the times of the keyframes in both buffers.
  [[nodiscard]] Milliseconds buffered() const;
  /// How many live keyframes were dropped.
  [[nodiscard]] std::uint64_t dropped() const { return dropped_; }

 private:
  /// What a live stream may buffer beyond wanted() while playback is waiting.
  static constexpr Milliseconds kLiveLagMax{2000};
  /// The same with `low_delay`.
  static constexpr Milliseconds kStandingLagMax{100};

  void store_live(const Keyframe& keyframe);
  void drop_oldest();
  /// Live: how much should be buffered while playback is waiting.
  [[nodiscard]] Milliseconds wanted() const;
  [[nodiscard]] Milliseconds time_of(const Keyframe& keyframe) const;
  [[nodiscard]] bool enough() const;
  void fill_playout();
  void pop_front();

  BufferOptions options_;
  /// Both buffers, so that a keyframe passes from one to the other where it lies.
  std::deque<Keyframe> keyframes_;
  std::size_t playout_ = 0;  ///< of `keyframes_`, from the front; the rest is the receiver's
  bool ended_ = false;
  std::optional<Milliseconds> live_;  ///< the time of an untimed keyframe; nullopt: recorded
  Milliseconds untimed_{250};         ///< the same for recorded streams
  bool starved_ = true;               ///< the player found nothing, so a delay is built up
  bool begun_ = false;                ///< the player has found a keyframe before
  std::uint64_t dropped_ = 0;
};

}  // namespace aucast::playback

#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>

#include "client/playback/keyframe_source.h"

namespace aucast::playback {

struct BufferOptions {
  std::size_t receiver_capacity = 100;  ///< sets, 1-10,000
  std::size_t playout_capacity = 30;    ///< sets, 1-10,000, at most receiver_capacity
  int threshold_percent = 40;           ///< of the receiver buffer, 1-100; for the first fill and
                                        ///< after a stall
  Milliseconds live_delay{300};         ///< live: buffered instead, 0-60,000
  bool by_time = false;                 ///< --buffer auto or Nms: recorded streams wait for
                                        ///< `live_delay` too, and not for the threshold
  bool adapt = false;                   ///< `live_delay` is only where it begins
  bool low_delay = false;               ///< --live: a live keyframe is played as soon as it is
                                        ///< there; when it is due says the keyframe itself
};

/// The Receiver and the Playout buffer of the thesis (5.4.4.1-5.4.4.2, figures 5.12-5.15), first-in
/// first-out, with the gaps of its figures closed: the end of the stream flushes what is below the
/// threshold; a full receiver with an empty playout fills it whatever the threshold; the
/// controller's refill tells the reader that there is room. Invariant: sizes never exceed the
/// capacities; nothing is lost, doubled or reordered; keyframes leave in the order in which they
/// came.
/// A live stream is buffered by time: playing starts when two keyframes and `live_delay` are there,
/// first and after a stall. With more in the buffer it plays up to 5 % faster, with less up to 5 %
/// slower. While it plays no keyframe is dropped; while it waits, the oldest are dropped beyond
/// kLiveLagMax or when there is no room. A live source is never paused, so there is no case A.
/// With `low_delay` playing starts with one keyframe, and while it waits the oldest are dropped
/// beyond kStandingLagMax more than what is due.
/// With `by_time` a recorded stream begins after `live_delay` as well; with `adapt` each stall
/// doubles that for the next time.
/// Thread: none of its own; the owner guards it.
class KeyframeBuffers {
 public:
  /// The options must be in their ranges.
  explicit KeyframeBuffers(BufferOptions options);

  // === The AU reader's side.

  /// Cases A-D: what to tell the server after a packet.
  enum class Stored : bool { No, Yes };
  /// Stores a keyframe and, where the case says so, fills the Playout buffer: B (receiver full,
  /// playout empty), C (room, playing), D (room, playout empty: fill when the threshold is
  /// reached). No means case A: both are full; send -1, keep the keyframe and try again after
  /// room().
  [[nodiscard]] Stored store(const TimedAus& keyframe);
  /// From now on the stream is live, with this time for a keyframe that has none of its own; or,
  /// without one, it is recorded.
  void set_live(std::optional<Milliseconds> untimed);
  /// The time of a recorded keyframe that has none of its own.
  void set_untimed(Milliseconds time) { untimed_ = time; }
  /// From now on so much is buffered.
  void set_delay(Milliseconds delay);
  [[nodiscard]] Milliseconds delay() const { return options_.live_delay; }
  /// Free places of the receiver.
  [[nodiscard]] std::size_t room() const;
  /// Nothing will come for a while: start playing with what is there.
  void release();
  /// {-2}, or nothing more will come for another reason: what is there is played to the end. Only
  /// keyframes that case A had kept back may still be stored.
  void end_of_stream();

  // === The playback controller's side.

  /// The next keyframe; refills the Playout buffer from the receiver when it runs empty.
  [[nodiscard]] std::optional<TimedAus> take();
  /// True when take() would give one.
  [[nodiscard]] bool has_next() const;
  /// True when the stream has ended and everything has been taken.
  [[nodiscard]] bool finished() const;

  [[nodiscard]] std::size_t receiver_fill() const { return keyframes_.size() - playout_; }
  [[nodiscard]] std::size_t playout_fill() const { return playout_; }
  /// What is there, in the stream's own time.
  [[nodiscard]] Milliseconds buffered() const;
  /// Live keyframes that were dropped to catch up.
  [[nodiscard]] std::uint64_t dropped() const { return dropped_; }

 private:
  /// Beyond `live_delay`: so much more and the oldest keyframes are dropped.
  static constexpr Milliseconds kLiveLagMax{2000};
  /// Low delay: beyond what the newest is due in.
  static constexpr Milliseconds kStandingLagMax{100};

  void store_live(const TimedAus& keyframe);
  void drop_oldest();
  /// Live: how much should be buffered.
  [[nodiscard]] Milliseconds wanted() const;
  [[nodiscard]] Milliseconds time_of(const TimedAus& keyframe) const;
  [[nodiscard]] bool enough() const;
  void fill_playout();
  void pop_front();
  /// How many sets the receiver must hold before the Playout buffer is filled for the first time or
  /// after a stall; at least 1.
  [[nodiscard]] std::size_t threshold() const;

  BufferOptions options_;
  /// Both buffers, so that a keyframe passes from one to the other where it lies.
  std::deque<TimedAus> keyframes_;
  std::size_t playout_ = 0;  ///< of `keyframes_`, from the front; the rest is the receiver's
  bool ended_ = false;
  std::optional<Milliseconds> live_;  ///< the time of an untimed keyframe
  Milliseconds untimed_{250};         ///< the same for recorded streams
  bool starved_ = true;               ///< the player found nothing, so a delay is built up
  bool begun_ = false;                ///< it has found something before
  std::uint64_t dropped_ = 0;
};

}  // namespace aucast::playback

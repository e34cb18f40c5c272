#pragma once

#include <cstddef>
#include <deque>
#include <optional>

#include "client/playback/keyframe_source.h"

namespace aucast::playback {

struct BufferOptions {
  std::size_t receiver_capacity = 100;  ///< sets, 1-10,000
  std::size_t playout_capacity = 30;    ///< sets, 1-10,000, at most receiver_capacity
  int threshold_percent = 40;           ///< of the receiver buffer, 1-100; for the first fill and
                                        ///< after a stall
};

/// The Receiver and the Playout buffer of the thesis (5.4.4.1-5.4.4.2, figures 5.12-5.15), first-in
/// first-out, with the gaps of its figures closed: the end of the stream flushes what is below the
/// threshold; a full receiver with an empty playout fills it whatever the threshold; the
/// controller's refill tells the reader that there is room. Invariant: sizes never exceed the
/// capacities; nothing is lost, doubled or reordered; keyframes leave in the order in which they
/// came. Thread: none of its own; the owner guards it.
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
  /// Free places of the receiver.
  [[nodiscard]] std::size_t room() const;
  /// The sender had to be held back although the threshold is not reached (a window needs more room
  /// than there is): start playing with what is there.
  void release();
  /// {-2}, or nothing more will come for another reason: what is there is played to the end. Only
  /// a keyframe that case A had kept back may still be stored.
  void end_of_stream();

  // === The playback controller's side.

  /// The next keyframe; refills the Playout buffer from the receiver when it runs empty.
  [[nodiscard]] std::optional<TimedAus> take();
  /// True when take() would give one.
  [[nodiscard]] bool has_next() const;
  /// True when the stream has ended and everything has been taken.
  [[nodiscard]] bool finished() const;

  [[nodiscard]] std::size_t receiver_fill() const { return receiver_.size(); }
  [[nodiscard]] std::size_t playout_fill() const { return playout_.size(); }

 private:
  void fill_playout();
  /// How many sets the receiver must hold before the Playout buffer is filled for the first time or
  /// after a stall; at least 1.
  [[nodiscard]] std::size_t threshold() const;

  BufferOptions options_;
  std::deque<TimedAus> receiver_;
  std::deque<TimedAus> playout_;
  bool ended_ = false;
};

}  // namespace aucast::playback

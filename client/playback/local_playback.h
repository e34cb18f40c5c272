#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "common/time.h"

namespace aucast::playback {

/// Where a moment of a stream lies: `mu` in [0,1] of the way to the face of `keyframe`.
struct StreamPlace {
  std::size_t keyframe = 0;  ///< counts from 0
  double mu = 0;
  friend bool operator==(const StreamPlace&, const StreamPlace&) = default;
};

/// The position in a stream that is available whole: play, pause, seek, steps, speed and a loop
/// between two marks. The position is a function of the times that are handed in and of nothing
/// else, so it does not depend on how often it is asked for. The times must not go back.
class LocalPlayback {
 public:
  static constexpr int kSpeedMin = 10;  ///< percent
  static constexpr int kSpeedMax = 1000;
  /// Percent, ascending: the speeds that are offered, and that one step faster or slower leads to.
  static constexpr std::array kSpeeds = {10, 25, 50, 75, 100, 125, 150, 200, 300, 500, 1000};

  /// The time of each keyframe, none negative; at least one. Stands at the beginning, paused.
  explicit LocalPlayback(const std::vector<Milliseconds>& times);

  [[nodiscard]] Duration total() const { return ends_.back(); }
  /// When each keyframe is reached, ascending.
  [[nodiscard]] const std::vector<Duration>& ends() const { return ends_; }
  /// Between 0 and total().
  [[nodiscard]] Duration position(Instant now) const;
  /// The keyframe under way at a position; where one ends and the next begins, the one that ends.
  [[nodiscard]] StreamPlace place(Duration position) const;
  /// The clock runs; also true at the end until somebody pauses.
  [[nodiscard]] bool playing() const { return playing_; }
  /// Has played to the end.
  [[nodiscard]] bool over(Instant now) const { return playing_ && position(now) == total(); }
  [[nodiscard]] int speed_percent() const { return speed_percent_; }
  [[nodiscard]] std::optional<Duration> loop_begin() const { return loop_begin_; }
  [[nodiscard]] std::optional<Duration> loop_end() const { return loop_end_; }
  [[nodiscard]] bool repeats() const { return repeats_; }

  /// From the end it plays from the beginning.
  void play(Instant now);
  void pause(Instant now);
  /// Goes to a position, clamped to the stream; keeps playing, or not, as before. What has played
  /// to its end stands there; seeking to the end and back, as in a drag, plays on.
  void seek(Duration position, Instant now);
  /// Goes to the next keyframe's end (+1) or the previous one's (-1), and stays there.
  void step_keyframe(int direction, Instant now);
  /// The same by the pictures of a film of the stream, `fps` a second from its beginning; its end
  /// is the last one.
  void step_frame(int direction, int fps, Instant now);
  /// Clamped to the limits.
  void set_speed(int percent, Instant now);
  /// To the next of the usual speeds, up (+1) or down (-1).
  void change_speed(int direction, Instant now);
  /// First A, then B, then none: the marks of a loop, at the position of `now`.
  void mark_loop(Instant now);
  /// At the end it begins anew. A loop between two marks comes first.
  void set_repeat(bool repeats, Instant now);

  /// Keyframes reached by playing, and the sum of their times; rounds of a loop count.
  [[nodiscard]] std::uint64_t keyframes_played(Instant now) const;
  [[nodiscard]] Duration media_time(Instant now) const;

 private:
  struct Passed {
    std::uint64_t keyframes = 0;
    Duration time{0};
  };

  struct Loop {
    Duration begin{0};
    Duration end{0};
  };
  /// The part that is played again and again from the anchor on.
  [[nodiscard]] std::optional<Loop> loop() const;
  /// Stream time since the anchor, as if there were no end and no loop.
  [[nodiscard]] Duration run(Instant now) const;
  [[nodiscard]] Passed passed(Instant now) const;
  [[nodiscard]] Passed between(Duration from, Duration to) const;
  /// From here on the position is counted from `position` at `now`.
  void anchor(Duration position, Instant now);

  std::vector<Duration> ends_;
  bool playing_ = false;
  int speed_percent_ = 100;
  Instant anchor_at_{};
  Duration anchor_position_{0};
  std::optional<Duration> loop_begin_;
  std::optional<Duration> loop_end_;
  bool repeats_ = false;
  Passed passed_before_;  ///< up to the anchor
};

}  // namespace aucast::playback

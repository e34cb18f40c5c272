#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "common/time.h"

namespace aucast::playback {

/// A position in a stream by keyframe: the fraction `mu` in [0,1] of the way to the face of
/// `keyframe`.
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
  /// The speeds that are offered, in percent, ascending. change_speed() goes from one to the next.
  static constexpr std::array kSpeeds = {10, 25, 50, 75, 100, 125, 150, 200, 300, 500, 1000};

  /// `times`: the time of each keyframe, at least one, none negative. Begins paused, at position 0.
  explicit LocalPlayback(const std::vector<Milliseconds>& times);

  [[nodiscard]] Duration total() const { return ends_.back(); }
  /// When each keyframe is reached, ascending.
  [[nodiscard]] const std::vector<Duration>& ends() const { return ends_; }
  /// In [0, total()].
  [[nodiscard]] Duration position(Instant now) const;
  /// The keyframe under way at a position; where one ends and the next begins, the one that ends.
  [[nodiscard]] StreamPlace place(Duration position) const;
  /// If the keyframes are pictures at a steady rate of 10 a second or more, as of a camera, the
  /// time of one picture. Some may be missing. Nullopt: the keyframes are no pictures of a film.
  [[nodiscard]] std::optional<Duration> picture_time() const { return picture_time_; }
  /// Whether the clock runs. Stays true at the end until pause().
  [[nodiscard]] bool playing() const { return playing_; }
  /// Whether it has played to the end.
  [[nodiscard]] bool over(Instant now) const { return playing_ && position(now) == total(); }
  [[nodiscard]] int speed_percent() const { return speed_percent_; }
  [[nodiscard]] std::optional<Duration> loop_begin() const { return loop_begin_; }
  [[nodiscard]] std::optional<Duration> loop_end() const { return loop_end_; }
  [[nodiscard]] bool repeats() const { return repeats_; }

  /// Plays on; at the end, from the beginning.
  void play(Instant now);
  void pause(Instant now);
  /// Goes to a position, clamped to the stream, and keeps playing or stays paused as before. If the
  /// stream had played to its end, it is paused from now on. If the end was only reached by
  /// seeking, as in a drag, it plays on once it is sought back.
  void seek(Duration position, Instant now);
  /// Goes to the next keyframe's end (+1) or the previous one's (-1), and stays there.
  void step_keyframe(int direction, Instant now);
  /// Steps likewise by the pictures that a video of the stream would have, `fps` a second from the
  /// stream's beginning. The stream's end counts as the last picture.
  void step_at_rate(int direction, int fps, Instant now);
  /// Steps likewise by the pictures of the source; there must be a picture_time(). Each keyframe is
  /// a picture; where pictures are missing, steps are as long as elsewhere.
  void step_picture(int direction, Instant now);
  /// Clamped to kSpeedMin and kSpeedMax.
  void set_speed(int percent, Instant now);
  /// Goes to the next of kSpeeds, up (+1) or down (-1).
  void change_speed(int direction, Instant now);
  /// Sets the marks of a loop at the position of `now`: first A, then B, which may be before A; the
  /// third call removes both.
  void mark_loop(Instant now);
  /// Sets whether playing begins anew at the end. A loop between two marks takes precedence.
  void set_repeat(bool repeats, Instant now);

  /// Keyframes reached by playing, and the sum of their times. All rounds of a loop count.
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
  /// The part that is repeated when playing on from the anchor; nullopt: none.
  [[nodiscard]] std::optional<Loop> loop() const;
  /// Stream time since the anchor, as if there were no end and no loop.
  [[nodiscard]] Duration run(Instant now) const;
  [[nodiscard]] Passed passed(Instant now) const;
  [[nodiscard]] Passed between(Duration from, Duration to) const;
  /// The next place to step to, and the one before, for step_picture().
  [[nodiscard]] Duration picture_after(Duration position) const;
  [[nodiscard]] Duration picture_before(Duration position) const;
  /// Whether it is over, and came to the end by playing, not by being sought there.
  [[nodiscard]] bool played_to_end(Instant now) const;
  /// From now on the position is counted from `position` at `now`.
  void anchor(Duration position, Instant now);

  std::vector<Duration> ends_;
  std::optional<Duration> picture_time_;
  bool playing_ = false;
  int speed_percent_ = 100;
  Instant anchor_at_{};
  Duration anchor_position_{0};
  bool ended_ = false;  ///< the anchor is where playing came to the end
  std::optional<Duration> loop_begin_;
  std::optional<Duration> loop_end_;
  bool repeats_ = false;
  Passed passed_before_;  ///< what was played before the anchor
};

}  // namespace aucast::playback

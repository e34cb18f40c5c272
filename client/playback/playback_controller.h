#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "client/playback/delay_meter.h"
#include "client/playback/keyframe_source.h"
#include "client/playback/movement.h"
#include "client/playback/passing.h"
#include "common/time.h"

namespace aucast::playback {

enum class PlaybackState : std::uint8_t {
  Buffering,  ///< nothing has been played yet, the first keyframe is awaited
  Playing,
  Stalled,  ///< both buffers ran empty before the end: the clock waits, the face holds
  Stale,    ///< a stall lasted too long: the face eases to neutral and waits there
  Paused,   ///< by the user
  Ended,    ///< the stream has ended, and position 50 of its last keyframe is reached
  Stopped,  ///< the user left
  Lost,     ///< all that came is played, and the stream was cut short: connection lost, protocol
            ///< error, server unreachable or refusing; the face holds and eases as in Stale
};

[[nodiscard]] std::string_view name(PlaybackState state);

/// Whether `state` is Ended, Stopped or Lost: nothing moves any more, except that in Lost the face
/// eases to neutral.
[[nodiscard]] bool is_over(PlaybackState state);

/// A keyframe that has just begun: the face goes from where it is to `target`.
struct KeyframeBegun {
  Keyframe target;
  Milliseconds time{0};  ///< its own time: as it was sent, else --speed, else the server's
                         ///< default. A live keyframe may in fact take 5 % more or less
  /// How much of what came before was played, in [0,1]. Keyframes are played whole; only an easing
  /// to neutral may be interrupted.
  double cut_at = 1;
  std::optional<AuFrame> from{};  ///< the face begins from these AUs; nullopt: from where it is
};

/// How far playback has come.
struct PlaybackProgress {
  std::uint64_t keyframe = 0;  ///< counts from 1; 0 before the first
  int position = 0;  ///< the last position k of the current keyframe that was reached, 0..50
  double mu = 0;     ///< exact fraction in [0,1] of the current keyframe
};

/// The playback controller of the thesis (figure 5.15): decides when each keyframe begins and how
/// far the face has come towards it, on a clock that is handed in and must not go back. Each
/// keyframe begins at the exact time at which the previous one ended, and from the face that it
/// reached, so that nothing drifts: N keyframes take the sum of their times. After a stall the
/// clock starts anew. A keyframe of 0 ms is a jump: it ends as soon as it begins. A live keyframe
/// with a due time lasts until that time, but at least 95 % and at most 105 % of its own time
/// (99.5 % and 100.5 % while a voice is heard). If such a keyframe comes after a stall, it is taken
/// to begin when it arrived or at the previous call of advance(), whichever is later.
/// Thread: the player's.
class PlaybackController {
 public:
  /// The longest time that --speed gives a keyframe.
  static constexpr Milliseconds kSpeedMax{1000};

  /// `speed`: --speed, 1 ms to kSpeedMax; nullopt: the server's default for keyframes without a
  /// time.
  explicit PlaybackController(std::optional<Milliseconds> speed);

  /// Moves to `now`. If a keyframe begins, it is returned: bring the face to the end of the
  /// previous one, then begin this one. Call again with the same `now` until nullopt is returned,
  /// because short keyframes may have ended already. The easing to neutral is returned as a
  /// keyframe too, but keyframes_played() leaves it out.
  [[nodiscard]] std::optional<KeyframeBegun> advance(Instant now, KeyframeSource& source);

  /// Once a stall or a loss has lasted for `hold`, the face eases to neutral within kEaseTime. By
  /// default it never does.
  void set_hold(Milliseconds hold) { hold_ = hold; }
  static constexpr Milliseconds kEaseTime{1000};
  /// The times handed in are those of a video clock, unrelated to arrivals: every keyframe takes
  /// its own time, live or not, and no delay is measured.
  void set_video_clock() { video_clock_ = true; }
  /// As Playback::set_clock().
  void set_clock(Duration ahead, Duration lead) {
    ahead_ = ahead;
    lead_ = lead;
  }
  /// Whether the face has left the last keyframe for neutral.
  [[nodiscard]] bool eased() const { return wait_.easing.has_value(); }
  /// After a keyframe with a due time, a shorter wait than this is no stall, because nobody sees
  /// it.
  static constexpr Milliseconds kStallMin{20};

  [[nodiscard]] PlaybackState state() const;
  /// is_over(state()).
  [[nodiscard]] bool over() const { return is_over(state_); }
  [[nodiscard]] PlaybackProgress progress() const { return progress_; }
  /// As Playback::passing().
  [[nodiscard]] std::optional<Passing> passing() const;
  /// When the next position of the current keyframe, or of the easing, is reached; nullopt while
  /// nothing moves.
  [[nodiscard]] std::optional<Instant> next_position_at() const;

  /// The user pauses: the face stays where it is at `now`. Has no effect when paused already or
  /// over().
  void pause(Instant now);
  /// Goes on from where it was paused. Has no effect when not paused.
  void resume(Instant now);
  /// The user leaves: the face stays at the position reached at `now`. Has no effect when over().
  void stop(Instant now);

  /// Those played to their end.
  [[nodiscard]] std::uint64_t keyframes_played() const { return keyframes_played_; }
  [[nodiscard]] std::uint64_t stalls() const { return stalls_; }
  /// Live: the time from the arrival of each keyframe to the advance() that found it fully reached.
  [[nodiscard]] const DelayMeter& delays() const { return delays_; }
  /// Live: the time from the arrival of a keyframe to its due time, for those that have one.
  [[nodiscard]] const DelayMeter& delays_meant() const { return delays_meant_; }
  /// Sum of the times of the keyframes played.
  [[nodiscard]] Milliseconds media_time() const { return media_time_; }

 private:
  /// A wait for the next keyframe, after the first one.
  struct Wait {
    Instant since{};
    bool counted = false;              ///< it is long enough to be seen, and counted as a stall
    std::optional<Movement> easing{};  ///< to neutral
  };

  void stand(Instant now);
  void move();
  /// Begins the next keyframe at `latest`, or, if it has a due time, when it arrived, but not
  /// before `earliest`. If there is none, sets the state that follows from that.
  [[nodiscard]] std::optional<KeyframeBegun> begin_next(Instant earliest, Instant latest,
                                                        KeyframeSource& source);
  void wait_for_next(std::optional<EndReason> end);
  [[nodiscard]] std::optional<KeyframeBegun> hold_or_ease();
  void count_stall();
  void finish_keyframe();

  std::optional<Milliseconds> speed_;
  std::optional<Milliseconds> hold_;
  bool video_clock_ = false;
  Duration ahead_{0};
  Duration lead_{0};

  PlaybackState state_ = PlaybackState::Buffering;  ///< never Paused
  bool paused_ = false;                             ///< only while not over()
  Instant now_{};          ///< how far the clock has come; it stands while paused, and in Stopped
  KeyframeBegun current_;  ///< the keyframe under way, or the last one; it arrived and is due by
                           ///< the clock handed in
  Movement movement_;      ///< to current_
  Wait wait_;              ///< what it was in Stalled, Stale or Lost, until a keyframe begins
  PlaybackProgress progress_;  ///< of wait_.easing if there is one, else of movement_

  std::uint64_t keyframes_played_ = 0;
  std::uint64_t stalls_ = 0;
  Milliseconds media_time_{0};
  DelayMeter delays_;
  DelayMeter delays_meant_;
};

}  // namespace aucast::playback

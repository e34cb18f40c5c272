#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "client/playback/delay_meter.h"
#include "client/playback/keyframe_source.h"
#include "client/playback/movement.h"
#include "client/playback/passing.h"
#include "client/playback/playback.h"
#include "common/time.h"

namespace aucast::playback {

/// The playback controller of the thesis (figure 5.15): decides when each keyframe of a source
/// begins and how far the face has come towards it. Each keyframe begins at the exact time at which
/// the previous one ended, and from the face that it reached, so that nothing drifts: N keyframes
/// take the sum of their times. After a stall the clock starts anew. A keyframe of 0 ms is a jump:
/// it ends as soon as it begins. A live keyframe with a due time lasts until that time, but at
/// least 95 % and at most 105 % of its own time (99.5 % and 100.5 % while a voice is heard). If
/// such a keyframe comes after a stall, it is taken to begin when it arrived or at the previous
/// call of advance(), whichever is later.
/// Thread: the player's.
class SourcePlayback final : public Playback {
 public:
  /// The longest time that --speed gives a keyframe.
  static constexpr Milliseconds kSpeedMax{1000};
  static constexpr Milliseconds kEaseTime{1000};
  /// The usual Options::hold.
  static constexpr Milliseconds kHold{5000};
  /// After a keyframe with a due time, a shorter wait than this is no stall, because nobody sees
  /// it.
  static constexpr Milliseconds kStallMin{20};

  struct Options {
    std::optional<Milliseconds> speed{};  ///< the time of a keyframe that has none of its own, 1 ms
                                          ///< to kSpeedMax; nullopt: the server's default
    std::optional<Milliseconds> hold{};   ///< how long a stall or a loss lasts until the face eases
                                          ///< to neutral within kEaseTime; nullopt: it never does
    bool video_clock = false;  ///< the times handed in are unrelated to arrivals: every keyframe
                               ///< takes its own time, live or not, and no delay is measured
  };
  SourcePlayback(std::unique_ptr<KeyframeSource> source, const Options& options);

  /// The easing to neutral is returned as a keyframe too, but keyframes_played() leaves it out.
  [[nodiscard]] std::optional<KeyframeBegun> advance(Instant now) override;
  /// Once over(), these three move nothing; nor does a second pause, or a resume without one.
  void pause(Instant now) override;
  void resume(Instant now) override;
  void stop(Instant now) override;
  [[nodiscard]] PlaybackState state() const override;
  [[nodiscard]] PlaybackProgress progress() const override { return progress_; }
  [[nodiscard]] bool eased() const override { return wait_.easing.has_value(); }
  [[nodiscard]] std::optional<Instant> next_position_at() const override;
  [[nodiscard]] std::optional<Passing> passing() const override;
  [[nodiscard]] std::optional<Voice> take_voice() override { return source_->take_voice(); }
  [[nodiscard]] std::optional<Caption> take_caption() override { return source_->take_caption(); }
  void set_clock(Duration ahead, Duration lead) override;
  [[nodiscard]] std::uint64_t keyframes_played() const override { return keyframes_played_; }
  [[nodiscard]] Duration media_time() const override { return media_time_; }
  [[nodiscard]] std::uint64_t stalls() const override { return stalls_; }
  [[nodiscard]] const DelayMeter& delays() const override { return delays_; }
  [[nodiscard]] const DelayMeter& delays_meant() const override { return delays_meant_; }
  [[nodiscard]] SourceStatus status() const override { return source_->status(); }
  bool wait_until(Instant until) override { return source_->wait_until(until); }

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
  /// before `earliest`. After a keyframe both are its end, so that no time is lost; out of a stall
  /// it may have arrived since the last advance(). If there is none, sets the state that follows
  /// from that.
  [[nodiscard]] std::optional<KeyframeBegun> begin_next(Instant earliest, Instant latest);
  void wait_for_next(std::optional<EndReason> end);
  [[nodiscard]] std::optional<KeyframeBegun> hold_or_ease();
  void count_stall();
  void finish_keyframe();

  std::unique_ptr<KeyframeSource> source_;
  Options options_;
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

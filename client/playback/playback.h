#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "client/playback/delay_meter.h"
#include "client/playback/keyframe_source.h"
#include "client/playback/passing.h"
#include "client/playback/playback_controller.h"

namespace aucast::playback {

class SeekablePlayback;

/// Decides which keyframe the face is on its way to, and how far it has come. Time is handed in and
/// must not go back; where there is sound, sound::SoundPlayer gives the time. Two kinds:
/// SourcePlayback plays what a source gives as it comes, SeekablePlayback plays a stream that is
/// available whole, at any place and speed.
/// Thread: none of its own.
class Playback {
 public:
  Playback() = default;
  virtual ~Playback() = default;
  Playback(const Playback&) = delete;
  Playback& operator=(const Playback&) = delete;

  /// Moves to `now`. If a keyframe begins, it is returned; call again with the same `now` until
  /// nullopt is returned.
  [[nodiscard]] virtual std::optional<KeyframeBegun> advance(Instant now) = 0;
  /// The face stays where it is at `now` until resume().
  virtual void pause(Instant now) = 0;
  virtual void resume(Instant now) = 0;
  /// The user leaves: no keyframe begins any more, and the face stays where it is at `now`.
  virtual void stop(Instant now) = 0;

  [[nodiscard]] virtual PlaybackState state() const = 0;
  /// True in Ended, Stopped and Lost.
  [[nodiscard]] bool over() const { return is_over(state()); }
  /// As of the last advance().
  [[nodiscard]] virtual PlaybackProgress progress() const = 0;
  /// Whether the face has left the last keyframe for neutral, because nothing has come for a long
  /// time.
  [[nodiscard]] virtual bool eased() const { return false; }
  /// When to call advance() next for a face that has moved visibly; nullopt if the face does not
  /// move.
  [[nodiscard]] virtual std::optional<Instant> next_position_at() const = 0;
  /// Where playing is, as of the last advance(). After the end the place goes on, for sound that
  /// lasts longer than the face. Nullopt if no places are known.
  [[nodiscard]] virtual std::optional<Passing> passing() const = 0;
  /// As KeyframeSource's functions of these names.
  [[nodiscard]] virtual std::optional<Voice> take_voice() { return std::nullopt; }
  [[nodiscard]] virtual std::optional<Caption> take_caption() { return std::nullopt; }
  /// Says that the times handed in from now on are `ahead` of the steady clock, and that a face is
  /// shown `lead` after its time was handed in. Both are zero before the first call.
  virtual void set_clock(Duration /*ahead*/, Duration /*lead*/) {}
  /// How many keyframes were played to their end, as of the last advance().
  [[nodiscard]] virtual std::uint64_t keyframes_played() const = 0;
  /// The sum of their times.
  [[nodiscard]] virtual Duration media_time() const = 0;
  [[nodiscard]] virtual std::uint64_t stalls() const { return 0; }
  /// How long live keyframes took from their arrival until they were reached.
  [[nodiscard]] virtual const DelayMeter& delays() const;
  /// How long live keyframes with a due time were meant to take until they were reached.
  [[nodiscard]] virtual const DelayMeter& delays_meant() const;
  /// Blocks until advance() may find a keyframe, or until `until`. Returns true in the first case.
  virtual bool wait_until(Instant /*until*/) { return true; }
  /// The status of what gives the keyframes.
  [[nodiscard]] virtual SourceStatus status() const = 0;
  /// This object, if it can seek; else null.
  [[nodiscard]] virtual SeekablePlayback* seekable() { return nullptr; }
};

/// Plays a source by a PlaybackController.
class SourcePlayback final : public Playback {
 public:
  struct Options {
    std::optional<Milliseconds> speed{};  ///< the time of a keyframe that has none of its own;
                                          ///< nullopt: the server's default
    std::optional<Milliseconds> hold{};   ///< PlaybackController::set_hold()
    bool video_clock = false;             ///< PlaybackController::set_video_clock()
  };
  SourcePlayback(std::unique_ptr<KeyframeSource> source, const Options& options);

  [[nodiscard]] std::optional<KeyframeBegun> advance(Instant now) override {
    return controller_.advance(now, *source_);
  }
  void pause(Instant now) override;
  void resume(Instant now) override;
  void stop(Instant now) override;
  [[nodiscard]] PlaybackState state() const override { return controller_.state(); }
  [[nodiscard]] PlaybackProgress progress() const override { return controller_.progress(); }
  [[nodiscard]] bool eased() const override { return controller_.eased(); }
  [[nodiscard]] std::optional<Instant> next_position_at() const override {
    return controller_.next_position_at();
  }
  [[nodiscard]] std::optional<Passing> passing() const override { return controller_.passing(); }
  [[nodiscard]] std::optional<Voice> take_voice() override { return source_->take_voice(); }
  [[nodiscard]] std::optional<Caption> take_caption() override { return source_->take_caption(); }
  void set_clock(Duration ahead, Duration lead) override { controller_.set_clock(ahead, lead); }
  [[nodiscard]] std::uint64_t keyframes_played() const override {
    return controller_.keyframes_played();
  }
  [[nodiscard]] Duration media_time() const override { return controller_.media_time(); }
  [[nodiscard]] std::uint64_t stalls() const override { return controller_.stalls(); }
  [[nodiscard]] const DelayMeter& delays() const override { return controller_.delays(); }
  [[nodiscard]] const DelayMeter& delays_meant() const override {
    return controller_.delays_meant();
  }
  [[nodiscard]] SourceStatus status() const override { return source_->status(); }
  bool wait_until(Instant until) override { return source_->wait_until(until); }

 private:
  std::unique_ptr<KeyframeSource> source_;
  PlaybackController controller_;
};

}  // namespace aucast::playback

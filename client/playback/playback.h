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

/// Which keyframe the face is on its way to, and how far. Time is handed in and must not go back;
/// where there is sound, what is handed in is the time of the place that is being heard. Two kinds:
/// SourcePlayback plays what a source gives as it comes, SeekablePlayback plays a stream that is
/// available whole, at any place and speed.
/// Thread: none of its own.
class Playback {
 public:
  Playback() = default;
  virtual ~Playback() = default;
  Playback(const Playback&) = delete;
  Playback& operator=(const Playback&) = delete;

  /// Moves to `now`. When a keyframe begins it is returned; call again with the same `now` until
  /// nothing is returned.
  [[nodiscard]] virtual std::optional<KeyframeBegun> advance(Instant now) = 0;
  /// The face stays where it is at `now` until resume().
  virtual void pause(Instant now) = 0;
  virtual void resume(Instant now) = 0;
  /// The user leaves: no keyframe begins any more, and the face stays where it is at `now`.
  virtual void stop(Instant now) = 0;

  [[nodiscard]] virtual PlaybackState state() const = 0;
  /// True in Ended, Stopped and Lost.
  [[nodiscard]] bool over() const { return is_over(state()); }
  /// Of the last advance().
  [[nodiscard]] virtual PlaybackProgress progress() const = 0;
  /// Nothing has come for a long time: the face has left the last keyframe for neutral.
  [[nodiscard]] virtual bool eased() const { return false; }
  /// When the face should be looked at again; nullopt when it stands still.
  [[nodiscard]] virtual std::optional<Instant> next_position_at() const = 0;
  /// Where playing is, as of the last advance(). After the end it goes on, for sound that lasts
  /// longer than the face. Nothing where no places are known.
  [[nodiscard]] virtual std::optional<Passing> passing() const = 0;
  /// KeyframeSource's.
  [[nodiscard]] virtual std::optional<Voice> take_voice() { return std::nullopt; }
  [[nodiscard]] virtual std::optional<Caption> take_caption() { return std::nullopt; }
  /// The times handed in are `ahead` of those of the steady clock, and their face is shown
  /// `lead` later. Zero until then.
  virtual void set_clock(Duration /*ahead*/, Duration /*lead*/) {}
  /// Whole ones, as of the last advance().
  [[nodiscard]] virtual std::uint64_t keyframes_played() const = 0;
  /// The sum of their times.
  [[nodiscard]] virtual Duration media_time() const = 0;
  [[nodiscard]] virtual std::uint64_t stalls() const { return 0; }
  /// How long live keyframes took from their arrival until they were reached.
  [[nodiscard]] virtual const DelayMeter& delays() const;
  /// The same delay as intended, for keyframes that had a due time.
  [[nodiscard]] virtual const DelayMeter& delays_meant() const;
  /// Waits until advance() may find something or until `until`, whichever is first; true when it
  /// may.
  virtual bool wait_until(Instant /*until*/) { return true; }
  /// Of what gives the keyframes.
  [[nodiscard]] virtual SourceStatus status() const = 0;
  /// This object, if it can seek; else null.
  [[nodiscard]] virtual SeekablePlayback* seekable() { return nullptr; }
};

/// Plays a source by a PlaybackController.
class SourcePlayback final : public Playback {
 public:
  struct Options {
    std::optional<Milliseconds> speed{};  ///< of a keyframe without a time of its own; nothing: the
                                          ///< server's
    std::optional<Milliseconds> hold{};   ///< PlaybackController::set_hold()
    bool film_clock = false;              ///< PlaybackController::set_film_clock()
  };
  SourcePlayback(std::unique_ptr<KeyframeSource> source, const Options& options);

  [[nodiscard]] std::optional<KeyframeBegun> advance(Instant now) override;
  void pause(Instant now) override;
  void resume(Instant now) override;
  void stop(Instant now) override;
  [[nodiscard]] PlaybackState state() const override { return controller_.state(); }
  [[nodiscard]] PlaybackProgress progress() const override { return controller_.progress(); }
  [[nodiscard]] bool eased() const override { return controller_.eased(); }
  [[nodiscard]] std::optional<Instant> next_position_at() const override;
  [[nodiscard]] std::optional<Passing> passing() const override { return controller_.passing(); }
  [[nodiscard]] std::optional<Voice> take_voice() override { return source_->take_voice(); }
  [[nodiscard]] std::optional<Caption> take_caption() override { return source_->take_caption(); }
  void set_clock(Duration ahead, Duration lead) override { controller_.set_clock(ahead, lead); }
  [[nodiscard]] std::uint64_t keyframes_played() const override;
  [[nodiscard]] Duration media_time() const override;
  [[nodiscard]] std::uint64_t stalls() const override;
  [[nodiscard]] const DelayMeter& delays() const override;
  [[nodiscard]] const DelayMeter& delays_meant() const override;
  [[nodiscard]] SourceStatus status() const override { return source_->status(); }
  bool wait_until(Instant until) override { return source_->wait_until(until); }

 private:
  std::unique_ptr<KeyframeSource> source_;
  PlaybackController controller_;
};

}  // namespace aucast::playback

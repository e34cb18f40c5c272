#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "client/playback/playback.h"
#include "client/sound/heard_line.h"
#include "client/sound/shift_meter.h"
#include "client/sound/sound_mixer.h"
#include "client/sound/sound_out.h"
#include "client/sound/voice_track.h"
#include "common/time.h"

namespace aucast::sound {

/// What --stats tells of sound.
struct SoundCounts {
  VoiceTrack::Counts voice;
  std::uint64_t underruns = 0;        ///< times that the device ran out of sound
  std::optional<double> drift_ppm{};  ///< what the device's clock gains on the steady clock, in
                                      ///< parts of a million; nothing if it has not run for 10 s
  ShiftSummary shift;                 ///< of the face from the sound that is heard
};

/// Plays the sound of a playback and tells the time by what is heard of it. Playback is advanced to
/// now(), which is ahead of what is heard by lead(), so that the sound of what it does is written
/// in time; the face of shown() is the one that belongs to the sound that is being heard. While
/// there is no sound both go on with the steady clock from where they were. Neither ever goes back.
/// The lead is kLeadMin, and kLeadStep more with each time that the device ran out of sound, up to
/// kLeadMax. A device that is lost, or that plays nothing for kDeafMax, is given up.
/// Thread: the player's.
class SoundPlayer {
 public:
  static constexpr Milliseconds kLeadMin{100};
  static constexpr Milliseconds kLeadStep{50};
  static constexpr Milliseconds kLeadMax{400};
  static constexpr Milliseconds kDeafMax{5000};

  /// `out` may be null: nothing is heard, and the steady clock is the clock.
  explicit SoundPlayer(std::unique_ptr<SoundOut> out);

  /// Changes where sound goes from the next now() on; null: nowhere.
  void set_out(std::unique_ptr<SoundOut> out);
  /// Sets a tap that also gets all that is written from now on: the samples, and when, by the
  /// steady clock, the first of them will be heard. Empty: none.
  using Tap = std::function<void(Instant heard_at, std::span<const float> samples)>;
  void set_tap(Tap tap) { tap_ = std::move(tap); }
  /// Something else plays from now on; `track` is its sound, null: none beside what `playback`
  /// brings. Both must live until the next open() or the end of this object.
  void open(playback::Playback* playback, SoundTrack* track = nullptr);
  /// What playback is to be advanced to at `steady`. The times must not go back.
  [[nodiscard]] Instant now(Instant steady);
  /// Playback has been advanced to what now() gave: writes the sound since then.
  void advanced();
  /// The moment whose face is to be shown, as of the last now(), and never later than what that
  /// gave.
  [[nodiscard]] Instant shown() const { return shown_; }
  /// now() - shown().
  [[nodiscard]] Duration lead() const { return now_ - shown_; }
  /// The face of shown() is on the display: measures how far it is from what is heard.
  void face_shown();

  /// Sound is written to a device: the device is the clock.
  [[nodiscard]] bool sounds() const { return sounds_; }
  /// The end of what plays has come, but not yet been heard.
  [[nodiscard]] bool rings_on() const { return sounds_ && shown_ < sound_until_; }
  /// The device has been given up since the last call; once.
  [[nodiscard]] bool take_loss();

  void set_volume(int percent);
  void set_muted(bool muted);
  /// Of what plays, as SoundMixer's; 0 while nothing does.
  [[nodiscard]] float peak() const { return sounds_ ? mixer_->peak() : 0; }

  /// Of all that has been opened.
  [[nodiscard]] SoundCounts counts() const;

 private:
  void feed();
  void start(Instant steady);
  void stop();
  /// What is in samples_: to the device and the tap.
  void write();
  void look_at_device(Instant steady);
  [[nodiscard]] Instant moment_of(std::int64_t sample) const;

  std::unique_ptr<SoundOut> out_;  ///< null: none, or given up
  playback::Playback* playback_ = nullptr;
  SoundTrack* given_ = nullptr;
  std::unique_ptr<VoiceTrack> voice_;
  std::unique_ptr<SoundMixer> mixer_;
  std::vector<float> samples_;
  Tap tap_;
  HeardLine line_;
  ShiftMeter shifts_;
  SoundCounts before_;  ///< of what was opened before
  std::uint64_t underruns_ = 0;
  bool sounds_ = false;
  bool lost_ = false;
  bool starved_ = false;      ///< the device has run out of sound and not been given more yet
  Instant begin_{};           ///< the moment of sample 0
  std::int64_t written_ = 0;  ///< samples, ever
  std::int64_t heard_ = 0;
  Duration lead_ = kLeadMin;
  Instant now_{};
  Instant shown_{};
  Instant sound_until_{};            ///< what is written has sound in it up to here
  std::optional<Instant> steady_;    ///< that shown_ is of
  std::optional<Instant> heard_at_;  ///< when the device last said that more had been heard
  std::optional<Duration> ahead_;    ///< of the steady clock, while nothing sounds
  int volume_ = 100;
  bool muted_ = false;
};

}  // namespace aucast::sound

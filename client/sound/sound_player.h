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
#include "client/sound/heard_out.h"
#include "client/sound/shift_meter.h"
#include "client/sound/sound_mixer.h"
#include "client/sound/sound_out.h"
#include "client/sound/voice_track.h"
#include "common/time.h"

namespace aucast::sound {

/// What --stats reports about sound.
struct SoundCounts {
  VoiceTrack::Counts voice;
  std::uint64_t underruns = 0;        ///< times that the device ran out of sound
  std::optional<double> drift_ppm{};  ///< what the device's clock gains on the steady clock, in
                                      ///< parts per million; nullopt until it has run for 12 s
  ShiftSummary shift;                 ///< between the face and the sound that is heard
};

/// Plays the sound of a playback, and is the clock by which the face moves. Playback is advanced to
/// now(), which is lead() ahead of what is heard, so that sound is written in time. The face to be
/// shown is that of shown(), whose sound is being heard. While there is no sound, both times go on
/// with the steady clock from where they were. Neither ever goes back. The lead is that of the
/// device (HeardOut). A device that is lost is given up.
/// Thread: the player's.
class SoundPlayer {
 public:
  /// `out` may be null: nothing is heard, and the steady clock is the clock.
  explicit SoundPlayer(std::unique_ptr<SoundOut> out);

  /// Changes the device from the next now() on; null: none.
  void set_out(std::unique_ptr<SoundOut> out);
  /// Sets a tap, which also gets all samples that are written from now on, with the steady clock's
  /// time at which the first of them will be heard. Empty: none.
  using Tap = std::function<void(Instant heard_at, std::span<const float> samples)>;
  void set_tap(Tap tap) { tap_ = std::move(tap); }
  /// Makes something else play from now on. `track` is its sound; if `track` is null, its sound is
  /// the voice that `playback` gives. Both must live until the next open() or the end of this
  /// object.
  void open(playback::Playback* playback, SoundTrack* track = nullptr);
  /// The time to which playback is to be advanced at `steady`. The times must not go back.
  [[nodiscard]] Instant now(Instant steady);
  /// Call it when playback has been advanced to what now() gave: writes the sound up to there.
  void advanced();
  /// The time whose face is to be shown, as of the last now(); never later than what now() gave.
  [[nodiscard]] Instant shown() const { return shown_; }
  /// now() - shown().
  [[nodiscard]] Duration lead() const { return now_ - shown_; }
  /// Call it when the face of shown() is on the display: measures how far it is from what is heard.
  void face_shown();

  /// Whether sound is written to a device, which then is the clock.
  [[nodiscard]] bool sounds() const { return sounds_; }
  /// Whether written sound has still to be heard, such as after the end of what plays.
  [[nodiscard]] bool rings_on() const { return sounds_ && shown_ < sound_until_; }
  /// True once after the device has been given up.
  [[nodiscard]] bool take_loss();

  void set_volume(int percent);
  void set_muted(bool muted);
  /// SoundMixer::peak() of what plays; 0 while nothing plays.
  [[nodiscard]] float peak() const { return sounds_ ? mixer_->peak() : 0; }

  /// The counts of everything that has been opened so far.
  [[nodiscard]] SoundCounts counts() const;

 private:
  // The player's times while there is sound, and what the device counts:
  //
  //     begin_ -------- shown_ <--- lead ---> now_
  //     0 ------------- heard --------------- written
  //
  // advanced() writes up to now_. If the device runs out of sound, heard meets written and both
  // times stand until more is written.

  [[nodiscard]] bool has_out() const { return out_ != nullptr && out_->open(); }
  void start(Instant steady);
  void stop();
  /// Writes samples_ to the device and the tap.
  void write();

  std::unique_ptr<HeardOut> out_;  ///< null: there is none; closed: it was given up
  playback::Playback* playback_ = nullptr;
  SoundTrack* given_ = nullptr;
  std::unique_ptr<VoiceTrack> voice_;
  std::unique_ptr<SoundMixer> mixer_;
  std::vector<float> samples_;
  Tap tap_;
  ShiftMeter shifts_;
  SoundCounts before_;           ///< the counts for what was opened before
  std::uint64_t underruns_ = 0;  ///< of the devices before this one
  bool sounds_ = false;
  bool lost_ = false;
  Instant begin_{};  ///< the time, as now() gives it, of the device's sample 0
  Instant now_{};
  Instant shown_{};
  Instant sound_until_{};          ///< until this time written sound may be heard; after it there
                                   ///< is silence
  std::optional<Instant> steady_;  ///< the steady clock's time of the last now()
  std::optional<Duration> ahead_;  ///< how far now_ is ahead of the steady clock while there is no
                                   ///< sound
  int volume_ = 100;
  bool muted_ = false;
};

}  // namespace aucast::sound

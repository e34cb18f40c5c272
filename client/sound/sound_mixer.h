#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "client/playback/passing.h"
#include "client/sound/sound_track.h"

namespace aucast::sound {

/// Makes one continuous run of samples while a stream plays, pauses, is sought or changes speed. It
/// never clicks: where the sound does not go on from where it was, it glides within 5 ms. Samples
/// are copied as they are at speed 1, and resampled at other speeds from kSpeedMin to kSpeedMax,
/// where the pitch changes too; beyond those there is silence. The track must outlive it. Thread:
/// none of its own.
class SoundMixer {
 public:
  static constexpr double kSpeedMin = 0.5;
  static constexpr double kSpeedMax = 2;

  explicit SoundMixer(SoundTrack& track) : track_(track) {}

  /// Makes the next samples. `at_end`: the place behind the last of them and the speed that leads
  /// there; nullopt, or a speed of 0: silence.
  void mix(std::optional<playback::Passing> at_end, std::span<float> samples);

  /// Sets the volume in percent, 0 to 100, of perceived loudness: its third power is the gain.
  void set_volume(int percent);
  void set_muted(bool muted) { muted_ = muted; }
  /// The largest recent sample, in [0,1], before volume and mute; falls by 26 dB a second.
  [[nodiscard]] float peak() const { return peak_; }

 private:
  void copy(std::span<float> samples);
  void resample(double to, std::span<float> samples);
  void glide(bool broken, std::span<float> samples);
  void measure(std::span<const float> samples);
  void scale(std::span<float> samples);

  SoundTrack& track_;
  std::optional<double> next_;  ///< the track's sample that comes next; nothing: silence
  std::vector<float> taps_;     ///< what is resampled
  float last_ = 0;
  float step_ = 0;  ///< what is added, ever less of it, so that the sound goes on without a step
  int step_left_ = 0;
  bool muted_ = false;
  float volume_ = 1;
  float gain_ = 1;  ///< on its way to the volume
  float peak_ = 0;
};

}  // namespace aucast::sound

#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "client/playback/passing.h"
#include "client/sound/sound_track.h"

namespace aucast::sound {

/// Makes one continuous run of samples while a stream plays, pauses, is sought or changes speed. It
/// never clicks: where the sound leaps, it glides to its new value within 5 ms. At speed 1 samples
/// are copied as they are; at other speeds from kSpeedMin to kSpeedMax they are resampled, which
/// changes the pitch; beyond these limits there is silence. The track must outlive it. Thread: none
/// of its own.
class SoundMixer {
 public:
  static constexpr double kSpeedMin = 0.5;
  static constexpr double kSpeedMax = 2;

  explicit SoundMixer(SoundTrack& track) : track_(track) {}

  /// Makes the next samples. `at_end`: the place at which they end, and the speed with which the
  /// stream got there; nullopt or a speed of 0: silence.
  void mix(std::optional<playback::Passing> at_end, std::span<float> samples);

  /// Sets the volume, 0 to 100 percent of perceived loudness: the gain is its third power.
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
  std::optional<double> next_;  ///< the sample of the track that comes next; nullopt: it is silent
  std::vector<float> taps_;     ///< the samples of the track that are resampled
  float last_ = 0;
  float step_ = 0;  ///< added to the sound after a leap, and faded out, so that there is no step
  int step_left_ = 0;
  bool muted_ = false;
  float volume_ = 1;
  float gain_ = 1;  ///< approaches volume_
  float peak_ = 0;
};

}  // namespace aucast::sound

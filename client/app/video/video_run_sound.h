#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "client/app/player_options.h"
#include "client/playback/playback.h"
#include "client/sound/sound_mixer.h"
#include "client/sound/voice_track.h"
#include "client/sound/wav_file.h"

namespace aucast::app {

/// The sound of a run on the video clock, for the file of --sound and the videos of --record. It is
/// in step with the pictures, exact to one sample.
class VideoRunSound {
 public:
  /// `track`: the sound of what is played; null: the voice of what is played is its sound. `stop`
  /// is asked for each second of sound; when it returns true, no more is written. All three must
  /// outlive this object.
  VideoRunSound(playback::Playback& playback, sound::SoundTrack* track,
                const std::function<bool()>& stop);

  /// Begins the sound, if the options ask for any. Fails if its file cannot be written.
  [[nodiscard]] Result<void> open(const SoundOptions& sound, const OutputOptions& output);
  /// Call it for each keyframe that begins. `end_ms`: when the keyframe ends, on the video clock.
  /// Takes the voice that has come and writes the sound up to `end_ms`.
  void keyframe(const playback::KeyframeBegun& begun, std::int64_t end_ms);
  /// Call it after the last keyframe: how much sound is left.
  [[nodiscard]] std::int64_t tail_ms();
  /// Writes the sound after the last keyframe, up to `end_ms` on the video clock.
  void tail(std::int64_t end_ms);
  /// The WAV file with all of the sound, for the videos; empty: there was no sound.
  [[nodiscard]] Result<std::filesystem::path> file();
  [[nodiscard]] Result<void> finish();
  /// What of the sound is not in the file, as a sentence; empty: all is there.
  [[nodiscard]] std::string complaint() const {
    return wav_ == nullptr ? std::string() : wav_->complaint();
  }
  [[nodiscard]] const sound::VoiceTrack::Counts& counts() const { return voice_.counts(); }

 private:
  void take_in();
  void write(std::optional<playback::Passing> at_end, std::int64_t end_ms);
  void mix(std::optional<playback::Passing> at_end, std::int64_t end_ms);

  playback::Playback& playback_;
  sound::VoiceTrack voice_;
  sound::SoundTrack& track_;
  const std::function<bool()>& stop_;
  sound::SoundMixer mixer_;
  std::unique_ptr<sound::WavFile> wav_;  ///< null: no sound is wanted
  bool keep_ = false;                    ///< the file is that of --sound, so it is not deleted
  std::int64_t place_ms_ = 0;            ///< the place in the stream that the run has reached
  std::int64_t end_ms_ = 0;  ///< the time on the video clock up to which sound has been written
  std::int64_t written_ = 0;
  std::vector<float> samples_;
};

}  // namespace aucast::app

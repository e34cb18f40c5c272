#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "client/app/player_options.h"
#include "client/playback/playback.h"
#include "client/sound/sound_mixer.h"
#include "client/sound/voice_track.h"
#include "client/sound/wav_file.h"

namespace aucast::app {

/// The sound of a film, in step with its pictures to the sample: what --sound writes and the videos
/// of --record have.
class FilmSound {
 public:
  /// `track`: of what is played, if it brings one; else its voice. It must outlive this.
  FilmSound(playback::Playback& playback, sound::SoundTrack* track);

  /// Failed when a place cannot be written.
  [[nodiscard]] Result<void> open(const SoundOptions& sound, const OutputOptions& output);
  /// A keyframe has begun that is over at `end_ms` of the film: takes what came with it and writes
  /// the sound of its time.
  void keyframe(const playback::KeyframeBegun& begun, std::int64_t end_ms);
  /// How much sound is left after the last keyframe.
  [[nodiscard]] std::int64_t tail_ms() const;
  /// Writes the sound after the last keyframe, up to `end_ms` of the film.
  void tail(std::int64_t end_ms);
  /// The WAV file with all of it, for the videos; empty: nothing has sounded.
  [[nodiscard]] Result<std::filesystem::path> file();
  [[nodiscard]] Result<void> finish();
  [[nodiscard]] const sound::VoiceTrack::Counts& counts() const { return voice_.counts(); }

 private:
  void take_in();
  void write(std::optional<playback::Passing> at_end, std::int64_t end_ms);
  void mix(std::optional<playback::Passing> at_end, std::int64_t end_ms);

  playback::Playback& playback_;
  sound::VoiceTrack voice_;
  sound::SoundTrack& track_;
  sound::SoundMixer mixer_;
  std::unique_ptr<sound::WavFile> wav_;  ///< null: nobody wants sound
  bool keep_ = false;                    ///< it is what --sound asked for
  std::int64_t place_ms_ = 0;            ///< of the stream, that the film has come to
  std::int64_t end_ms_ = 0;              ///< of the film
  std::int64_t written_ = 0;
  std::vector<float> samples_;
};

}  // namespace aucast::app

#include "client/app/sound_device.h"

#include "client/sound/file_track.h"
#include "client/sound/openal_out.h"
#include "common/log.h"

namespace aucast::app {

std::unique_ptr<sound::SoundOut> open_sound(PlayerOptions& options) {
  if (!options.wants_voice() || options.output.fast) return nullptr;
  const std::string name = options.sound.device.value_or("default");
  auto out = sound::open_sound_device(name == "default" ? "" : name);
  if (out) return std::move(*out);
  options.playback.voice = false;
  const auto level = options.sound.device ? spdlog::level::warn : spdlog::level::info;
  spdlog::log(level, "without sound: {}", out.error().message);
  return nullptr;
}

Result<std::unique_ptr<sound::SoundTrack>> open_sound_file(
    const std::filesystem::path& sound_file) {
  auto track = sound::FileTrack::open(sound_file);
  if (!track) return track.error();
  if (!(*track)->complaint().empty()) spdlog::warn("{}", (*track)->complaint());
  return std::unique_ptr<sound::SoundTrack>(std::move(*track));
}

Result<std::unique_ptr<sound::SoundTrack>> open_sound_beside(
    const std::filesystem::path& stream_file) {
  const auto file = sound::sound_beside(stream_file);
  return file ? open_sound_file(*file) : std::unique_ptr<sound::SoundTrack>();
}

}  // namespace aucast::app

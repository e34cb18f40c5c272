#include "client/app/sound_device.h"

#include "client/sound/file_track.h"
#include "client/sound/openal_out.h"
#include "common/log.h"
#include "common/sound_name.h"

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

Result<std::unique_ptr<sound::SoundTrack>> open_sound_beside(
    const std::filesystem::path& stream_file, const std::function<bool()>& stop) {
  const auto file = sound_beside(stream_file);
  if (!file) return std::unique_ptr<sound::SoundTrack>();
  auto track = sound::FileTrack::open(*file, stop);
  if (!track) return track.error();
  if (const auto complaint = (*track)->take_complaint(); !complaint.empty()) {
    spdlog::warn("{}", complaint);
  }
  return std::unique_ptr<sound::SoundTrack>(std::move(*track));
}

}  // namespace aucast::app

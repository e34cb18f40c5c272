#include "common/sound_name.h"

#include <algorithm>
#include <system_error>

#include "common/text.h"

namespace aucast {

bool is_sound(const std::filesystem::path& path) {
  const std::string ending = file_ending(path);
  return std::find(kSoundEndings.begin(), kSoundEndings.end(), ending) != kSoundEndings.end();
}

std::optional<std::filesystem::path> sound_beside(const std::filesystem::path& stream_file) {
  for (const std::string_view ending : kSoundEndings) {
    std::filesystem::path sound = stream_file;
    sound.replace_extension(ending);
    std::error_code ignored;
    if (sound != stream_file && std::filesystem::exists(sound, ignored)) return sound;
  }
  return std::nullopt;
}

}  // namespace aucast

#include "common/sound_name.h"

#include <algorithm>
#include <system_error>

#include "common/text.h"

namespace aucast {

bool is_sound(const std::filesystem::path& path) {
  const std::string ending = file_ending(path);
  return std::find(kSoundEndings.begin(), kSoundEndings.end(), ending) != kSoundEndings.end();
}

std::optional<std::filesystem::path> file_beside(const std::filesystem::path& source,
                                                 std::string_view ending) {
  std::filesystem::path beside = source;
  beside.replace_extension(ending);
  std::error_code ignored;
  const auto status = std::filesystem::symlink_status(beside, ignored);
  if (beside == source || !std::filesystem::exists(status)) return std::nullopt;
  if (std::filesystem::is_directory(beside, ignored)) return std::nullopt;
  return beside;
}

std::optional<std::filesystem::path> sound_beside(const std::filesystem::path& source) {
  for (const std::string_view ending : kSoundEndings) {
    if (auto sound = file_beside(source, ending)) return sound;
  }
  return std::nullopt;
}

}  // namespace aucast

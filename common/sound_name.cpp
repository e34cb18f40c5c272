#include "common/sound_name.h"

#include <algorithm>

#include "common/text.h"

namespace aucast {

bool is_sound(const std::filesystem::path& path) {
  const std::string ending = file_ending(path);
  return std::find(kSoundEndings.begin(), kSoundEndings.end(), ending) != kSoundEndings.end();
}

}  // namespace aucast

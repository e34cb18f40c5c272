#include "common/sound_name.h"

#include <algorithm>

#include "common/text.h"

namespace aucast {

bool is_sound(const std::filesystem::path& path) {
  const std::string ending = lowered(path.extension().string());
  return std::find(kSoundEndings.begin(), kSoundEndings.end(), ending) != kSoundEndings.end();
}

}  // namespace aucast

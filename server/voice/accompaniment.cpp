#include "server/voice/accompaniment.h"

#include <utility>

#include "common/files.h"
#include "common/sound_name.h"
#include "common/text.h"
#include "common/voice/webvtt.h"

namespace aucast::server {

Result<Accompaniment> accompaniment_of(const std::filesystem::path& source,
                                       const VoiceOptions& options, bool first) {
  auto sound = sound_beside(source);
  if (first && !options.file.empty()) sound = options.file;
  Accompaniment all;
  if (sound && !options.none) {
    auto found = find_voice_file(*sound, options.delay);
    if (!found) return found.error();
    all.voice = std::move(*found);
  }
  if (const auto file = file_beside(source, ".vtt")) {
    const auto text = read_file(*file);
    if (!text) return text.error();
    auto captions = voice::parse_webvtt(*text, printable(file->string()));
    if (!captions) return captions.error();
    all.captions = std::move(*captions);
  }
  return all;
}

}  // namespace aucast::server

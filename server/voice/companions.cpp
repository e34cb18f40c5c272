#include "server/voice/companions.h"

#include <system_error>
#include <utility>

#include "common/files.h"
#include "common/text.h"
#include "common/voice/webvtt.h"

namespace aucast::server {
namespace {

std::optional<std::filesystem::path> beside(std::filesystem::path source, const char* extension) {
  source.replace_extension(extension);
  // What is there and cannot be read is found all the same: whoever reads it says why.
  std::error_code ignored;
  const auto status = std::filesystem::symlink_status(source, ignored);
  if (!std::filesystem::exists(status) || std::filesystem::is_directory(status)) return {};
  return source;
}

}  // namespace

Companions companions_of(const std::filesystem::path& source) {
  Companions companions;
  for (const char* extension : {".wav", ".flac", ".opus", ".ogg", ".mp3"}) {
    companions.sound = beside(source, extension);
    if (companions.sound) break;
  }
  companions.captions = beside(source, ".vtt");
  return companions;
}

Result<Accompaniment> accompaniment_of(const std::filesystem::path& source,
                                       const VoiceOptions& options, bool first) {
  Companions companions = companions_of(source);
  if (first && !options.file.empty()) companions.sound = options.file;
  Accompaniment all;
  if (companions.sound && !options.none) {
    auto found = find_voice_file(*companions.sound, options.delay);
    if (!found) return found.error();
    all.voice = std::move(*found);
  }
  if (companions.captions) {
    const auto text = read_file(*companions.captions);
    if (!text) return text.error();
    auto captions = voice::parse_webvtt(*text, printable(companions.captions->string()));
    if (!captions) return captions.error();
    all.captions = std::move(*captions);
  }
  return all;
}

}  // namespace aucast::server

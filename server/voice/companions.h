#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "common/result.h"
#include "protocol/packet.h"
#include "server/settings/voice_options.h"
#include "server/voice/voice_file.h"

namespace aucast::server {

/// The files of the same name beside a stream file or a recording, which belong to it as subtitles
/// belong to a film.
struct Companions {
  std::optional<std::filesystem::path> sound;
  std::optional<std::filesystem::path> captions;
};

/// Looks for the companions of a source. Of several sound files it takes the one whose ending comes
/// first in kSoundEndings; captions are .vtt.
[[nodiscard]] Companions companions_of(const std::filesystem::path& source);

/// The content of the companions.
struct Accompaniment {
  std::optional<VoiceFile> voice;
  std::vector<protocol::CaptionData> captions;
};

/// Looks for the companions of a source and reads the captions. `first`: it is the first source, to
/// which --voice applies. Errors are those of find_voice_file(), read_file() and parse_webvtt().
[[nodiscard]] Result<Accompaniment> accompaniment_of(const std::filesystem::path& source,
                                                     const VoiceOptions& options, bool first);

}  // namespace aucast::server

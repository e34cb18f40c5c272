#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "common/result.h"
#include "protocol/packet.h"
#include "server/settings/voice_options.h"
#include "server/voice/voice_file.h"

namespace aucast::server {

/// What goes with a source: a sound file, and the captions of another.
struct Accompaniment {
  std::optional<VoiceFile> voice;
  std::vector<protocol::CaptionData> captions;
};

/// Looks for the sound file and the captions (.vtt) beside a source, and reads the captions.
/// `first`: it is the first source, to which --voice applies. Errors are those of
/// find_voice_file(), read_file() and parse_webvtt().
[[nodiscard]] Result<Accompaniment> accompaniment_of(const std::filesystem::path& source,
                                                     const VoiceOptions& options, bool first);

}  // namespace aucast::server

#pragma once

#include <filesystem>
#include <vector>

#include "common/options.h"
#include "common/time.h"
#include "common/voice/voice_encoder.h"

namespace aucast::server {

/// Where the voices of the streams come from and how they are encoded.
struct VoiceOptions {
  bool none = false;           ///< no stream has a voice
  std::filesystem::path file;  ///< for the first source; empty: the file beside it, if there is one
  voice::VoiceSettings encoder;
  Milliseconds delay{0};  ///< how much later the sound is on the stream's clock
  friend bool operator==(const VoiceOptions&, const VoiceOptions&) = default;
};

/// The rows of voices, from --voice to --voice-delay, bound to `options`.
[[nodiscard]] std::vector<OptionRow> voice_rows(VoiceOptions& options);

}  // namespace aucast::server

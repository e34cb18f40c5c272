#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "common/result.h"
#include "common/time.h"
#include "common/voice/voice_encoder.h"
#include "protocol/voice_packet.h"
#include "server/voice/voice_file.h"

namespace aucast::server {

/// A time during which no sound is sent.
struct Silence {
  Milliseconds begin{0};
  Milliseconds end{0};
  friend bool operator==(const Silence&, const Silence&) = default;
};

/// What --check and --estimate report about a voice.
struct VoiceSummary {
  std::vector<protocol::VoicePacket> packets;
  Milliseconds end{0};  ///< where the sound that could be read ends, on the stream's clock
  /// Silences of at least kSilenceLeast, also at the beginning and at the end.
  std::vector<Silence> silences;
  std::string complaint;  ///< as SoundFile::complaint()
};

/// A speaker's pauses are shorter than this.
inline constexpr Milliseconds kSilenceLeast{3000};

/// Reads and encodes the whole file, which takes about a second for each minute of sound.
[[nodiscard]] Result<VoiceSummary> summarise_voice(const VoiceFile& file,
                                                   const voice::VoiceSettings& settings);

/// How many bytes each packet takes on the wire, for a client that gets all of them.
[[nodiscard]] std::vector<std::size_t> wire_sizes(
    const std::vector<protocol::VoicePacket>& packets);

}  // namespace aucast::server

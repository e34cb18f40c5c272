#pragma once

#include <cstddef>
#include <vector>

#include "common/result.h"
#include "common/time.h"
#include "common/voice/voice_encoder.h"
#include "protocol/voice_packet.h"
#include "server/voice/voice_file.h"

namespace aucast::server {

/// A stretch without a sound that is sent.
struct Silence {
  Milliseconds begin{0};
  Milliseconds end{0};
  friend bool operator==(const Silence&, const Silence&) = default;
};

/// What --check and --estimate say of a voice, from its sound as it is sent.
struct VoiceSummary {
  std::vector<protocol::VoicePacket> packets;
  Milliseconds end{0};  ///< of what could be read, on the stream's clock
  /// Those of kSilenceLeast and more, also at the beginning and at the end.
  std::vector<Silence> silences;
};

/// A pause that a speaker makes is shorter.
inline constexpr Milliseconds kSilenceLeast{3000};

/// Reads and encodes the whole file: a minute of it takes about a second.
[[nodiscard]] Result<VoiceSummary> summarise_voice(const VoiceFile& file,
                                                   const voice::VoiceSettings& settings);

/// What each packet takes on the wire, to a client that gets all of them.
[[nodiscard]] std::vector<std::size_t> wire_sizes(
    const std::vector<protocol::VoicePacket>& packets);

}  // namespace aucast::server

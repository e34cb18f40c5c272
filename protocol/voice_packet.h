#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "common/time.h"
#include "protocol/packet.h"
#include "protocol/word_packet.h"

namespace aucast::protocol {

/// One Opus packet (RFC 6716) of a stream's voice. Its sound begins at `place` and lasts for
/// opus_duration(). On the wire and in the client, `place` is on the client's clock; before that,
/// it is on the clock of the stream or of the recording.
struct VoicePacket {
  Milliseconds place{0};
  std::string opus;
  friend bool operator==(const VoicePacket&, const VoicePacket&) = default;
};

/// How long the sound of an Opus packet lasts, by its TOC byte (RFC 6716 section 3.1). Returns
/// nullopt for bytes that are no Opus packet, and for a length other than the 10, 20, 40 or 60 ms
/// that the protocol allows.
[[nodiscard]] std::optional<Milliseconds> opus_duration(std::string_view opus);

/// Reads the text() of a finished WordPacket whose word is `a`.
[[nodiscard]] std::variant<VoiceData, FieldFault> parse_voice_data(std::string_view text);

}  // namespace aucast::protocol

#include "protocol/voice_packet.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "common/text.h"
#include "protocol/codec.h"
#include "protocol/placed_data.h"

namespace aucast::protocol {
namespace {

/// Microseconds of one frame, by the five bits of the configuration (RFC 6716 table 2).
int frame_us(int configuration) {
  constexpr std::array<int, 4> kSilk{10000, 20000, 40000, 60000};
  constexpr std::array<int, 2> kHybrid{10000, 20000};
  constexpr std::array<int, 4> kCelt{2500, 5000, 10000, 20000};
  if (configuration < 12) return kSilk[static_cast<std::size_t>(configuration % 4)];
  if (configuration < 16) return kHybrid[static_cast<std::size_t>(configuration % 2)];
  return kCelt[static_cast<std::size_t>(configuration % 4)];
}

/// How many frames a packet has; 0 for an illegal packet.
int frame_count(std::string_view opus) {
  constexpr int kFramesMax = 48;
  switch (byte_at(opus, 0) & 3U) {
    case 0:
      return 1;
    case 1:
    case 2:
      return 2;
    default: {
      if (opus.size() < 2) return 0;
      const int count = byte_at(opus, 1) & 0x3FU;
      return count <= kFramesMax ? count : 0;
    }
  }
}

}  // namespace

std::optional<Milliseconds> opus_duration(std::string_view opus) {
  constexpr std::array<int, 4> kPacketUs{10000, 20000, 40000, 60000};
  if (opus.empty()) return std::nullopt;
  const int us = frame_us(byte_at(opus, 0) >> 3U) * frame_count(opus);
  if (std::find(kPacketUs.begin(), kPacketUs.end(), us) == kPacketUs.end()) return std::nullopt;
  return Milliseconds(us / 1000);
}

std::variant<VoiceData, FieldFault> parse_voice_data(std::string_view text) {
  auto fields = parse_placed_data(text);
  if (auto* fault = std::get_if<FieldFault>(&fields)) return std::move(*fault);
  auto& [place_ms, bytes, position] = std::get<PlacedData>(fields);
  if (!opus_duration(bytes)) {
    return FieldFault{position, "a voice packet is one of Opus, of 10, 20, 40 or 60 ms, in base64"};
  }
  return VoiceData{place_ms, std::move(bytes)};
}

std::string encode(const VoiceData& voice) {
  return encode_placed_data('a', voice.place_ms, voice.opus);
}

}  // namespace aucast::protocol

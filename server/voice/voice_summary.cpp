#include "server/voice/voice_summary.h"

#include <optional>

namespace aucast::server {
namespace {

Milliseconds end_of(const protocol::VoicePacket& packet) {
  return packet.place + protocol::opus_duration(packet.opus).value_or(Milliseconds::zero());
}

std::vector<Silence> silences_of(const std::vector<protocol::VoicePacket>& packets,
                                 Milliseconds end) {
  std::vector<Silence> silences;
  Milliseconds at{0};
  const auto note = [&](Milliseconds until) {
    if (until - at >= kSilenceLeast) silences.push_back({at, until});
  };
  for (const protocol::VoicePacket& packet : packets) {
    note(packet.place);
    at = end_of(packet);
  }
  note(end);
  return silences;
}

}  // namespace

Result<VoiceSummary> summarise_voice(const VoiceFile& file, const voice::VoiceSettings& settings) {
  auto reader = VoiceReader::open(file, settings);
  if (!reader) return reader.error();
  VoiceSummary summary;
  while (reader->read(summary.packets)) {
  }
  summary.end = reader->end();
  summary.complaint = reader->complaint();
  summary.silences = silences_of(summary.packets, summary.end);
  return summary;
}

std::vector<std::size_t> wire_sizes(const std::vector<protocol::VoicePacket>& packets) {
  std::vector<std::size_t> sizes;
  std::optional<Milliseconds> end;
  for (const protocol::VoicePacket& packet : packets) {
    protocol::VoiceData data{{}, packet.opus};
    if (packet.place != end) data.place_ms = static_cast<std::uint64_t>(packet.place.count());
    sizes.push_back(protocol::encode(data).size());
    end = end_of(packet);
  }
  return sizes;
}

}  // namespace aucast::server

// What a server may send: never a crash, the same whatever the portions, and what is accepted is
// read again from its canonical form.

#include <string>
#include <string_view>
#include <variant>

#include "common/check.h"
#include "protocol/codec.h"
#include "protocol/decoder.h"
#include "protocol/limits.h"
#include "tests/fuzz/fuzz_input.h"
#include "tests/fuzz/packet_decoder.h"

using namespace aucast::protocol;

namespace {

std::string text_of(const ServerPacket& packet) {
  return std::visit([](const auto& kind) { return encode(kind); }, packet);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto bounded = [](const ServerPacketDecoder& decoder) {
    AUCAST_CHECK(decoder.taken_bytes() <= kPacketBytesMax);
  };
  const std::string_view bytes = aucast::fuzz::text_of(data, size);
  const auto whole = aucast::fuzz::decode_any<ServerPacket, ServerPacketDecoder>(bytes, bounded);
  for (const ServerPacket& packet : whole.packets) {
    const std::string canonical = text_of(packet);
    const ServerPacket again =
        aucast::fuzz::decode_one<ServerPacket, ServerPacketDecoder>(canonical, bounded);
    AUCAST_CHECK(text_of(again) == canonical);
  }
  return 0;
}

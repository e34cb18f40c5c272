// What a client may send: never a crash, the same whatever the portions, and what is accepted is
// read again from its canonical form.

#include <string>
#include <string_view>
#include <variant>

#include "protocol/codec.h"
#include "protocol/decoder.h"
#include "protocol/limits.h"
#include "tests/fuzz/fuzz_input.h"
#include "tests/fuzz/packet_decoder.h"

using namespace aucast::protocol;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto any = [](const ClientPacketDecoder&) {};
  const std::string_view bytes = aucast::fuzz::text_of(data, size);
  const auto whole = aucast::fuzz::decode_any<ClientPacket, ClientPacketDecoder>(bytes, any);
  for (const ClientPacket& packet : whole.packets) {
    const std::string canonical = std::visit([](const auto& kind) { return encode(kind); }, packet);
    if (canonical.size() > kHelloBytesMax) continue;  // defaults written out may pass the limit
    static_cast<void>(aucast::fuzz::decode_one<ClientPacket, ClientPacketDecoder>(canonical, any));
  }
  return 0;
}

// What a client may send: never a crash, the same whatever the portions, and what is accepted is
// read again from its canonical form.

#include <vector>

#include "common/check.h"
#include "protocol/codec.h"
#include "protocol/decoder.h"
#include "protocol/limits.h"
#include "tests/fuzz/fuzz_input.h"

using namespace aucast::protocol;

namespace {

struct Outcome {
  std::vector<ClientPacket> packets;
  std::optional<DecodeError> error;
  friend bool operator==(const Outcome&, const Outcome&) = default;
};

Outcome decode(std::string_view bytes, std::size_t portion) {
  ClientPacketDecoder decoder;
  Outcome outcome;
  while (!bytes.empty()) {
    std::string_view some = bytes.substr(0, portion);
    bytes.remove_prefix(some.size());
    while (auto packet = decoder.next(some)) outcome.packets.push_back(std::move(*packet));
  }
  outcome.error = decoder.error();
  return outcome;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes = aucast::fuzz::text_of(data, size);
  const Outcome whole = decode(bytes, std::max<std::size_t>(size, 1));
  AUCAST_CHECK(whole == decode(bytes, 1));
  if (whole.error) {
    AUCAST_CHECK(whole.error->position < size);
    AUCAST_CHECK(!whole.error->reason.empty());
  }
  for (const ClientPacket& packet : whole.packets) {
    const std::string canonical = std::visit([](const auto& kind) { return encode(kind); }, packet);
    if (canonical.size() > kHelloBytesMax) continue;  // defaults written out may pass the limit
    const Outcome again = decode(canonical, canonical.size());
    AUCAST_CHECK(!again.error);
    AUCAST_CHECK(again.packets.size() == 1);
  }
  return 0;
}

// What anybody may put on a subject of an engine: never a crash, and what is accepted is read again
// from what it is written as. Moving the places of its packets neither adds nor splits any.

#include <algorithm>

#include "common/check.h"
#include "protocol/engine_message.h"
#include "tests/fuzz/fuzz_input.h"

using namespace aucast::protocol;

namespace {

void check_packets(const EngineMessage& message) {
  std::string_view rest = message.packets;
  while (!rest.empty()) {
    const std::string_view packet = first_packet(rest);
    AUCAST_CHECK(!packet.empty());
    rest.remove_prefix(packet.size());
  }
  const std::string moved = with_places_earlier(message.packets, message.place_ms);
  const auto ends = [](std::string_view text) { return std::count(text.begin(), text.end(), '}'); };
  AUCAST_CHECK(moved.size() <= message.packets.size());
  AUCAST_CHECK(ends(moved) <= ends(message.packets));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes = aucast::fuzz::text_of(data, size);
  if (const auto message = parse_engine_message(bytes)) {
    const auto again = parse_engine_message(encode(*message));
    AUCAST_CHECK(again && *again == *message);
    check_packets(*message);
  }
  if (const auto join = parse_engine_join(bytes)) {
    const auto again = parse_engine_join(encode(*join));
    AUCAST_CHECK(again && *again == *join);
  }
  return 0;
}

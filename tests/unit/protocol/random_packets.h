#pragma once

#include <string>

#include "protocol/packet.h"
#include "tests/support/seeded.h"

namespace aucast::test {

/// Random packets in canonical form, so that decode(encode(x)) == x.
[[nodiscard]] protocol::Keyframe random_keyframe(Seeded& seeded);
[[nodiscard]] protocol::ServerPacket random_server_packet(Seeded& seeded);
[[nodiscard]] protocol::HelloAsked random_hello(Seeded& seeded);
[[nodiscard]] std::string random_stream_name(Seeded& seeded);

}  // namespace aucast::test

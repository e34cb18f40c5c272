#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "common/check.h"
#include "protocol/decoder.h"

namespace aucast::fuzz {

/// What a decoder of packets made of bytes.
template <typename Packet>
struct Decoded {
  std::vector<Packet> packets;
  std::optional<protocol::DecodeError> error;
  friend bool operator==(const Decoded&, const Decoded&) = default;
};

/// Feeds `bytes` to a new decoder, `portion` at a time. Calls `check` with it after each packet.
template <typename Packet, typename Decoder, typename Check>
Decoded<Packet> decode_portions(std::string_view bytes, std::size_t portion, Check check) {
  Decoder decoder;
  Decoded<Packet> decoded;
  while (!bytes.empty()) {
    std::string_view some = bytes.substr(0, portion);
    bytes.remove_prefix(some.size());
    while (auto packet = decoder.next(some)) {
      check(decoder);
      decoded.packets.push_back(std::move(*packet));
    }
  }
  decoded.error = decoder.error();
  return decoded;
}

/// The packets of any bytes. Checks that they do not depend on the portions, and that a fault lies
/// within the bytes and has a reason.
template <typename Packet, typename Decoder, typename Check>
Decoded<Packet> decode_any(std::string_view bytes, Check check) {
  const auto whole =
      decode_portions<Packet, Decoder>(bytes, std::max<std::size_t>(bytes.size(), 1), check);
  AUCAST_CHECK((whole == decode_portions<Packet, Decoder>(bytes, 1, check)));
  if (whole.error) {
    AUCAST_CHECK(whole.error->position < bytes.size());
    AUCAST_CHECK(!whole.error->reason.empty());
  }
  return whole;
}

/// Reads a packet in canonical form; checks that it is read as one packet.
template <typename Packet, typename Decoder, typename Check>
Packet decode_one(std::string_view canonical, Check check) {
  auto again = decode_portions<Packet, Decoder>(canonical, canonical.size(), check);
  AUCAST_CHECK(!again.error);
  AUCAST_CHECK(again.packets.size() == 1);
  return std::move(again.packets.front());
}

}  // namespace aucast::fuzz

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

/// Feeds a new decoder, `portion` bytes at a time. `check` sees it after each packet.
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

/// The packets of any bytes: the same whatever the portions, and a fault is in them and has words.
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

/// The one packet that a canonical form is read as.
template <typename Packet, typename Decoder, typename Check>
Packet decode_one(std::string_view canonical, Check check) {
  auto again = decode_portions<Packet, Decoder>(canonical, canonical.size(), check);
  AUCAST_CHECK(!again.error);
  AUCAST_CHECK(again.packets.size() == 1);
  return std::move(again.packets.front());
}

}  // namespace aucast::fuzz

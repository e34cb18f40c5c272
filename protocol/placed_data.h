#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "protocol/word_packet.h"

namespace aucast::protocol {

/// The form that voice packets and captions have in common: {WORD@PLACE DATA}, with DATA in base64.
struct PlacedData {
  std::optional<std::uint64_t> place_ms;
  std::string bytes;         ///< empty: there was no DATA
  std::size_t position = 0;  ///< where DATA begins in the packet, whose '{' is at 0
};

/// Reads the text() of a finished WordPacket whose word is one letter.
[[nodiscard]] std::variant<PlacedData, FieldFault> parse_placed_data(std::string_view text);

[[nodiscard]] std::string encode_placed_data(char word, std::optional<std::uint64_t> place_ms,
                                             std::string_view bytes);

}  // namespace aucast::protocol

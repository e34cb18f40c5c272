#pragma once

#include <string_view>
#include <variant>

#include "protocol/packet.h"
#include "protocol/word_packet.h"

namespace aucast::protocol {

/// Whether the text can be a caption: UTF-8 without control characters other than line feeds, short
/// enough for one packet.
[[nodiscard]] bool is_caption(std::string_view text);

/// Whether the text can be a stream's title: the same, but one line of at most kTitleBytesMax
/// bytes.
[[nodiscard]] bool is_title(std::string_view text);

/// Reads the text() of a finished WordPacket of the word `t`.
[[nodiscard]] std::variant<CaptionData, FieldFault> parse_caption(std::string_view text);

}  // namespace aucast::protocol

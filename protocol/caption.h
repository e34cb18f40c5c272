#pragma once

#include <string_view>
#include <variant>

#include "protocol/packet.h"
#include "protocol/word_packet.h"

namespace aucast::protocol {

/// Whether we may make a caption of the text: UTF-8 without control characters other than line
/// feeds, short enough for one packet with any place. Other senders may send longer ones, as long
/// as text and place fit into a packet together.
[[nodiscard]] bool is_caption(std::string_view text);

/// Whether the text can be a stream's title: one line of UTF-8 without control characters, at most
/// kTitleBytesMax bytes.
[[nodiscard]] bool is_title(std::string_view text);

/// Reads the text() of a finished WordPacket whose word is `t`.
[[nodiscard]] std::variant<CaptionData, FieldFault> parse_caption(std::string_view text);

}  // namespace aucast::protocol

#pragma once

#include <string_view>
#include <vector>

#include "common/result.h"
#include "protocol/packet.h"

namespace aucast::voice {

/// Reads the text of a WebVTT file, which messages call `file`. The captions are in the order
/// of their places. Each lasts until the next one begins: a caption that begins while another lasts
/// replaces it, and an empty one stands for a time without captions. Markup, settings, notes and
/// styles are left out. Fails with BadData and file:line:column for a text that is not WebVTT, an
/// invalid time, or a caption that protocol::is_caption() refuses.
[[nodiscard]] Result<std::vector<protocol::CaptionData>> parse_webvtt(std::string_view text,
                                                                      std::string_view file);

}  // namespace aucast::voice

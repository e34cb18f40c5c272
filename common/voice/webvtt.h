#pragma once

#include <string_view>
#include <vector>

#include "common/result.h"
#include "protocol/packet.h"

namespace aucast::voice {

/// Reads the text of a WebVTT file. `file` is what messages call it. Captions in ascending places:
/// one that begins while another lasts takes its place, and where none follows at once there is an
/// empty one. Markup, settings, notes and styles are left out. BadData, with file:line:column, for
/// what is no WebVTT, a time that is none, and a text that protocol::is_caption() is not true of.
[[nodiscard]] Result<std::vector<protocol::CaptionData>> parse_webvtt(std::string_view text,
                                                                      std::string_view file);

}  // namespace aucast::voice

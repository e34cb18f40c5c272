#pragma once

#include <string>

#include "server/streams/load_sources.h"
#include "server/voice/voice_summary.h"

namespace aucast::server {

/// What --check prints of one stream: of a recording what was found in it, then packets, duration,
/// bytes per level, and for each AU how many packets use it and between which intensities. An
/// untimed keyframe counts as `keyframe_ms`. Of a voice its length, where that is not the face's,
/// and where it is silent.
[[nodiscard]] std::string check_report(const Source& source, std::uint32_t keyframe_ms,
                                       const VoiceSummary* voice = nullptr);

}  // namespace aucast::server

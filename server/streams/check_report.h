#pragma once

#include <string>

#include "server/streams/load_sources.h"
#include "server/voice/voice_summary.h"

namespace aucast::server {

/// What --check prints about one stream: for a recording, what was found in it; then keyframes,
/// duration, bytes per level, and for each AU how many keyframes use it and between which
/// intensities; for a voice, its length, whether it breaks off, the ends of voice and face if they
/// are more than 1 s apart, and its silences. An untimed keyframe takes `keyframe_ms`.
[[nodiscard]] std::string check_report(const Source& source, std::uint32_t keyframe_ms,
                                       const VoiceSummary* voice = nullptr);

}  // namespace aucast::server

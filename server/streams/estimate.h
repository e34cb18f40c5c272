#pragma once

#include <string>

#include "common/time.h"
#include "server/streams/load_sources.h"
#include "server/voice/voice_summary.h"

namespace aucast::server {

/// What --estimate prints about one stream. For each form in which it can be sent (classic, level
/// 2, changes): the packets, the bytes, and the bits a second when it is played at its own
/// speed, on average and in the busiest second, without and with the headers of TCP and IP. Packets
/// sent within `batch` share headers. With a voice, the same for the voice and for both together.
[[nodiscard]] std::string estimate_report(const Source& source, Milliseconds batch,
                                          const VoiceSummary* voice = nullptr);

}  // namespace aucast::server

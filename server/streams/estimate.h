#pragma once

#include <string>

#include "common/time.h"
#include "server/streams/load_sources.h"
#include "server/voice/voice_summary.h"

namespace aucast::server {

/// What --estimate prints of one stream: for each form of it the packets, the bytes, and the bits a
/// second at its own speed, on average and in the busiest second, without and with the headers of
/// TCP and IP. What is sent within `batch` shares headers. With a voice, the same for it and for
/// both together.
[[nodiscard]] std::string estimate_report(const Source& source, Milliseconds batch,
                                          const VoiceSummary* voice = nullptr);

}  // namespace aucast::server

#pragma once

#include <cstdint>
#include <filesystem>
#include <stop_token>

#include "common/result.h"
#include "protocol/stream_file.h"

namespace aucast::server {

/// Gives the stream `rate` keyframes a second (sources::resample()). `keyframe_ms`: of an untimed
/// keyframe. Fails, and leaves the stream as it is, when the new keyframes do not fit into memory;
/// the message names `path`, the stream's file.
[[nodiscard]] Result<void> resample(protocol::StreamFile& stream, double rate,
                                    std::uint32_t keyframe_ms, const std::filesystem::path& path,
                                    const std::stop_token& stop = {});

}  // namespace aucast::server

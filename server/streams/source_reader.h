#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "common/result.h"
#include "common/sources/recording.h"
#include "protocol/stream_file.h"
#include "server/settings/source_options.h"

namespace aucast::server {

/// What a file holds, whichever kind it is.
struct SourceContent {
  protocol::StreamFile stream;
  std::optional<sources::Found> found;  ///< of a recording; nothing for a stream file
};

/// The table that reads Live Link Face's curves as AUs, from the data folder.
[[nodiscard]] Result<sources::ArkitTable> load_arkit_table();

/// Reads a stream file or a recogniser's recording, told apart by what is in it, and brings it to
/// options.rate. `conditioning` is what options.signal comes to; its dead band is not applied here.
/// `keyframe_ms`: time of an untimed keyframe. The path "-" is stdin, read to its end.
[[nodiscard]] Result<SourceContent> read_source(const std::filesystem::path& path,
                                                const SourceOptions& options,
                                                const sources::ConditioningSettings& conditioning,
                                                std::uint32_t keyframe_ms);

/// The same as one stream for each face when options.recording.all_faces, the most frequent first.
[[nodiscard]] Result<std::vector<SourceContent>> read_streams(
    const std::filesystem::path& path, const SourceOptions& options,
    const sources::ConditioningSettings& conditioning, std::uint32_t keyframe_ms);

}  // namespace aucast::server

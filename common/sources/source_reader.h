#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "common/result.h"
#include "common/sources/conditioning.h"
#include "common/sources/recording.h"
#include "protocol/stream_file.h"

namespace aucast::sources {

/// How a file is read as keyframes.
struct ReadOptions {
  RecordingOptions recording;
  std::optional<double> rate;         ///< keyframes a second, (0, kRateMax]; else as they are
  ConditioningSettings conditioning;  ///< its dead band is not applied
  std::uint32_t keyframe_ms = 250;    ///< of an untimed keyframe
};

/// What a file holds, whichever kind it is.
struct SourceContent {
  protocol::StreamFile stream;
  std::optional<Found> found;  ///< of a recording; nothing for a stream file
};

/// Reads a stream file or a recogniser's recording, told apart by what is in it. Of several faces
/// one. The path "-" is stdin, read to its end.
[[nodiscard]] Result<SourceContent> read_source(const std::filesystem::path& path,
                                                const ReadOptions& options = {});

/// The text of the source at `path`, and what messages call it. Asked to stop, a file is read no
/// further: stopped_early().
[[nodiscard]] Result<std::string> read_text(const std::filesystem::path& path,
                                            const std::stop_token& stop = {});
[[nodiscard]] std::string name_of(const std::filesystem::path& path);

/// Reads a text that messages call `file`, and keeps its keyframes as they are: one stream for each
/// face when recording.all_faces, the most frequent first. Asked to stop, it returns
/// stopped_early() at the next line.
[[nodiscard]] Result<std::vector<SourceContent>> parse_streams(
    std::string_view text, const std::string& file, const RecordingOptions& recording,
    const ConditioningSettings& conditioning, const std::stop_token& stop = {});

}  // namespace aucast::sources

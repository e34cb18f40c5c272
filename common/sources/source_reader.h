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
#include "protocol/limits.h"
#include "protocol/stream_file.h"

namespace aucast::sources {

/// The most bytes that a keyframe takes while a whole stream is thinned, resampled or read from a
/// table.
inline constexpr std::uint64_t kWholeKeyframeBytes = 400;

/// How many lines a text has, the last one without a line end left out: the most keyframes that can
/// be read from it.
[[nodiscard]] std::uint64_t lines_of(std::string_view text);

/// Fails if parse_streams() would leave too little memory for everything else (check_memory());
/// the message names `path`, the text's file.
[[nodiscard]] Result<void> check_room(std::string_view text, const std::filesystem::path& path);

/// How a file is read as keyframes.
struct ReadOptions {
  RecordingOptions recording;
  std::optional<double> rate;         ///< keyframes a second, (0, kRateMax]; nullopt: as they are
  ConditioningSettings conditioning;  ///< its dead band is not applied
  std::uint32_t keyframe_ms =
      protocol::kDefaultKeyframeTime.count();  ///< the time of an untimed keyframe
};

/// The content of a file of either kind.
struct SourceContent {
  protocol::StreamFile stream;
  std::optional<Found> found;  ///< of a recording; nullopt for a stream file
};

/// Reads a stream file or a recogniser's recording; the content shows which it is. Of several
/// faces, one is taken. The path "-" is stdin, which is read to its end. Fails with Unreadable if
/// the keyframes do not fit into memory.
[[nodiscard]] Result<SourceContent> read_source(const std::filesystem::path& path,
                                                const ReadOptions& options = {});
/// The same for the text of the source at `path`.
[[nodiscard]] Result<SourceContent> parse_source(std::string_view text,
                                                 const std::filesystem::path& path,
                                                 const ReadOptions& options);

/// The text of the source at `path`. If asked to stop, reads a file no further and returns
/// stopped_early().
[[nodiscard]] Result<std::string> read_text(const std::filesystem::path& path,
                                            const std::stop_token& stop = {});
/// What messages call the source at `path`: "stdin" for "-", else the path.
[[nodiscard]] std::string name_of(const std::filesystem::path& path);

/// Reads a text that messages call `file`, with its keyframes as they are. With
/// recording.all_faces, returns one stream for each face, the most frequent first; otherwise one
/// stream. If asked to stop, returns stopped_early() at the next line.
[[nodiscard]] Result<std::vector<SourceContent>> parse_streams(
    std::string_view text, const std::string& file, const RecordingOptions& recording,
    const ConditioningSettings& conditioning, const std::stop_token& stop = {});

}  // namespace aucast::sources

#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "common/result.h"
#include "common/sources/conditioning.h"
#include "common/sources/recording.h"
#include "protocol/encoded_stream.h"
#include "protocol/limits.h"
#include "protocol/packet.h"
#include "server/settings/source_options.h"
#include "server/settings/voice_options.h"
#include "server/streams/stream_summary.h"
#include "server/voice/voice_file.h"

namespace aucast::server {

/// A source: a stream file or a recording that was read without errors, or one that is `live`.
struct Source {
  std::filesystem::path path;
  std::string name;  ///< the file's stem; empty: another server will tell it
  std::shared_ptr<const protocol::EncodedStream> stream{};  ///< null if `live`
  StreamSummary summary{};
  std::optional<sources::Found> found{};  ///< what was found in a recording; nullopt for others
  bool live = false;                      ///< nothing was read yet: RunningSources reads it
  std::optional<VoiceFile> voice{};       ///< its voice, not encoded yet; nullopt: none
  /// The stream for clients that get the voice, where it differs from `stream`:
  /// protocol::voiced_stream().
  std::shared_ptr<const protocol::EncodedStream> voiced{};
  std::vector<protocol::CaptionData> captions{};
  protocol::StreamTitle title{};  ///< of a stream file; empty: none
};

/// Which sources are live streams; others are read whole. Files of a folder are never live.
enum class LiveKinds : std::uint8_t {
  None,     ///< none: --check
  Streams,  ///< stdin and FIFOs
  Files,    ///< files too: --follow
};

/// How streams are encoded.
struct EncodingOptions {
  std::uint32_t keyframe_ms =
      protocol::kDefaultKeyframeTime.count();  ///< time of an untimed keyframe
  int classic_min = 20;         ///< percent; AUs below it are left out for classic clients
  std::uint32_t max_kbits = 0;  ///< a second, headers included; 0: no limit
  bool summarise = true;        ///< whether to fill in Source::summary, which only --check needs
  VoiceOptions voice{};
  /// Streams will be sent live: those with a voice are thinned to max_kbits then, not here.
  bool live = false;
};

/// Reads and encodes all files except those that are `live`; of a folder, its .txt and .csv files
/// in the order of their names. If any file is wrong, fails with the errors of all, one per line in
/// the order of the command line; the kind is that of the first error. A name that is no stream
/// name, or occurs twice, is a Usage error; a file that is too large for the free memory is
/// Unreadable. With `skipped`, wrong files are left out and their errors are put there; if no file
/// is left, it fails all the same. When asked to stop, reads no further and fails with
/// stopped_early().
[[nodiscard]] Result<std::vector<Source>> load_sources(
    const std::vector<std::filesystem::path>& paths, const SourceOptions& options = {},
    const EncodingOptions& encoding = {}, const sources::ConditioningSettings& conditioning = {},
    std::vector<Error>* skipped = nullptr, LiveKinds live = LiveKinds::None,
    const std::stop_token& stop = {});

}  // namespace aucast::server

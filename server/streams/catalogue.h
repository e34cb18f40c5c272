#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "common/result.h"
#include "common/sources/recording.h"
#include "common/time.h"
#include "protocol/server_session.h"
#include "protocol/stream_file.h"
#include "server/settings/source_options.h"

namespace aucast::server {

/// A stream file or a recording that was read and found right.
struct Source {
  std::filesystem::path path;
  std::string name;  ///< the file's stem: what a hello asks for
  protocol::StreamFile stream;
  std::optional<sources::Found> found;  ///< of a recording
  bool live = false;                    ///< nothing is read yet: a LiveSource will
};

/// Which sources are live streams; others are read whole. What is in a folder is not live.
enum class LiveSources : std::uint8_t {
  None,     ///< none: --check
  Streams,  ///< stdin and FIFOs
  Files,    ///< files too: --follow
};

/// Reads all files whole but those that are `live`, of a folder its .txt and .csv files by name;
/// `keyframe_ms` is the time of an untimed keyframe when --rate is asked.
/// If any is wrong, the errors of all of them, one a line, in the order of
/// the command line; their kind is that of the first. Names that are no stream names or come twice
/// are usage errors. With `skipped` what is wrong is left out and its errors go there, as long as
/// anything is left.
[[nodiscard]] Result<std::vector<Source>> load_sources(
    const std::vector<std::filesystem::path>& paths, const SourceOptions& options = {},
    std::uint32_t keyframe_ms = 250, std::vector<Error>* skipped = nullptr,
    LiveSources live = LiveSources::None);

/// How the streams are served.
struct CatalogueOptions {
  std::uint32_t keyframe_ms = 250;
  int classic_min = 20;  ///< percent; weaker AUs are left out for classic clients
  bool loop = false;
  std::uint32_t max_kbits = 0;  ///< a second, headers included; 0: no limit
};

/// Encodes every stream once per level, in the order given; of a source that is live only the name
/// is known yet. Needs at least one source.
[[nodiscard]] protocol::ServerCatalogue make_catalogue(const std::vector<Source>& sources,
                                                       const CatalogueOptions& options);

/// Whether the streams can be sent live: one that starts again must take some time. Bad data
/// otherwise.
[[nodiscard]] Result<void> check_live(const protocol::ServerCatalogue& catalogue);

/// How many bytes of the busiest stream's keyframes go out in `time`, rounded up.
[[nodiscard]] std::size_t bytes_in(const protocol::ServerCatalogue& catalogue, Milliseconds time);

}  // namespace aucast::server

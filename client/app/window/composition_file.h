#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "client/gui/composer.h"
#include "client/gui/gui_model.h"
#include "client/playback/keyframe_source.h"
#include "common/result.h"

namespace aucast::app {

/// The keyframes of a stream file. Unreadable, or BadData with a line for each error.
[[nodiscard]] Result<std::vector<playback::TimedAus>> read_stream(
    const std::filesystem::path& file);

/// What was opened to be played.
struct OpenedStream {
  std::vector<playback::TimedAus> keyframes;  ///< at least one
  std::string found;  ///< a sentence about a recogniser's table; empty for a stream file
};

/// Reads a stream file or the table of a recogniser, told apart by what is in it; `settings` are
/// for tables. Unreadable, BadData with a line for each error, Usage when a table needs a setting.
[[nodiscard]] Result<OpenedStream> open_stream(const std::filesystem::path& file,
                                               const gui::TableSettings& settings);

/// A keyframe that was read or received, as the composer has them.
[[nodiscard]] gui::ComposedKeyframe composed(const playback::TimedAus& keyframe);

/// The text of a stream file with these keyframes, read back by the same reader before it is handed
/// out. Failed when there is none.
[[nodiscard]] Result<std::string> stream_text(const gui::Composer::Keyframes& keyframes);

/// Writes that text whole or not at all and returns a sentence about where it went. A file that
/// says something else stays beside it with a ~ at its end, because it may have comments.
[[nodiscard]] Result<std::string> save_stream(const gui::Composer::Keyframes& keyframes,
                                              const std::filesystem::path& file);

}  // namespace aucast::app

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "client/gui/model/gui_model.h"
#include "client/playback/keyframe_list.h"
#include "common/result.h"
#include "common/sources/recording.h"

namespace aucast::app {

/// What read_stream() returns.
struct TitledStream {
  playback::KeyframeList keyframes;  ///< at least one
  std::string title;                 ///< byte for byte as in the file; empty: none
};

/// Reads a stream file that will be edited. Fails with Unreadable, also where editing takes more
/// memory than there is, or with BadData and a line for each error.
[[nodiscard]] Result<TitledStream> read_stream(const std::filesystem::path& file);

/// The result of open_stream().
struct OpenedStream {
  playback::KeyframeList keyframes;  ///< at least one
  std::string found;  ///< a sentence about a recogniser's table; empty for a stream file
  std::vector<std::string> warnings;  ///< one sentence for each oddity of the file
};

/// The names by which messages call the settings of a table: those of the file dialog (file.fps and
/// file.neutral in the table of texts), or the options of the command line.
inline constexpr sources::SettingNames kDialogNames{"Pictures/s", "'Neutral, s'"};
inline constexpr sources::SettingNames kOptionNames{"--table-fps", "--table-neutral"};

/// Reads a stream file or the table of a recogniser, and tells them apart by their content.
/// `settings`: how to read a table; `names`: what messages call the settings. Fails with
/// Unreadable, also of a stream that does not fit into memory, with BadData and a line for each
/// error, or with Usage if a table needs a setting.
[[nodiscard]] Result<OpenedStream> open_stream(const std::filesystem::path& file,
                                               const gui::TableSettings& settings,
                                               const sources::SettingNames& names);
/// The same for a file and settings from the command line. Logs what was found and returns the
/// keyframes.
[[nodiscard]] Result<playback::KeyframeList> open_typed_stream(const std::filesystem::path& file,
                                                               const gui::TableSettings& settings);

}  // namespace aucast::app

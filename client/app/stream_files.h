#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "client/gui/model/gui_model.h"
#include "client/playback/keyframe_source.h"
#include "common/result.h"
#include "common/sources/recording.h"

namespace aucast::app {

/// What a stream file has.
struct TitledStream {
  std::vector<playback::Keyframe> keyframes;  ///< at least one
  std::string title;                          ///< byte for byte as in the file; empty: none
};

/// Reads a stream file. Unreadable, or BadData with a line for each error.
[[nodiscard]] Result<TitledStream> read_stream(const std::filesystem::path& file);

/// The result of open_stream().
struct OpenedStream {
  std::vector<playback::Keyframe> keyframes;  ///< at least one
  std::string found;  ///< a sentence about a recogniser's table; empty for a stream file
  std::vector<std::string> warnings;  ///< what the reader finds odd in the file, a sentence each
};

/// What messages call the settings of a table: as the file dialog does (file.fps and file.neutral
/// in the table of texts), or as options on the command line.
inline constexpr sources::SettingNames kDialogNames{"Pictures/s", "'Neutral, s'"};
inline constexpr sources::SettingNames kOptionNames{"--table-fps", "--table-neutral"};

/// Reads a stream file or the table of a recogniser, which are told apart by their content.
/// `settings`: for tables, called by `names`. Unreadable; BadData with a line for each error; Usage
/// if a table needs a setting.
[[nodiscard]] Result<OpenedStream> open_stream(const std::filesystem::path& file,
                                               const gui::TableSettings& settings,
                                               const sources::SettingNames& names);
/// The same for a file and settings that were typed, with what was found in the log. Returns the
/// keyframes.
[[nodiscard]] Result<std::vector<playback::Keyframe>> open_typed_stream(
    const std::filesystem::path& file, const gui::TableSettings& settings);

}  // namespace aucast::app

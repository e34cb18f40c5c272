#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "client/gui/model/browser_view.h"
#include "client/gui/model/picture_settings.h"
#include "common/action_unit.h"
#include "common/result.h"

namespace aucast::app {

inline constexpr const char* kComposedName = "composed.txt";

/// What the window shows, as far as it is used in names of files.
struct Named {
  std::string face;
  std::string stream;                 ///< name of what plays, without a file's ending; empty: none
  std::uint64_t keyframe = 0;         ///< the one that is shown, counted from 1; 0: none
  std::optional<AuFrame> aus;         ///< the AUs that make the face; nullopt: muscles make it
  std::string edited;                 ///< name if muscles make the face, such as au12_edited
  std::filesystem::path composition;  ///< the composer's file; empty: none
  int au = 0;                         ///< the AU being edited; 0: none
};

/// The name that is suggested for a new file; empty: the purpose is to open one.
[[nodiscard]] std::string new_file_name(gui::Purpose purpose, const Named& shown);

/// Returns a path for a new picture or video: the first path of the pattern at which there is no
/// file yet. {date} in the pattern is `date`. A pattern without {number} gets -2, -3 and so on
/// where needed. Makes the folder, and fails if that is not possible.
[[nodiscard]] Result<std::filesystem::path> new_picture_file(const gui::PictureSettings& settings,
                                                             const Named& shown,
                                                             const std::string& date,
                                                             const std::string& ending);

}  // namespace aucast::app

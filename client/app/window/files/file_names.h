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
  std::string stream;                 ///< name of what plays, without an ending; empty: it has none
  std::uint64_t keyframe = 0;         ///< the one that is shown, counted from 1; 0: none
  std::optional<AuFrame> aus;         ///< the AUs of which the face is made; nullopt: muscles
  std::string edited;                 ///< what a face made of muscles shows, as part of a name
  std::filesystem::path composition;  ///< the composer's file; empty: none
  int au = 0;                         ///< the AU being edited; 0: none
};

/// The name that is suggested for a new file.
[[nodiscard]] std::string new_file_name(gui::Purpose purpose, const Named& shown);

/// A path for a new picture or video: the first one by the pattern that does not exist yet, so that
/// no file is overwritten. {date} in the pattern is today. A pattern without {number} gets -2, -3
/// and so on where needed. Makes the folder; fails if it cannot.
[[nodiscard]] Result<std::filesystem::path> new_picture_file(const gui::PictureSettings& settings,
                                                             const Named& shown,
                                                             const std::string& ending);

}  // namespace aucast::app

#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "client/gui/file_browser.h"
#include "client/gui/picture_settings.h"
#include "common/action_unit.h"
#include "common/result.h"

namespace aucast::app {

inline constexpr const char* kComposedName = "composed.txt";

/// What the window shows, as far as files are named after it.
struct Named {
  std::string face;
  std::string stream;                 ///< what plays, without an ending; empty: it has no name
  std::uint64_t keyframe = 0;         ///< that is shown, from 1; 0: none
  std::optional<AuFrame> aus;         ///< that the face is made of
  std::string edited;                 ///< what the face is when it is made of no AUs
  std::filesystem::path composition;  ///< the composer's file; empty: none
  int au = 0;                         ///< that is edited; 0: none
};

/// What a new file is called at first.
[[nodiscard]] std::string new_file_name(gui::Purpose purpose, const Named& shown);

/// A new file for a picture or a video, with today's date. See gui::picture_file().
[[nodiscard]] Result<std::filesystem::path> new_picture_file(const gui::PictureSettings& settings,
                                                             const Named& shown,
                                                             const std::string& ending);

}  // namespace aucast::app

#pragma once

#include <string>
#include <string_view>

#include "common/result.h"

namespace aucast::gui {

inline constexpr int kPictureSideMin = 16;
inline constexpr int kPictureSideMax = 4096;

/// Where pictures and videos made in the window go, and how large they are.
struct PictureSettings {
  std::string folder;                            ///< empty: the current one
  std::string pattern = "face-player-{number}";  ///< for picture_name(); may be invalid while it is
                                                 ///< typed
  int width = 0;  ///< pixels, kPictureSideMin to kPictureSideMax; 0: as the window shows the face
  int height = 0;
  friend bool operator==(const PictureSettings&, const PictureSettings&) = default;
};

/// What the words of a pattern stand for now. There is also {number}, which counts from 1.
struct PictureWords {
  std::string face;      ///< {face}
  std::string stream;    ///< {stream}; empty: nothing plays
  std::string keyframe;  ///< {keyframe}; empty: none
  std::string aus;       ///< {aus}; empty: none
  std::string date;      ///< {date}
};

/// The file name for a pattern, without its ending. A character that names may not have is replaced
/// by '-', and a word that stands for nothing by "none". Fails with Usage for an unknown word, and
/// for a pattern that is empty or has a '/'.
[[nodiscard]] Result<std::string> picture_name(std::string_view pattern, const PictureWords& words,
                                               int number);

}  // namespace aucast::gui

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "common/result.h"

namespace aucast::gui {

inline constexpr int kPictureSideMin = 16;
inline constexpr int kPictureSideMax = 4096;

/// Where pictures and videos of the window go, and how large they are.
struct PictureSettings {
  std::string folder;                            ///< empty: the current one
  std::string pattern = "face-player-{number}";  ///< as picture_name() takes it, if it is right
  int width = 0;  ///< pixels, kPictureSideMin to kPictureSideMax; 0: as the window shows the face
  int height = 0;
  friend bool operator==(const PictureSettings&, const PictureSettings&) = default;
};

/// What the words of a pattern stand for at this moment; beside these {number} counts from 1.
struct PictureWords {
  std::string face;      ///< {face}
  std::string stream;    ///< {stream}; empty: nothing plays
  std::string keyframe;  ///< {keyframe}; empty: none
  std::string aus;       ///< {aus}; empty: there are none
  std::string date;      ///< {date}
};

/// The name that a pattern means, without its ending. What cannot stand in a name becomes '-'; a
/// word that stands for nothing becomes "none". Usage error for a word that is not known, and for a
/// pattern that is empty or has a '/'.
[[nodiscard]] Result<std::string> picture_name(std::string_view pattern, const PictureWords& words,
                                               int number);

/// The first file of that pattern that is not there yet: what is there is never overwritten. A
/// pattern without {number} gets -2, -3 and so on when it must. Makes the folder. Failed when it
/// cannot be made.
[[nodiscard]] Result<std::filesystem::path> picture_file(const PictureSettings& settings,
                                                         const PictureWords& words,
                                                         const std::string& ending);

}  // namespace aucast::gui

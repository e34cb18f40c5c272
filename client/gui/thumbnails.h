#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace aucast::gui {

// Of thumbnails, in pixels at scale 1; they are drawn at twice that.
inline constexpr int kFaceWidth = 112;
inline constexpr int kFaceHeight = 128;
inline constexpr int kKeyframeWidth = 40;
inline constexpr int kKeyframeHeight = 44;

/// Small pictures in a panel, by the names of what they show. The panel says which are seen; who
/// draws them puts their textures here.
struct Thumbnails {
  std::map<std::string, std::uintptr_t> textures;  ///< by the names that ImGui's backend takes
  std::vector<std::string> seen;                   ///< as of the last frame
};

}  // namespace aucast::gui

#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace aucast::gui {

// Sizes of thumbnails in the window at scale 1; the pictures are made at twice these sizes.
inline constexpr int kFaceWidth = 112;
inline constexpr int kFaceHeight = 128;
inline constexpr int kKeyframeWidth = 40;
inline constexpr int kKeyframeHeight = 44;

/// Small pictures in a panel, by the names of what they show. The panel says which ones are seen;
/// the thumbnail maker puts their textures here.
struct Thumbnails {
  std::map<std::string, std::uintptr_t> textures;  ///< ImGui's texture IDs
  std::map<std::string, std::string> wrong;        ///< why there is no picture, a sentence
  std::vector<std::string> seen;                   ///< names of those seen in the last frame
};

}  // namespace aucast::gui

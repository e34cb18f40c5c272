#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "client/app/film/face_view.h"
#include "client/face/face.h"
#include "client/gui/thumbnails.h"
#include "client/render/picture_texture.h"

namespace aucast::app {

/// Small pictures of what the face does at keyframes, drawn off screen when they are seen and kept
/// as textures. The context must be current whenever it is used. Thread: the player's.
class KeyframeThumbnails {
 public:
  /// The activations of the face with these AUs, one per channel.
  using FaceOf = std::function<std::vector<float>(const std::string& aus)>;

  /// Draws one of those that are seen and have no picture, or one that the face no longer looks
  /// like, with the view of that face, which has another pose afterwards. True when it did; another
  /// framebuffer is bound then. `scale`: pixels of the picture in one of the screen at scale 1.
  [[nodiscard]] bool advance(gui::Thumbnails& pictures, const FaceOf& face_of,
                             const face::Face& face, FaceView& view, float scale);
  /// The face has become another one.
  void forget(gui::Thumbnails& pictures);

 private:
  struct Drawn {
    std::vector<float> activations;
    render::PictureTexture texture;
  };

  std::map<std::string, Drawn> drawn_;  ///< by AUs
};

}  // namespace aucast::app

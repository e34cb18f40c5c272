#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "client/app/video/face_view.h"
#include "client/face/face.h"
#include "client/gui/model/thumbnails.h"
#include "client/render/picture_texture.h"

namespace aucast::app {

/// Small pictures of the face at keyframes. Each is drawn into a framebuffer off screen when its
/// keyframe comes into view, and kept as a texture. The context must be current whenever this is
/// used. Thread: the player's.
class KeyframeThumbnails {
 public:
  /// Returns the activations of the face for these AUs, one per channel.
  using FaceOf = std::function<std::vector<float>(const std::string& aus)>;

  /// Draws at most one picture: for a keyframe that is seen and has none, or whose face has
  /// changed. Returns true if it has drawn one; another framebuffer is bound then. `view` must be a
  /// view of `face`; its pose changes. `scale`: pixels of the picture per unit of
  /// gui::kKeyframeWidth.
  [[nodiscard]] bool advance(gui::Thumbnails& pictures, const FaceOf& face_of,
                             const face::Face& face, FaceView& view, float scale);
  /// Removes all pictures, because the face has been replaced.
  void forget(gui::Thumbnails& pictures);

 private:
  struct Drawn {
    std::vector<float> activations;
    render::PictureTexture texture;
  };

  std::map<std::string, Drawn> drawn_;  ///< by AUs
};

}  // namespace aucast::app

#include "client/app/window/thumbnails/keyframe_thumbnails.h"

#include <cmath>
#include <utility>

#include "client/app/video/shot.h"

namespace aucast::app {
namespace {

/// More than are ever seen at once, and little memory.
constexpr std::size_t kKeptMax = 200;
/// The part of the portrait's height that is drawn: hair and shirt say nothing about a keyframe.
constexpr float kShown = 0.6F;

}  // namespace

bool KeyframeThumbnails::advance(gui::Thumbnails& pictures, const FaceOf& face_of,
                                 const face::Face& face, FaceView& view, float scale) {
  for (const std::string& aus : pictures.seen) {
    std::vector<float> activations = face_of(aus);
    const auto found = drawn_.find(aus);
    if (found != drawn_.end() && found->second.activations == activations) continue;
    if (found == drawn_.end() && drawn_.size() >= kKeptMax) forget(pictures);
    const auto pixels = [scale](int size) {
      return static_cast<int>(std::lround(scale * static_cast<float>(size)));
    };
    // If the driver cannot draw this picture, it cannot draw the next ones of the same size either.
    if (!view.prepare(pixels(gui::kKeyframeWidth), pixels(gui::kKeyframeHeight), Sharpness::Still))
      return false;
    view.pose(activations);
    view::Viewpoint viewpoint = viewpoint_of(view::ViewpointPreset::Front, face);
    viewpoint.half_height *= kShown;
    view::Style style;
    style.scale = 0.5F;
    Drawn& drawn = drawn_[aus];
    drawn.activations = std::move(activations);
    drawn.texture.show(view.picture(viewpoint, style));
    pictures.textures[aus] = drawn.texture.id();
    return true;
  }
  return false;
}

void KeyframeThumbnails::forget(gui::Thumbnails& pictures) {
  drawn_.clear();
  pictures.textures.clear();
}

}  // namespace aucast::app

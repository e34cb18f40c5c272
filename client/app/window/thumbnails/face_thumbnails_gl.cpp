#include "client/app/window/thumbnails/face_thumbnails.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "client/app/video/face_view.h"
#include "client/app/video/shot.h"

namespace aucast::app {

FaceThumbnails::FaceThumbnails(std::filesystem::path data_folder, int width, int height)
    : data_folder_(std::move(data_folder)), width_(width), height_(height) {}

FaceThumbnails::~FaceThumbnails() = default;

void FaceThumbnails::keep_listed(const std::vector<gui::FaceEntry>& faces,
                                 gui::Thumbnails& pictures) {
  const auto gone = [&](const auto& picture) {
    return std::none_of(faces.begin(), faces.end(),
                        [&](const gui::FaceEntry& face) { return face.folder == picture.first; });
  };
  std::erase_if(pictures.textures, gone);
  std::erase_if(pictures.wrong, gone);
  std::erase_if(textures_, gone);
  if (gone(std::pair(folder_, 0))) folder_.clear();
}

bool FaceThumbnails::advance(gui::Thumbnails& pictures) {
  if (!reading_.running()) {
    const auto next = std::find_if(pictures.seen.begin(), pictures.seen.end(),
                                   [this](const auto& one) { return !textures_.contains(one); });
    if (next == pictures.seen.end()) return false;
    folder_ = *next;
    const auto begun = reading_.start(
        [folder = folder_, data = data_folder_] { return face::load_face(folder, data); });
    if (!begun) textures_[folder_] = nullptr;
    return false;
  }
  const std::optional<Result<face::Face>> face = reading_.take();
  if (!face || folder_.empty()) return false;
  auto& texture = textures_[folder_] = *face ? draw(**face) : nullptr;
  if (!*face) pictures.wrong[folder_] = face->error().message;
  if (texture == nullptr) return !face->has_value();
  pictures.textures[folder_] = texture->id();
  return true;
}

std::unique_ptr<render::PictureTexture> FaceThumbnails::draw(const face::Face& face) const {
  auto view = FaceView::create_neutral(face);
  if (!view || !(*view)->prepare(width_, height_, Sharpness::Still)) return nullptr;
  view::Style style;
  style.scale = 0.5F;
  const view::Image image =
      (*view)->picture(viewpoint_of(view::ViewpointPreset::Front, face), style);
  auto texture = std::make_unique<render::PictureTexture>();
  texture->show(image);
  return texture;
}

}  // namespace aucast::app

#include "client/app/window/face_thumbnails.h"

#include <algorithm>
#include <chrono>
#include <system_error>
#include <utility>

#include "client/app/film/face_view.h"
#include "client/app/film/shot.h"

namespace aucast::app {

FaceThumbnails::FaceThumbnails(std::filesystem::path data_folder, int width, int height)
    : data_folder_(std::move(data_folder)), width_(width), height_(height) {}

FaceThumbnails::~FaceThumbnails() = default;

bool FaceThumbnails::advance(const std::vector<std::string>& wanted) {
  if (!reading_.valid()) {
    const auto next = std::find_if(wanted.begin(), wanted.end(),
                                   [this](const auto& one) { return !textures_.contains(one); });
    if (next == wanted.end()) return false;
    folder_ = *next;
    try {
      reading_ = std::async(std::launch::async, [folder = folder_, data = data_folder_] {
        return face::load_face(folder, data);
      });
    } catch (const std::system_error&) {
      textures_[folder_] = nullptr;  // no thread is to be had
    }
    return false;
  }
  if (reading_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return false;
  const Result<face::Face> face = reading_.get();
  textures_[folder_] = nullptr;
  if (!face) return false;
  draw(*face);
  return true;
}

void FaceThumbnails::draw(const face::Face& face) {
  auto view = FaceView::create_at_rest(face);
  if (!view || !(*view)->prepare(width_, height_, Sharpness::Still)) return;
  view::Style style;
  style.scale = 0.5F;
  const view::Image image = (*view)->picture(viewpoint_preset("front", face), style);
  std::vector<std::uint8_t> rgb;
  rgb.reserve(image.rgba.size() / 4 * 3);
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    rgb.insert(rgb.end(), image.rgba.begin() + static_cast<std::ptrdiff_t>(i),
               image.rgba.begin() + static_cast<std::ptrdiff_t>(i) + 3);
  }
  auto texture = std::make_unique<render::PictureTexture>();
  texture->show(static_cast<std::size_t>(image.width), static_cast<std::size_t>(image.height), rgb);
  textures_[folder_] = std::move(texture);
}

std::uintptr_t FaceThumbnails::texture(const std::string& folder) const {
  const auto found = textures_.find(folder);
  return found == textures_.end() || found->second == nullptr ? 0 : found->second->id();
}

}  // namespace aucast::app

#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "client/face/face.h"
#include "client/gui/model/gui_model.h"
#include "client/gui/model/thumbnails.h"
#include "client/render/picture_texture.h"
#include "common/result.h"
#include "common/task.h"

namespace aucast::app {

/// Small pictures of neutral faces, each drawn once off screen and kept as a texture. The context
/// must be current whenever this is used. Thread: the player's. Faces are read on another thread,
/// so that the window goes on meanwhile; the destructor waits for that thread.
class FaceThumbnails {
 public:
  /// `width` and `height` of the pictures, in pixels.
  FaceThumbnails(std::filesystem::path data_folder, int width, int height);
  ~FaceThumbnails();
  FaceThumbnails(const FaceThumbnails&) = delete;
  FaceThumbnails& operator=(const FaceThumbnails&) = delete;

  /// Forgets the pictures of faces that are not listed any more: another face may get their name.
  void keep_listed(const std::vector<gui::FaceEntry>& faces, gui::Thumbnails& pictures);
  /// Goes on making pictures, one after the other, of the faces whose folders are in
  /// `pictures.seen`. Returns true if there is something new to see; another framebuffer may be
  /// bound then.
  [[nodiscard]] bool advance(gui::Thumbnails& pictures);
  /// Whether a face is being read.
  [[nodiscard]] bool busy() const { return reading_.running(); }

 private:
  [[nodiscard]] std::unique_ptr<render::PictureTexture> draw(const face::Face& face) const;

  std::filesystem::path data_folder_;
  int width_;
  int height_;
  /// By folder. Null for a face that could not be read, which is not tried again.
  std::map<std::string, std::unique_ptr<render::PictureTexture>> textures_;
  std::string folder_;  ///< the folder of the face that is being read; empty: the face is not
                        ///< listed any more
  Task<Result<face::Face>> reading_;
};

}  // namespace aucast::app

#pragma once

#include <memory>
#include <span>

#include "client/app/film/face_view.h"
#include "client/face/face.h"
#include "client/view/image.h"
#include "client/view/scene.h"
#include "client/view/style.h"
#include "common/result.h"

namespace aucast::app {

/// Activations in, picture out, without a display. In a build without OpenGL create() fails and
/// says so.
/// The face must outlive it. Thread: the one that made it.
class PictureMaker {
 public:
  [[nodiscard]] static Result<std::unique_ptr<PictureMaker>> create(
      const face::Face& face, int width, int height, const view::Viewpoint& viewpoint,
      const view::Background& behind, Sharpness sharpness);
  ~PictureMaker();
  PictureMaker(const PictureMaker&) = delete;
  PictureMaker& operator=(const PictureMaker&) = delete;

  /// What is drawn of the face from now on; in the beginning the textured surface.
  void show(const view::Layers& layers);

  /// Same activations, same bytes.
  [[nodiscard]] view::Image picture(std::span<const float> activations);

 private:
  struct State;
  explicit PictureMaker(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace aucast::app

#pragma once

#include <memory>
#include <span>

#include "client/app/player_options.h"
#include "client/app/video/face_view.h"
#include "client/face/face.h"
#include "client/view/image.h"
#include "client/view/viewpoint.h"
#include "common/result.h"

namespace aucast::app {

/// Makes pictures from activations, without a display. In a build without OpenGL create() fails and
/// says so. The face must outlive it. Thread: the one that made it.
class PictureMaker {
 public:
  /// Size, background and layers are those of `output`.
  [[nodiscard]] static Result<std::unique_ptr<PictureMaker>> create(const face::Face& face,
                                                                    const OutputOptions& output,
                                                                    view::ViewpointPreset viewpoint,
                                                                    Sharpness sharpness);
  ~PictureMaker();
  PictureMaker(const PictureMaker&) = delete;
  PictureMaker& operator=(const PictureMaker&) = delete;

  /// The same activations and hair, as FaceView::pose() takes them, give the same bytes.
  [[nodiscard]] view::Image picture(std::span<const float> activations,
                                    const face::HairSway& hair = {});

 private:
  struct State;
  explicit PictureMaker(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace aucast::app

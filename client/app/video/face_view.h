#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "client/face/face.h"
#include "client/face/face_deformer.h"
#include "client/view/image.h"
#include "client/view/scene.h"
#include "client/view/style.h"
#include "common/result.h"

namespace aucast::app {

/// A Video picture is drawn fast. A Still is drawn with four times the pixels and scaled down, so
/// that strands of hair and lashes are smooth, unless the driver cannot make so large a picture.
enum class Sharpness : std::uint8_t { Video, Still };

/// A face with everything that turns activations into a picture: deformer, drawing of the muscles,
/// renderer. The face must outlive it. Needs a current OpenGL context as long as it lives.
/// Thread: the one the context is current on.
class FaceView {
 public:
  [[nodiscard]] static Result<std::unique_ptr<FaceView>> create(const face::Face& face);
  /// As create(face), with a ready-made deformer of that face.
  [[nodiscard]] static Result<std::unique_ptr<FaceView>> create(const face::Face& face,
                                                                face::FaceDeformer deformer);
  /// As create(face), but makes the view in portions. Until make_more() has returned true, the view
  /// draws the neutral face, whatever its pose.
  [[nodiscard]] static Result<std::unique_ptr<FaceView>> create_neutral(const face::Face& face);
  /// Makes the next portion, which takes a few milliseconds. Returns true when nothing is left to
  /// do.
  bool make_more();
  ~FaceView();
  FaceView(const FaceView&) = delete;
  FaceView& operator=(const FaceView&) = delete;

  /// See render::FaceRenderer::renew_shaders().
  [[nodiscard]] Result<void> renew_shaders();
  /// Sets the pose that is drawn; initially it is the neutral face. `activations`: one per channel;
  /// `hair`: how far it is from where it hangs at rest; zero unless the head has moved.
  void pose(std::span<const float> activations, const face::HairSway& hair = {});

  /// Clears and draws into the bound framebuffer. The diagram and tags of `style` are replaced by
  /// those that its layers ask for.
  void draw(const view::Viewpoint& viewpoint, view::Style style, int width, int height);

  /// Prepares picture() for pictures of one size. Fails if the driver cannot draw them.
  [[nodiscard]] Result<void> prepare(int width, int height, Sharpness sharpness);
  /// A picture of the size prepared last; with a transparent background the face is drawn twice.
  /// Leaves a framebuffer of its own bound. The same pose, viewpoint and style give the same bytes.
  [[nodiscard]] view::Image picture(const view::Viewpoint& viewpoint, view::Style style);

 private:
  struct State;
  explicit FaceView(std::unique_ptr<State> state);
  /// With nothing to draw yet.
  [[nodiscard]] static Result<std::unique_ptr<FaceView>> create_bare(const face::Face& face);
  void show_pose();
  std::unique_ptr<State> state_;
};

}  // namespace aucast::app

#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "client/face/face.h"
#include "client/view/image.h"
#include "client/view/scene.h"
#include "client/view/style.h"
#include "common/result.h"

namespace aucast::app {

/// Film is for many pictures. A Still is drawn with four times the pixels, if the driver can make
/// so large a picture, and scaled down, so that strands of hair and lashes do not flicker.
enum class Sharpness : std::uint8_t { Film, Still };

/// A face with all that turns activations into a picture: deformer, drawing of the muscles,
/// renderer. The face must outlive it. Needs a current OpenGL context for all its life.
/// Thread: the one the context is current on.
class FaceView {
 public:
  [[nodiscard]] static Result<std::unique_ptr<FaceView>> create(const face::Face& face);
  /// The same in portions: at first it draws the face at rest, whatever its pose.
  [[nodiscard]] static Result<std::unique_ptr<FaceView>> create_at_rest(const face::Face& face);
  /// The next portion, of a few milliseconds. True when there is nothing left to do.
  bool make_more();
  ~FaceView();
  FaceView(const FaceView&) = delete;
  FaceView& operator=(const FaceView&) = delete;

  /// Sets what is drawn from here on; at first the face at rest. One activation per channel.
  void pose(std::span<const float> activations);

  /// Clears and draws into the bound framebuffer. `style` without its diagram and tags, which this
  /// makes as its layers ask for them.
  void draw(const view::Viewpoint& viewpoint, view::Style style, int width, int height);

  /// Makes room for pictures of one size. Failed when the driver cannot draw them.
  [[nodiscard]] Result<void> prepare(int width, int height, Sharpness sharpness);
  /// A picture of the size prepared last; with a transparent background it is drawn twice. Leaves a
  /// framebuffer of its own bound. Same pose, viewpoint and style, same bytes.
  [[nodiscard]] view::Image picture(const view::Viewpoint& viewpoint, view::Style style);

 private:
  struct State;
  explicit FaceView(std::unique_ptr<State> state);
  void show_pose();
  std::unique_ptr<State> state_;
};

}  // namespace aucast::app

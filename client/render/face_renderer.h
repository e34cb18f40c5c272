#pragma once

#include <memory>

#include "client/view/scene.h"
#include "client/view/style.h"
#include "common/result.h"

namespace aucast::render {

/// Draws a face with OpenGL 3.3 core or OpenGL ES 3.0 into whatever framebuffer is bound. The same
/// for window and headless. Needs a current context for all its life. Thread: the one the context
/// is current on.
class FaceRenderer {
 public:
  /// Failed, with the compiler's words, when the shaders do not build.
  [[nodiscard]] static Result<std::unique_ptr<FaceRenderer>> create();
  ~FaceRenderer();
  FaceRenderer(const FaceRenderer&) = delete;
  FaceRenderer& operator=(const FaceRenderer&) = delete;

  /// Takes over a face; pose() must follow.
  void load(const view::StaticMesh& mesh);
  /// What draw() shows from here on. Borrows what is not per vertex until the next call.
  void pose(const view::MovingMesh& mesh);
  /// Clears and draws into the bound framebuffer; width and height in pixels.
  void draw(const view::Viewpoint& viewpoint, const view::Style& style, int width, int height);

 private:
  struct State;
  explicit FaceRenderer(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace aucast::render

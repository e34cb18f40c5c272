#pragma once

#include <memory>

#include "client/view/scene.h"
#include "client/view/style.h"
#include "common/result.h"

namespace aucast::render {

/// Draws a face with OpenGL 3.3 core or OpenGL ES 3.0 into whatever framebuffer is bound, in a
/// window or without one. Needs a current context as long as it lives. Thread: the one the context
/// is current on.
class FaceRenderer {
 public:
  /// Fails with the compiler's messages if the shaders do not build.
  [[nodiscard]] static Result<std::unique_ptr<FaceRenderer>> create();
  ~FaceRenderer();
  FaceRenderer(const FaceRenderer&) = delete;
  FaceRenderer& operator=(const FaceRenderer&) = delete;

  /// Builds the shaders anew if files of AUCAST_SHADERS have changed. If that fails, the old ones
  /// stay.
  [[nodiscard]] Result<void> renew_shaders();
  /// Loads a face to draw from now on; pose() must follow before draw().
  void load(const view::StaticMesh& mesh);
  /// Sets the pose that draw() shows. Until the next call, borrows the arrays of `mesh` that do not
  /// have one entry per vertex.
  void pose(const view::MovingMesh& mesh);
  /// Clears and draws into the bound framebuffer; width and height in pixels.
  void draw(const view::Viewpoint& viewpoint, const view::Style& style, int width, int height);

 private:
  struct State;
  explicit FaceRenderer(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace aucast::render

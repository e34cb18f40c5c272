#pragma once

#include <span>

#include <glm/mat4x4.hpp>

#include "client/render/gl_objects.h"
#include "client/view/style.h"
#include "common/result.h"

namespace aucast::render {

/// Draws straight lines and dots of a width in pixels. Needs a current context for all its life.
/// Thread: the one the context is current on.
class SegmentRenderer {
 public:
  [[nodiscard]] static Result<SegmentRenderer> create();

  /// Takes over what is drawn next; camera and size of the picture.
  void load(std::span<const view::Segment> segments, const glm::mat4& world_to_clip, int width,
            int height, float scale);
  /// Blends them over the picture with their opacity times `alpha`. The depth test is the caller's.
  void draw(float alpha);

 private:
  explicit SegmentRenderer(Program program);

  Program program_;
  VertexArray array_;
  Buffer segments_;
  GLsizei count_ = 0;
};

}  // namespace aucast::render

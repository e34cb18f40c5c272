#pragma once

#include <span>

#include "client/render/gl_objects.h"
#include "client/view/style.h"

namespace aucast::render {

/// Draws straight lines and dots of a width in pixels. Needs a current context for all its life.
/// Thread: the one the context is current on.
class SegmentRenderer {
 public:
  SegmentRenderer();

  /// What draw() draws from here on.
  void load(std::span<const view::Segment> segments);
  /// Blends them over the picture with their opacity times `alpha`. The depth test is the caller's.
  void draw(const Program& program, float alpha) const;

 private:
  VertexArray array_;
  Buffer segments_;
  GLsizei count_ = 0;
};

}  // namespace aucast::render

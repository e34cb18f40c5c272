#pragma once

#include <span>

#include "client/render/gl_objects.h"
#include "client/view/style.h"

namespace aucast::render {

/// Draws straight lines and dots whose width is given in pixels. Needs a current context as long as
/// it lives.
/// Thread: the one the context is current on.
class SegmentRenderer {
 public:
  SegmentRenderer();

  /// Sets what draw() draws.
  void load(std::span<const view::Segment> segments);
  /// Blends the segments over the picture with their opacity times `alpha`. The caller sets the
  /// depth test.
  void draw(const Program& program, float alpha) const;

 private:
  VertexArray array_;
  Buffer segments_;
  GLsizei count_ = 0;
};

}  // namespace aucast::render

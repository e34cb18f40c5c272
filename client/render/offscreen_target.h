#pragma once

#include <memory>

#include "client/view/image.h"
#include "common/result.h"

namespace aucast::render {

/// A multisampled framebuffer of our own, so that pictures do not depend on a window's. Needs a
/// current context as long as it lives.
class OffscreenTarget {
 public:
  /// Makes one with 4 samples where possible. Fails if the driver cannot do that size.
  [[nodiscard]] static Result<std::unique_ptr<OffscreenTarget>> create(int width, int height);
  ~OffscreenTarget();
  OffscreenTarget(const OffscreenTarget&) = delete;
  OffscreenTarget& operator=(const OffscreenTarget&) = delete;

  void bind();
  /// Resolves the samples and returns what was drawn, with alpha 255.
  [[nodiscard]] view::Image read();

 private:
  struct State;
  explicit OffscreenTarget(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace aucast::render

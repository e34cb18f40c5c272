#pragma once

#include <memory>

#include "client/view/image.h"
#include "common/result.h"

namespace aucast::render {

/// A multisampled framebuffer of our own, so that pictures do not depend on a window's. Needs a
/// current context.
class OffscreenTarget {
 public:
  /// 4 samples where possible. Failed when the size is beyond what the driver can do.
  [[nodiscard]] static Result<std::unique_ptr<OffscreenTarget>> create(int width, int height);
  ~OffscreenTarget();
  OffscreenTarget(const OffscreenTarget&) = delete;
  OffscreenTarget& operator=(const OffscreenTarget&) = delete;

  void bind();
  /// Resolves and reads back what was drawn, top row first, alpha 255.
  [[nodiscard]] view::Image read();

 private:
  struct State;
  explicit OffscreenTarget(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace aucast::render

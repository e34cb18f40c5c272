#pragma once

#include <cstdint>
#include <memory>

#include "common/result.h"

namespace aucast::render {

enum class Api : std::uint8_t { OpenGl33Core, OpenGlEs30 };

/// An OpenGL context without a display. It tries EGL's surfaceless platform, then an EGL device,
/// then the default display. It is current on the thread that made it.
class OffscreenContext {
 public:
  /// Fails if none of the three works; the error has the reason of each and what to install.
  [[nodiscard]] static Result<std::unique_ptr<OffscreenContext>> create(
      Api api = Api::OpenGl33Core);
  ~OffscreenContext();
  OffscreenContext(const OffscreenContext&) = delete;
  OffscreenContext& operator=(const OffscreenContext&) = delete;

 private:
  struct State;
  explicit OffscreenContext(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace aucast::render

#pragma once

#include <cstdint>
#include <memory>

#include "common/result.h"

namespace aucast::render {

enum class Api : std::uint8_t { OpenGl33Core, OpenGlEs30 };

/// A context without a display: EGL, the surfaceless platform first, an EGL device second. Current
/// on the thread that made it.
class OffscreenContext {
 public:
  /// Failed, with what each way said and what to install, when there is none.
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

#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "common/mesh/net.h"
#include "common/mesh/picture.h"
#include "common/result.h"

namespace aucast::mesh {

/// Finds the face that a picture shows most clearly, with MediaPipe's short range detector.
/// Thread: one at a time.
class FaceFinder {
 public:
  /// BadData, beginning with `file`, when it is another net.
  [[nodiscard]] static Result<FaceFinder> make(std::span<const std::uint8_t> bytes,
                                               std::string_view file);

  /// The square that the landmarks are looked for in: around the face, level with its eyes. Nothing
  /// when no face is surer than kSureMin.
  [[nodiscard]] std::optional<Square> find(const Picture& picture);

  static constexpr float kSureMin = 0.5F;

 private:
  explicit FaceFinder(Net net) : net_(std::move(net)) {}
  Net net_;
};

}  // namespace aucast::mesh

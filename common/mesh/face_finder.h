#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "common/mesh/net.h"
#include "common/mesh/picture.h"
#include "common/result.h"

namespace aucast::mesh {

/// Finds the faces that a picture shows, with MediaPipe's short range detector.
/// Thread: one at a time.
class FaceFinder {
 public:
  /// BadData, beginning with `file`, when it is another net.
  [[nodiscard]] static Result<FaceFinder> make(std::span<const std::uint8_t> bytes,
                                               std::string_view file);

  /// The squares that landmarks are looked for in: around each face, level with its eyes; the
  /// clearest face first, at most `most` of them. Empty when none is surer than kSureMin.
  [[nodiscard]] std::vector<Square> find(const Picture& picture, std::size_t most);

  static constexpr float kSureMin = 0.5F;

 private:
  explicit FaceFinder(Net net) : net_(std::move(net)) {}
  [[nodiscard]] Square square_of(const Picture& picture, std::size_t look) const;

  Net net_;
};

}  // namespace aucast::mesh

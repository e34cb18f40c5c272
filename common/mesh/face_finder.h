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
/// Thread: any, but one at a time.
class FaceFinder {
 public:
  /// Fails with BadData and a message that begins with `file` if the bytes are not this net.
  [[nodiscard]] static Result<FaceFinder> make(std::span<const std::uint8_t> bytes,
                                               std::string_view file);

  /// The squares to look for landmarks in: one around each face, turned so that its eyes are level
  /// in it; the clearest face first, no more than `most`. Faces with a score below kSureMin are
  /// left out.
  [[nodiscard]] std::vector<Square> find(const Picture& picture, std::size_t most);

  static constexpr float kSureMin = 0.5F;

 private:
  explicit FaceFinder(Net net) : net_(std::move(net)) {}
  [[nodiscard]] Square square_of(const Picture& picture, std::size_t look) const;

  Net net_;
};

}  // namespace aucast::mesh

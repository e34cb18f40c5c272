#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "common/mesh/net.h"
#include "common/mesh/picture.h"
#include "common/result.h"

namespace aucast::mesh {

/// x to the right and y downwards, in pixels; z away from the camera, in about the same unit.
struct Point {
  double x = 0;
  double y = 0;
  double z = 0;
};

inline constexpr std::size_t kFacePoints = 468;
inline constexpr std::size_t kIrisPoints = 5;  ///< the iris's middle, and four points of its rim
inline constexpr std::size_t kRightIris = kFacePoints;
inline constexpr std::size_t kLeftIris = kRightIris + kIrisPoints;
inline constexpr std::size_t kLandmarks = kLeftIris + kIrisPoints;

/// MediaPipe's landmarks of one face, in the order of its canonical face model.
struct Landmarks {
  std::array<Point, kLandmarks> points{};
  double presence = 0;  ///< [0,1]: how sure the net is that this is a face
};

/// Finds the landmarks in a square that shows a face, with MediaPipe's net "face mesh with
/// attention". Thread: any, but one at a time.
class LandmarkFinder {
 public:
  /// Fails with BadData and a message that begins with `file` if the bytes are not this net.
  [[nodiscard]] static Result<LandmarkFinder> make(std::span<const std::uint8_t> bytes,
                                                   std::string_view file);

  [[nodiscard]] Landmarks find(const Picture& picture, const Square& square);

 private:
  explicit LandmarkFinder(Net net) : net_(std::move(net)) {}
  Net net_;
};

/// The square in which to look for this face in the next picture.
[[nodiscard]] Square square_around(const Landmarks& landmarks);

}  // namespace aucast::mesh

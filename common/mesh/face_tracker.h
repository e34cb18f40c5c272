#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "common/mesh/face_finder.h"
#include "common/mesh/landmarks.h"
#include "common/result.h"

namespace aucast::mesh {

/// The bytes of a model file, and what messages call it.
struct ModelBytes {
  std::span<const std::uint8_t> bytes;
  std::string file;
};

/// One face, followed from picture to picture: it is looked for where it was, and in the whole
/// picture when it is not there any more. Of several faces the clearest.
/// Thread: one at a time.
class FaceTracker {
 public:
  /// BadData when a model is not what it should be.
  [[nodiscard]] static Result<FaceTracker> make(const ModelBytes& detector,
                                                const ModelBytes& landmarks);

  /// The next picture of a film. Nothing when it shows no face.
  [[nodiscard]] std::optional<Landmarks> follow(const Picture& picture);

  static constexpr double kPresenceMin = 0.5;

 private:
  FaceTracker(FaceFinder faces, LandmarkFinder landmarks)
      : faces_(std::move(faces)), landmarks_(std::move(landmarks)) {}

  [[nodiscard]] std::optional<Landmarks> look_in(const Picture& picture, const Square& square);

  FaceFinder faces_;
  LandmarkFinder landmarks_;
  std::optional<Square> where_;
};

}  // namespace aucast::mesh

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "common/mesh/face_finder.h"
#include "common/mesh/face_roll.h"
#include "common/mesh/landmarks.h"
#include "common/result.h"

namespace aucast::mesh {

/// The bytes of a model file, and what messages call it.
struct ModelBytes {
  std::span<const std::uint8_t> bytes;
  std::string file;
};

/// A face that a picture shows.
struct SeenFace {
  std::size_t number = 0;  ///< that of its FaceRoll
  Landmarks landmarks;
};

/// Faces, followed from picture to picture: one is looked for where it was, and in the whole
/// picture when it is not there any more.
/// Thread: one at a time.
class FaceTracker {
 public:
  /// BadData when a model is not what it should be.
  [[nodiscard]] static Result<FaceTracker> make(const ModelBytes& detector,
                                                const ModelBytes& landmarks);

  /// The next picture of a film. Of several faces the clearest is followed; nothing when the
  /// picture shows none.
  [[nodiscard]] std::optional<Landmarks> follow(const Picture& picture);
  /// The same for all faces, in the order of their numbers. For a film of its own: not mixed with
  /// follow().
  [[nodiscard]] std::vector<SeenFace> follow_all(const Picture& picture);

  static constexpr double kPresenceMin = 0.5;
  /// Pictures from one search for new faces to the next, while all that were there are seen.
  static constexpr int kSearchEvery = 10;

 private:
  FaceTracker(FaceFinder faces, LandmarkFinder landmarks)
      : faces_(std::move(faces)), landmarks_(std::move(landmarks)) {}

  /// What the square shows, if that is a face.
  [[nodiscard]] std::optional<Landmarks> look_in(const Picture& picture, const Square& square);
  /// A face of the roll in this square, added to `seen`; false: there is none.
  bool look_for(std::size_t number, const Picture& picture, const Square& square,
                std::vector<SeenFace>& seen);

  FaceFinder faces_;
  LandmarkFinder landmarks_;
  std::optional<Square> where_;  ///< of the one that follow() follows
  FaceRoll roll_;
  int since_search_ = 0;  ///< pictures
};

}  // namespace aucast::mesh

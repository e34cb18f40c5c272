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

/// The bytes of a model file, and the name that messages give it.
struct ModelBytes {
  std::span<const std::uint8_t> bytes;
  std::string file;
};

/// A face that a picture shows.
struct SeenFace {
  std::size_t number = 0;  ///< its number in the FaceRoll
  Landmarks landmarks;
};

/// Follows faces from picture to picture: looks for a face where it was last, and in the whole
/// picture when it is no longer there.
/// Thread: any, but one at a time.
class FaceTracker {
 public:
  /// Fails with BadData if a model is not the right net.
  [[nodiscard]] static Result<FaceTracker> make(const ModelBytes& detector,
                                                const ModelBytes& landmarks);

  /// Takes the next picture of a film and returns the face in it. If there are several, follows the
  /// clearest. nullopt when the picture shows no face.
  [[nodiscard]] std::optional<Landmarks> follow(const Picture& picture);
  /// The same for all faces, in the order of their numbers. Do not mix it with follow() in one
  /// film.
  [[nodiscard]] std::vector<SeenFace> follow_all(const Picture& picture);

  static constexpr double kPresenceMin = 0.5;
  /// While no face is lost, new ones are searched for once in this many pictures.
  static constexpr int kSearchEvery = 10;

 private:
  FaceTracker(FaceFinder faces, LandmarkFinder landmarks)
      : faces_(std::move(faces)), landmarks_(std::move(landmarks)) {}

  /// The landmarks of the face in the square; nullopt when it shows no face.
  [[nodiscard]] std::optional<Landmarks> look_in(const Picture& picture, const Square& square);
  /// Looks in this square for the face of that number and adds it to `seen`. Returns false if it is
  /// not there.
  bool look_for(std::size_t number, const Picture& picture, const Square& square,
                std::vector<SeenFace>& seen);

  FaceFinder faces_;
  LandmarkFinder landmarks_;
  std::optional<Square> where_;  ///< the square of the face that follow() follows
  FaceRoll roll_;
  int since_search_ = 0;  ///< pictures since the last search
};

}  // namespace aucast::mesh

#include "common/mesh/face_tracker.h"

#include <utility>

namespace aucast::mesh {

Result<FaceTracker> FaceTracker::make(const ModelBytes& detector, const ModelBytes& landmarks) {
  auto faces = FaceFinder::make(detector.bytes, detector.file);
  if (!faces) return faces.error();
  auto finder = LandmarkFinder::make(landmarks.bytes, landmarks.file);
  if (!finder) return finder.error();
  return FaceTracker(std::move(*faces), std::move(*finder));
}

std::optional<Landmarks> FaceTracker::look_in(const Picture& picture, const Square& square) {
  Landmarks landmarks = landmarks_.find(picture, square);
  if (!(landmarks.presence >= kPresenceMin)) return std::nullopt;
  const Square next = square_around(landmarks);
  // What cannot be seen would be looked for for ever.
  if (!can_be_seen(next)) return std::nullopt;
  where_ = next;
  return landmarks;
}

std::optional<Landmarks> FaceTracker::follow(const Picture& picture) {
  if (picture.rgb.size() < 3 * picture.width * picture.height || picture.rgb.empty()) {
    return std::nullopt;
  }
  if (where_) {
    if (auto found = look_in(picture, *std::exchange(where_, std::nullopt))) return found;
  }
  const auto square = faces_.find(picture);
  return square ? look_in(picture, *square) : std::nullopt;
}

}  // namespace aucast::mesh

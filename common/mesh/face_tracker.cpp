#include "common/mesh/face_tracker.h"

#include <algorithm>
#include <utility>

namespace aucast::mesh {
namespace {

bool is_whole(const Picture& picture) {
  return !picture.rgb.empty() && picture.rgb.size() >= 3 * picture.width * picture.height;
}

}  // namespace

Result<FaceTracker> FaceTracker::make(const ModelBytes& detector, const ModelBytes& landmarks) {
  auto faces = FaceFinder::make(detector.bytes, detector.file);
  if (!faces) return faces.error();
  auto finder = LandmarkFinder::make(landmarks.bytes, landmarks.file);
  if (!finder) return finder.error();
  return FaceTracker(std::move(*faces), std::move(*finder));
}

std::optional<Landmarks> FaceTracker::look_in(const Picture& picture, const Square& square) {
  Landmarks landmarks = landmarks_.find(picture, square);
  // What cannot be seen would be looked for for ever.
  const bool face = landmarks.presence >= kPresenceMin && can_be_seen(square_around(landmarks));
  return face ? std::optional(std::move(landmarks)) : std::nullopt;
}

std::optional<Landmarks> FaceTracker::follow(const Picture& picture) {
  if (!is_whole(picture)) return std::nullopt;
  std::optional<Landmarks> found;
  if (where_) found = look_in(picture, *where_);
  if (!found) {
    const auto squares = faces_.find(picture, 1);
    if (!squares.empty()) found = look_in(picture, squares.front());
  }
  where_ = found ? std::optional(square_around(*found)) : std::nullopt;
  return found;
}

bool FaceTracker::look_for(std::size_t number, const Picture& picture, const Square& square,
                           std::vector<SeenFace>& seen) {
  auto found = look_in(picture, square);
  if (!found || !roll_.seen(number, square_around(*found))) return false;
  seen.push_back({number, *std::move(found)});
  return true;
}

std::vector<SeenFace> FaceTracker::follow_all(const Picture& picture) {
  std::vector<SeenFace> seen;
  if (!is_whole(picture)) return seen;
  bool search = ++since_search_ >= kSearchEvery || !roll_.follows_any();
  for (std::size_t number = 0; number < roll_.size(); ++number) {
    const auto where = roll_.where(number);
    if (!where || look_for(number, picture, *where, seen)) continue;
    roll_.lost(number);
    search = true;
  }
  if (!search) return seen;
  since_search_ = 0;
  for (const Square& square : faces_.find(picture, FaceRoll::kFacesMax)) {
    if (const auto number = roll_.number_of(square)) look_for(*number, picture, square, seen);
  }
  std::sort(seen.begin(), seen.end(),
            [](const SeenFace& one, const SeenFace& other) { return one.number < other.number; });
  return seen;
}

}  // namespace aucast::mesh

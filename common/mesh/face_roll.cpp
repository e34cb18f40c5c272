#include "common/mesh/face_roll.h"

#include <algorithm>

#include "common/check.h"

namespace aucast::mesh {

std::optional<Square> FaceRoll::where(std::size_t number) const {
  const Face& face = faces_[number];
  return face.followed ? std::optional(face.where) : std::nullopt;
}

bool FaceRoll::follows_any() const {
  return std::any_of(faces_.begin(), faces_.end(), [](const Face& face) { return face.followed; });
}

std::optional<std::size_t> FaceRoll::number_of(const Square& square) const {
  std::optional<std::size_t> number;
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    if (!show_the_same(faces_[i].where, square)) continue;
    if (faces_[i].followed) return std::nullopt;
    if (!number) number = i;
  }
  if (!number && faces_.size() < kFacesMax) number = faces_.size();
  return number;
}

bool FaceRoll::seen(std::size_t number, const Square& next) {
  AUCAST_CHECK(number <= faces_.size() && number < kFacesMax);
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    if (i == number || !faces_[i].followed || !show_the_same(faces_[i].where, next)) continue;
    if (number < faces_.size()) lost(number);
    return false;
  }
  if (number == faces_.size()) faces_.emplace_back();
  faces_[number] = {next, true};
  return true;
}

}  // namespace aucast::mesh

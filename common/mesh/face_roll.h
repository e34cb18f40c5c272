#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "common/mesh/picture.h"

namespace aucast::mesh {

/// Numbers the faces of a film from 0 in the order in which they are first seen. A face that was
/// lost and is seen again at the same place gets its old number.
/// Thread: none of its own.
class FaceRoll {
 public:
  static constexpr std::size_t kFacesMax = 16;

  /// How many faces have a number.
  [[nodiscard]] std::size_t size() const { return faces_.size(); }
  /// Where to look for a face in the next picture; nullopt: it is lost.
  [[nodiscard]] std::optional<Square> where(std::size_t number) const;
  /// Whether any face is followed.
  [[nodiscard]] bool follows_any() const;
  /// The number, old or new, for a face that was found at `square`. nullopt when that face is
  /// already being followed, or when kFacesMax other faces have numbers.
  [[nodiscard]] std::optional<std::size_t> number_of(const Square& square) const;

  /// Call when a face with a number from number_of() was seen; `next` is where to look for it in
  /// the next picture. Returns false if another face is already being followed there; the face with
  /// this number is then lost.
  bool seen(std::size_t number, const Square& next);
  void lost(std::size_t number) { faces_[number].followed = false; }

 private:
  struct Face {
    Square where;  ///< where to look for it next, set when it was last seen
    bool followed = false;
  };
  std::vector<Face> faces_;
};

}  // namespace aucast::mesh

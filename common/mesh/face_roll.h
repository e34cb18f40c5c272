#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "common/mesh/picture.h"

namespace aucast::mesh {

/// The faces of a film by numbers, which count from 0 as faces are first seen. One that was lost
/// and is seen again where it was has its old number.
/// Thread: none of its own.
class FaceRoll {
 public:
  static constexpr std::size_t kFacesMax = 16;

  /// How many have a number.
  [[nodiscard]] std::size_t size() const { return faces_.size(); }
  /// Where a face is looked for in the next picture; nothing: it is lost.
  [[nodiscard]] std::optional<Square> where(std::size_t number) const;
  /// Whether any face is followed.
  [[nodiscard]] bool follows_any() const;
  /// The number of the face that was found at `square`. Nothing when it is being followed, or when
  /// there are kFacesMax others.
  [[nodiscard]] std::optional<std::size_t> number_of(const Square& square) const;

  /// A face with a number of number_of() was seen; its square in the next picture. False, and the
  /// face is lost: another one that is followed is there already.
  bool seen(std::size_t number, const Square& next);
  void lost(std::size_t number) { faces_[number].followed = false; }

 private:
  struct Face {
    Square where;  ///< when it was seen last
    bool followed = false;
  };
  std::vector<Face> faces_;
};

}  // namespace aucast::mesh

#pragma once

#include <optional>

#include "common/mesh/read_aus.h"

namespace aucast::mesh {

/// Tells the sobs of one person from smiles. A sob stretches and raises the lips as a smile does;
/// the landmarks of the mouth do not tell them apart. What tells them apart is the rest of the
/// face: inner brows that rise without the outer ones, and cheeks that stay low. There AU 12 is
/// really AU 20. As nobody smiles the moment after a sob, what is seen of one fades over a while,
/// during which a hand may hide the face.
class SobWatch {
 public:
  /// Turns AU 12 of the face seen at `seconds` into AU 20 as far as it is a sob. `seconds`: not
  /// before those of the last call.
  void watch(double seconds, AuFrame& frame);

  static constexpr double kFadeSeconds = 0.5;  ///< time constant

 private:
  float sob_ = 0;  ///< [0,1]
  std::optional<double> seen_at_;
};

}  // namespace aucast::mesh

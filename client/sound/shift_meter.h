#pragma once

#include <cstdint>
#include <vector>

#include "common/time.h"

namespace aucast::sound {

/// How far the face was from the sound heard with it; above 0 the face was early.
struct ShiftSummary {
  std::uint64_t count = 0;  ///< 0: nothing was measured
  Duration median{};        ///< to a tenth of a millisecond, as are low and high
  Duration low{};           ///< 5 % are below
  Duration high{};          ///< 5 % are above
};

/// Collects these distances. Thread: none of its own.
class ShiftMeter {
 public:
  /// Distances beyond a second count as a second.
  void add(Duration shift);
  [[nodiscard]] ShiftSummary summary() const;

 private:
  [[nodiscard]] Duration below(double part) const;

  std::vector<std::uint64_t> bins_;
  std::uint64_t count_ = 0;
};

}  // namespace aucast::sound

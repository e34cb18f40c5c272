#pragma once

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "common/action_unit.h"
#include "common/time.h"

namespace aucast::speaker {

/// AUs over time: the intensity, in [0,1], of each AU that moves, sampled every kStep from 0 on. An
/// AU may have one curve for both sides and another one for a single side; that side then shows the
/// stronger of the two.
struct Curves {
  static constexpr Milliseconds kStep{20};
  using Key = std::pair<int, Side>;  ///< an AU

  explicit Curves(Milliseconds length) : steps(static_cast<std::size_t>(length / kStep) + 1) {}

  /// The samples of an AU, all 0 at first.
  [[nodiscard]] std::vector<float>& of(int au, Side side = Side::Both) {
    return samples.try_emplace({au, side}, steps, 0.0F).first->second;
  }
  /// The index of the sample for `time`; for a time beyond the end, that of the last sample.
  [[nodiscard]] std::size_t index(Milliseconds time) const {
    if (time < Milliseconds{0}) return 0;
    const auto at = static_cast<std::size_t>(time / kStep);
    return at < steps ? at : steps - 1;
  }

  std::size_t steps;
  std::map<Key, std::vector<float>> samples;
};

}  // namespace aucast::speaker

#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "common/action_unit.h"
#include "common/au_numbers.h"

namespace aucast::sources {

/// A channel is an AU on a side: first the left side's by number, then the right side's.
inline constexpr std::size_t kChannels = 2 * std::size_t{kAuCount};

[[nodiscard]] constexpr std::size_t channel_of(std::size_t number, bool right) {
  return right ? kAuCount + number : number;
}

/// One sample of a face: its signals, one for each channel; 1 is full intensity. Two AUs that are
/// opposite directions of one movement (head left and right, eyes up and down) share the signal of
/// the first. A negative value means the second, whose own signal is unused. The signal of
/// kHeadForward is the head's distance.
using Signals = std::array<float, kChannels>;

inline constexpr float kNoSignal = std::numeric_limits<float>::quiet_NaN();

[[nodiscard]] inline bool is_signal(float value) {
  return !std::isnan(value);
}

/// Signals without any data.
[[nodiscard]] Signals no_signals();

/// The same as intensities: -1 everywhere.
[[nodiscard]] AuFrame no_data();

/// The other direction of the same movement: kHeadRight for kHeadLeft and vice versa, and so on; 0
/// for an AU that has none.
[[nodiscard]] std::size_t opposite_of(std::size_t number);

/// Whether the AU is the second direction: kHeadRight, kHeadDown, kEyesRight and so on.
[[nodiscard]] bool is_second_direction(std::size_t number);

/// The AU that shows this signal of AU `number`: the opposite AU for a negative signal, if there is
/// one, else `number`.
[[nodiscard]] std::size_t shown_by(std::size_t number, float signal);

/// Turns intensities into signals; a negative intensity is no data.
[[nodiscard]] Signals signals_of(const AuFrame& update);

/// Turns signals into intensities in [0,1]; -1 where there is no data.
[[nodiscard]] AuFrame update_of(const Signals& signals);

}  // namespace aucast::sources

#pragma once

#include <cstdint>

namespace aucast::playback {

/// A number in [0,1) for each pair of seed and number, well mixed (splitmix64): chance without a
/// state, so that any moment can be asked for.
[[nodiscard]] inline double chance(std::uint64_t seed, std::uint64_t number) {
  const auto mixed = [](std::uint64_t value) {
    value += 0x9e3779b97f4a7c15U;
    value = (value ^ (value >> 30U)) * 0xbf58476d1ce4e5b9U;
    value = (value ^ (value >> 27U)) * 0x94d049bb133111ebU;
    return value ^ (value >> 31U);
  };
  return static_cast<double>(mixed(mixed(seed) ^ number) >> 11U) / 9007199254740992.0;
}

}  // namespace aucast::playback

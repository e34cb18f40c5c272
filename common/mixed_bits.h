#pragma once

#include <cstdint>

namespace aucast {

/// The mixer of splitmix64 (Steele, Lea and Flood): turns a counter into well mixed bits.
class SplitMix64 {
 public:
  explicit constexpr SplitMix64(std::uint64_t state) : state_(state) {}
  [[nodiscard]] constexpr std::uint64_t next() {
    state_ += 0x9e3779b97f4a7c15U;
    std::uint64_t value = state_;
    value = (value ^ (value >> 30U)) * 0xbf58476d1ce4e5b9U;
    value = (value ^ (value >> 27U)) * 0x94d049bb133111ebU;
    return value ^ (value >> 31U);
  }

 private:
  std::uint64_t state_;
};

/// A random number in [0,1) for each pair of seed and number. It needs no state, so any `number`
/// can be asked for, in any order.
[[nodiscard]] constexpr double chance(std::uint64_t seed, std::uint64_t number) {
  const std::uint64_t bits = SplitMix64(SplitMix64(seed).next() ^ number).next();
  return static_cast<double>(bits >> 11U) / 9007199254740992.0;
}

}  // namespace aucast

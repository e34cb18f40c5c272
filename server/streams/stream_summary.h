#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "common/action_unit.h"
#include "protocol/packet.h"

namespace aucast::server {

/// What --check reports about a stream's keyframes, collected one by one as they are read.
struct StreamSummary {
  /// How one AU is used; of its two sides, the stronger counts.
  struct Use {
    std::size_t keyframes = 0;
    int percent_low = 100;
    int percent_high = 0;
  };

  /// The AUs that turn head and eyes one way; the AU with the next number turns them the other way.
  static constexpr std::array<std::size_t, 5> kTurns{51, 53, 55, 61, 63};

  std::size_t keyframes = 0;
  std::size_t untimed = 0;
  std::uint64_t duration_ms = 0;
  std::array<Use, kAuCount> uses{};  ///< entry 0: neutral faces
  /// For each turn, how many keyframes have it at -100, -99, ... 100 percent.
  std::array<std::array<std::size_t, 201>, kTurns.size()> turns{};

  /// Adds a keyframe. An untimed one takes `keyframe_ms`.
  void add(const protocol::Keyframe& keyframe, std::uint32_t keyframe_ms);
  /// The median over all keyframes of kTurns[turn], in percent.
  [[nodiscard]] int median_turn(std::size_t turn) const;
};

}  // namespace aucast::server

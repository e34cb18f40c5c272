#pragma once

#include <cstddef>
#include <cstdint>
#include <random>

#include "common/time.h"
#include "server/settings/limits.h"

namespace aucast::server {

/// Chooses which of several hosts is dialled next, and after what wait. When a host is lost, the
/// next is tried almost at once, within kNextHostWaitMax. When all have failed in a row, the next
/// round waits for kRedialWaitFirst, then twice as long each time up to kRedialWaitMax. Every wait
/// is shortened at random, so that many servers do not come back at the same moment. No clock.
/// Thread: none of its own.
class HostTurns {
 public:
  /// `hosts`: at least one.
  HostTurns(std::size_t hosts, std::uint32_t seed) : hosts_(hosts), random_(seed) {}

  /// The index of the host whose turn it is.
  [[nodiscard]] std::size_t current() const { return current_; }
  /// Call when the present host has failed or was lost: the next one has its turn. Returns how long
  /// to wait before dialling that one.
  [[nodiscard]] Milliseconds next();
  /// Call when a connection was of use: earlier failures are forgotten.
  void worked();

 private:
  [[nodiscard]] Milliseconds shortened(Milliseconds wait);

  std::size_t hosts_;
  std::minstd_rand random_;
  std::size_t current_ = 0;
  std::size_t failures_ = 0;  ///< in a row
  Milliseconds wait_ = kRedialWaitFirst;
};

}  // namespace aucast::server

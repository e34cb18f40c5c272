#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>

#include "common/time.h"
#include "protocol/limits.h"

namespace aucast::protocol {

/// Counts the credits of one client for codes that answer nothing. There are enough for any honest
/// client, but not for one that floods the server. Thread: none of its own.
class SpareCodes {
 public:
  explicit SpareCodes(Instant now) : counted_(now) {}

  /// One more such code has come. Returns whether there was a credit for it.
  [[nodiscard]] bool spend(Instant now) {
    constexpr std::chrono::milliseconds kEach{1000 / kSpareCodesPerSecond};
    if (const auto earned = (now - counted_) / kEach; earned > 0) {
      counted_ += earned * kEach;  // what is left of the time counts for the next credit
      left_ = std::min(left_ + static_cast<std::size_t>(earned), kSpareCodesMax);
    }
    if (left_ == 0) return false;
    --left_;
    return true;
  }
  /// This many keyframes were sent.
  void earn(std::uint64_t keyframes) {
    left_ = std::min<std::uint64_t>(left_ + keyframes * kSpareCodesPerPacket, kSpareCodesMax);
  }

 private:
  std::size_t left_ = kSpareCodesMax;
  Instant counted_;  ///< the time up to which credits were added
};

}  // namespace aucast::protocol

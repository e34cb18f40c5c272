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
    const auto earned = std::chrono::duration_cast<std::chrono::milliseconds>(now - counted_) *
                        kSpareCodesPerSecond / 1000;
    if (earned.count() > 0) {
      counted_ = now;
      left_ = std::min(left_ + static_cast<std::size_t>(earned.count()), kSpareCodesMax);
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

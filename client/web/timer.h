#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "common/time.h"

namespace aucast::web {

[[nodiscard]] Instant now();

/// One timer of the browser. It never rings from within its own functions, nor after it is
/// destroyed.
/// Thread: the page's.
class Timer {
 public:
  explicit Timer(std::function<void()> rang);
  ~Timer();
  Timer(const Timer&) = delete;
  Timer& operator=(const Timer&) = delete;

  /// Rings once at `when`, in place of the time set before; nullopt: not at all.
  void set(std::optional<Instant> when);

  /// Called by the browser.
  static void ring(std::uint32_t id);

 private:
  const std::uint32_t id_;
  const std::function<void()> rang_;
};

}  // namespace aucast::web

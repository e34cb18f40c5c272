#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "common/time.h"

namespace aucast::web {

[[nodiscard]] Instant now();

/// One timer of the browser. Never rings from within one of its own calls, nor after its end.
/// Thread: the page's.
class Timer {
 public:
  explicit Timer(std::function<void()> rang);
  ~Timer();
  Timer(const Timer&) = delete;
  Timer& operator=(const Timer&) = delete;

  /// Rings once at `when` instead of when it was to ring before; nullopt: not at all.
  void set(std::optional<Instant> when);

  /// The browser's call.
  static void ring(std::uint32_t id);

 private:
  const std::uint32_t id_;
  const std::function<void()> rang_;
};

}  // namespace aucast::web

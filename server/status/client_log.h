#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include "common/log.h"
#include "common/time.h"

namespace aucast::server {

/// Limits the lines in the log about single clients. A flood of them would fill the disk, and the
/// journal drops everything beyond 10,000 lines in 30 s from one service, even errors. Lines left
/// out are counted, and their number is logged. At level debug nothing is left out.
/// Thread: none of its own.
class ClientLog {
 public:
  template <typename... Args>
  void say(Instant now, spdlog::level::level_enum level, spdlog::format_string_t<Args...> format,
           Args&&... args) {
    if (spdlog::should_log(level) && may_say(now))
      spdlog::log(level, format, std::forward<Args>(args)...);
  }

  /// Counts one line and returns whether to log it; if so, first logs how many were left out before
  /// it.
  [[nodiscard]] bool may_say(Instant now);

  /// Logs how many lines were left out, if any were. Call it at the end.
  void say_left_out();

 private:
  Instant second_{};  ///< when the present second began
  std::uint64_t lines_ = 0;
  std::uint64_t left_out_ = 0;
};

}  // namespace aucast::server

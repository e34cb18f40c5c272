#pragma once

#include <string>

#include "common/log.h"

namespace aucast::server {

/// The level at which to log a reason: debug if the same failure is repeated, else warn. `said`:
/// the reason last logged, which becomes this one.
[[nodiscard]] inline spdlog::level::level_enum level_of(const std::string& reason,
                                                        std::string& said) {
  const auto level = said == reason ? spdlog::level::debug : spdlog::level::warn;
  said = reason;
  return level;
}

}  // namespace aucast::server

#pragma once

#include <string>

#include "common/log.h"

namespace aucast::server {

/// The level at which to log a reason: debug if it is the one that was logged last, else warn.
/// `said`: the reason logged last; set to `reason`.
[[nodiscard]] inline spdlog::level::level_enum level_of(const std::string& reason,
                                                        std::string& said) {
  const auto level = said == reason ? spdlog::level::debug : spdlog::level::warn;
  said = reason;
  return level;
}

}  // namespace aucast::server

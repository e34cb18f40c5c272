#pragma once

#include <string>

#include "common/log.h"

namespace aucast::server {

/// At which level to log a reason: if the same failure comes again and again, one line is enough.
/// `said`: the reason logged last, which becomes this one.
[[nodiscard]] inline spdlog::level::level_enum level_of(const std::string& reason,
                                                        std::string& said) {
  const auto level = said == reason ? spdlog::level::debug : spdlog::level::warn;
  said = reason;
  return level;
}

}  // namespace aucast::server

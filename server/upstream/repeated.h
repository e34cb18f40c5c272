#pragma once

#include <string>

#include "common/log.h"

namespace aucast::server {

/// How loud a reason is said: of what fails in the same way again and again one line is enough.
/// `said`: the one that was said last, which this is from now on.
[[nodiscard]] inline spdlog::level::level_enum level_of(const std::string& reason,
                                                        std::string& said) {
  const auto level = said == reason ? spdlog::level::debug : spdlog::level::warn;
  said = reason;
  return level;
}

}  // namespace aucast::server

#pragma once

#include "common/log.h"

namespace aucast::test {

/// While this lives, the log says nothing.
class QuietLog {
 public:
  QuietLog() { spdlog::set_level(spdlog::level::off); }
  ~QuietLog() { spdlog::set_level(before_); }
  QuietLog(const QuietLog&) = delete;
  QuietLog& operator=(const QuietLog&) = delete;

 private:
  const spdlog::level::level_enum before_ = spdlog::get_level();
};

}  // namespace aucast::test

#pragma once

#include <memory>
#include <sstream>
#include <string>
#include <utility>

#include <spdlog/sinks/ostream_sink.h>

#include "common/log.h"

namespace aucast::test {

/// While this object lives, it keeps what the log says: a line for each entry, without its time and
/// level.
class KeptLog {
 public:
  KeptLog() {
    auto logger = std::make_shared<spdlog::logger>(
        "kept", std::make_shared<spdlog::sinks::ostream_sink_mt>(said_));
    logger->set_pattern("%v");
    spdlog::set_default_logger(std::move(logger));
  }
  ~KeptLog() { spdlog::set_default_logger(before_); }
  KeptLog(const KeptLog&) = delete;
  KeptLog& operator=(const KeptLog&) = delete;

  /// What was said so far.
  [[nodiscard]] std::string said() const { return said_.str(); }

 private:
  std::ostringstream said_;
  const std::shared_ptr<spdlog::logger> before_ = spdlog::default_logger();
};

}  // namespace aucast::test

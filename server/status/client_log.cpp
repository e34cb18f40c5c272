#include "server/status/client_log.h"

#include <chrono>

#include "server/settings/limits.h"

namespace aucast::server {

bool ClientLog::may_say(Instant now) {
  if (now - second_ >= std::chrono::seconds(1)) {
    second_ = now;
    lines_ = 0;
    say_left_out();
  }
  if (lines_ == kClientLogLinesPerSecond && !spdlog::should_log(spdlog::level::debug)) {
    ++left_out_;
    return false;
  }
  if (lines_ < kClientLogLinesPerSecond) ++lines_;
  return true;
}

void ClientLog::say_left_out() {
  if (left_out_ == 0) return;
  spdlog::warn("{} lines about clients were left out here, for there were more than {} in a second",
               left_out_, kClientLogLinesPerSecond);
  left_out_ = 0;
}

}  // namespace aucast::server

#include "client/app/start_times.h"

#include <array>
#include <cstdio>

#include "client/app/steady.h"

namespace aucast::app {
namespace {

std::string whole(double ms) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.0f", ms);
  return text.data();
}

}  // namespace

StartTimes::StartTimes()
    : total_ms_(since_start_ms()),
      last_(steady_now()),
      stages_("options and files " + whole(total_ms_)) {}

void StartTimes::passed(const char* stage) {
  const Instant now = steady_now();
  const double ms = 1000 * seconds(now - last_);
  last_ = now;
  total_ms_ += ms;
  stages_ += std::string(", ") + stage + " " + whole(ms);
}

std::string StartTimes::text() const {
  return "first picture after " + whole(total_ms_) + " ms: " + stages_;
}

}  // namespace aucast::app

#include "server/serve/departure.h"

#include <algorithm>
#include <chrono>

namespace aucast::server {

namespace {

/// How often clients are sent away.
constexpr Milliseconds kStep{20};

}  // namespace

std::size_t gone_by(std::size_t clients, Duration passed, Duration time) {
  if (passed >= time) return clients;
  return static_cast<std::size_t>(static_cast<double>(clients) * seconds(passed) / seconds(time));
}

void Departure::begin(std::size_t clients, Duration time) {
  begin_ = std::chrono::steady_clock::now();
  clients_ = clients;
  time_ = time;
  go_on();
}

void Departure::go_on() {
  const Duration passed = std::chrono::steady_clock::now() - begin_;
  const std::size_t due = gone_by(clients_, passed, time_);
  if (due > gone_) send_away_(due - std::exchange(gone_, due));
  if (passed >= time_) {
    on_over_();
    return;
  }
  timer_.after(std::min<Duration>(kStep, time_ - passed), [this] { go_on(); });
}

}  // namespace aucast::server

#include "client/web/timer.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <utility>

#include "client/web/browser.h"

namespace aucast::web {
namespace {

/// All timers by their ids, which are never reused.
std::map<std::uint32_t, const std::function<void()>*>& timers() {
  static std::map<std::uint32_t, const std::function<void()>*> all;
  return all;
}

std::uint32_t new_timer_id() {
  static std::uint32_t last = 0;
  return ++last;
}

}  // namespace

Instant now() {
  return std::chrono::steady_clock::now();
}

Timer::Timer(std::function<void()> rang) : id_(new_timer_id()), rang_(std::move(rang)) {
  timers()[id_] = &rang_;
}

Timer::~Timer() {
  set(std::nullopt);
  timers().erase(id_);
}

void Timer::set(std::optional<Instant> when) {
  using Fraction = std::chrono::duration<double, std::milli>;
  browser::set_timer(id_, when ? std::max(0.0, Fraction(*when - now()).count()) : -1);
}

void Timer::ring(std::uint32_t id) {
  const auto found = timers().find(id);
  if (found == timers().end()) return;
  const auto rang = *found->second;  // a copy, because the call may destroy the timer
  rang();
}

}  // namespace aucast::web

#include "server/live/live_beat.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "common/log.h"
#include "server/streams/catalogue.h"

namespace aucast::server {
namespace {

/// A beat that takes longer than a moment lasts is followed by a part of its time for everything
/// else: answers, and those who come. What is due meanwhile goes out with the next one.
constexpr int kBreath = 4;

Instant now() {
  return std::chrono::steady_clock::now();
}

/// Moments so far, those that were left out too.
std::uint64_t begun(const protocol::LiveClock& clock) {
  return clock.newest() ? clock.newest()->number + 1 : 0;
}

}  // namespace

void LiveBeat::start(protocol::ServerCatalogue& catalogue, const protocol::ServerCatalogue* before,
                     OnMoment on_moment) {
  on_moment_ = std::move(on_moment);
  const Instant begin = now();
  clocks_.reserve(catalogue.streams.size());  // the streams point into it
  for (protocol::ServedStream& stream : catalogue.streams) {
    if (stream.clock != nullptr) continue;  // a source gives the time
    const protocol::ServedStream* same = before ? find_same(*before, stream) : nullptr;
    const auto* running =
        same != nullptr ? dynamic_cast<const protocol::LiveClock*>(same->clock) : nullptr;
    if (running != nullptr) {
      stream.clock = &clocks_.emplace_back(*running);
    } else {
      stream.clock = &clocks_.emplace_back(stream.times, catalogue.loop, begin);
    }
  }
  beat();
}

void LiveBeat::stop() {
  stopped_ = true;
  timer_.cancel();
}

void LiveBeat::catch_up() {
  if (!stopped_ && now() >= timer_.expiry()) beat();
}

void LiveBeat::beat() {
  const Instant moment = now();
  bool moved = false;
  std::uint64_t left_out = 0;
  Duration latest{0};
  for (protocol::LiveClock& clock : clocks_) {
    const Duration late = moment - clock.next_at().value_or(moment);
    const std::uint64_t before = begun(clock);
    if (!clock.advance_all(moment)) continue;
    moved = true;
    lag_ = late;
    latest = std::max(latest, late);
    left_out += begun(clock) - before - clock.passed().size();
  }
  // Once a second at most: less late than that nothing is left out.
  if (left_out > 0) {
    spdlog::warn("late by {:.1f} s: {} moments of live streams were left out",
                 std::chrono::duration<double>(latest).count(), left_out);
  }
  if (moved) on_moment_();
  const Instant done = now();
  wait(done + (done - moment) / kBreath);
}

void LiveBeat::wait(Instant earliest) {
  std::optional<Instant> next;
  for (const protocol::LiveClock& clock : clocks_) {
    const auto at = clock.next_at();
    if (at && (!next || *at < *next)) next = at;
  }
  if (!next || stopped_) return;
  timer_.expires_at(std::max(*next, earliest));
  timer_.async_wait([this](const std::error_code& error) {
    if (!error && !stopped_) beat();
  });
}

}  // namespace aucast::server

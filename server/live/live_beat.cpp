#include "server/live/live_beat.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "common/earlier.h"
#include "common/log.h"
#include "protocol/encoded_track.h"

namespace aucast::server {
namespace {

/// After a beat, the loop has 1/kBreath of the beat's time for everything else (answers, new
/// clients), even if that is longer than a moment. What becomes due meanwhile is sent with the next
/// beat.
constexpr int kBreath = 4;

Instant now() {
  return std::chrono::steady_clock::now();
}

/// How many moments there were so far, including those that were left out.
std::uint64_t begun(const protocol::LiveReplay& replay) {
  return replay.newest() == nullptr ? 0 : replay.newest()->number + 1;
}

}  // namespace

std::shared_ptr<const protocol::LiveChannel> LiveBeat::play(
    const std::string& name, std::shared_ptr<const protocol::EncodedStream> stream, bool loop,
    std::shared_ptr<const protocol::SpokenTrack> spoken) {
  for (const Playing& playing : playing_) {
    const auto replay = playing.replay.lock();
    const bool same = replay && playing.name == name && *replay->replay().stream() == *stream &&
                      same_spoken(replay->replay().spoken(), spoken);
    if (same) return {replay, &replay->channel()};
  }
  const Instant begin = now();
  auto replay =
      std::make_shared<ServedReplay>(std::move(stream), loop, begin, std::move(spoken), limits_);
  playing_.push_back({name, replay});
  replay->advance(begin);
  wait(begin);
  return {replay, &replay->channel()};
}

void LiveBeat::stop() {
  stopped_ = true;
  timer_.cancel();
}

void LiveBeat::catch_up() {
  if (!stopped_ && now() >= timer_.when()) beat();
}

void LiveBeat::beat() {
  const Instant begin = now();
  bool moved = false;
  std::uint64_t left_out = 0;
  Duration worst{0};
  for (const Playing& playing : playing_) {
    const auto replay = playing.replay.lock();
    if (!replay) continue;
    const Duration late = begin - replay->next_at().value_or(begin);
    const std::uint64_t before = begun(replay->replay());
    if (!replay->advance(begin)) continue;
    moved = true;
    worst = std::max(worst, late);
    // Less late than that, what is left out is more than any client takes at once.
    if (late <= protocol::LiveClock::kLiveLagMax) continue;
    const std::uint64_t now_begun = begun(replay->replay());
    if (now_begun > before) left_out += now_begun - before - replay->replay().latest().size();
  }
  // Once a second at most.
  if (left_out > 0) {
    spdlog::warn("late by {:.1f} s: {} moments of live streams were left out", seconds(worst),
                 left_out);
  }
  if (moved) {
    lag_ = worst;
    on_moment_();
  }
  const Instant done = now();
  wait(done + (done - begin) / kBreath);
}

void LiveBeat::wait(Instant earliest) {
  std::erase_if(playing_, [](const Playing& playing) { return playing.replay.expired(); });
  std::optional<Instant> next;
  for (const Playing& playing : playing_) {
    const auto replay = playing.replay.lock();
    if (replay) next = earlier(next, replay->next_at());
  }
  if (!next || stopped_) return;
  timer_.at(std::max(*next, earliest), [this] { beat(); });
}

}  // namespace aucast::server

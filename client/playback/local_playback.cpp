#include "client/playback/local_playback.h"

#include <algorithm>
#include <utility>

#include "common/check.h"

namespace aucast::playback {
namespace {

/// Slower keyframes are faces that somebody wrote, not pictures of a film.
constexpr Milliseconds kPictureMax{100};
/// Times are whole milliseconds: of 1/30 s some are 33 and some 34.
constexpr Milliseconds kRounding{1};

/// As picture_time(). The first keyframe may have a time of its own; one in ten may be missing.
std::optional<Duration> steady_time(const std::vector<Milliseconds>& times) {
  if (times.size() < 4) return std::nullopt;
  std::vector<Milliseconds> sorted(times.begin() + 1, times.end());
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  const Milliseconds usual = *middle;
  if (usual <= Milliseconds::zero() || usual > kPictureMax) return std::nullopt;
  Duration sum{0};
  Duration::rep alike = 0;
  for (const Milliseconds time : sorted) {
    if (time < usual - kRounding || time > usual + kRounding) continue;
    sum += time;
    ++alike;
  }
  if (10 * static_cast<std::size_t>(alike) < 9 * sorted.size()) return std::nullopt;
  return sum / alike;
}

}  // namespace

LocalPlayback::LocalPlayback(const std::vector<Milliseconds>& times)
    : picture_time_(steady_time(times)) {
  AUCAST_CHECK(!times.empty());
  Duration end{0};
  for (const Milliseconds time : times) {
    AUCAST_CHECK(time >= Milliseconds::zero());
    end += time;
    ends_.push_back(end);
  }
}

std::optional<LocalPlayback::Loop> LocalPlayback::loop() const {
  if (loop_begin_ && loop_end_ && anchor_position_ < *loop_end_) {
    return Loop{*loop_begin_, *loop_end_};
  }
  if (repeats_ && anchor_position_ < total()) return Loop{Duration::zero(), total()};
  return std::nullopt;
}

Duration LocalPlayback::run(Instant now) const {
  if (!playing_ || now <= anchor_at_) return Duration::zero();
  return (now - anchor_at_) * speed_percent_ / 100;
}

Duration LocalPlayback::position(Instant now) const {
  const Duration wanted = anchor_position_ + run(now);
  const auto round = loop();
  if (!round) return std::min(wanted, total());
  if (wanted < round->end) return wanted;
  return round->begin + (wanted - round->end) % (round->end - round->begin);
}

StreamPlace LocalPlayback::place(Duration position) const {
  const auto found = std::upper_bound(ends_.begin(), ends_.end(), position);
  const auto keyframe = static_cast<std::size_t>(found - ends_.begin());
  const Duration begin = keyframe == 0 ? Duration::zero() : ends_[keyframe - 1];
  if (found == ends_.end() || (keyframe > 0 && position == begin)) return {keyframe - 1, 1.0};
  const Duration done = std::max(position - begin, Duration::zero());
  return {keyframe,
          static_cast<double>(done.count()) / static_cast<double>((*found - begin).count())};
}

bool LocalPlayback::played_to_end(Instant now) const {
  return over(now) && (ended_ || anchor_position_ < total());
}

void LocalPlayback::anchor(Duration position, Instant now) {
  ended_ = position == total() && played_to_end(now);
  passed_before_ = passed(now);
  anchor_at_ = now;
  anchor_position_ = position;
}

void LocalPlayback::play(Instant now) {
  if (playing_ && !over(now)) return;
  const Duration at = position(now);
  anchor(at == total() ? Duration::zero() : at, now);
  playing_ = true;
}

void LocalPlayback::pause(Instant now) {
  anchor(position(now), now);
  playing_ = false;
}

void LocalPlayback::seek(Duration position, Instant now) {
  const Duration to = std::clamp(position, Duration::zero(), total());
  if (played_to_end(now)) pause(now);
  anchor(to == total() && playing_ && repeats_ ? Duration::zero() : to, now);
}

void LocalPlayback::step_keyframe(int direction, Instant now) {
  const Duration at = position(now);
  pause(now);
  if (direction > 0) {
    const auto next = std::upper_bound(ends_.begin(), ends_.end(), at);
    if (next != ends_.end()) anchor(*next, now);
  } else {
    const auto before = std::lower_bound(ends_.begin(), ends_.end(), at);
    anchor(before == ends_.begin() ? Duration::zero() : *std::prev(before), now);
  }
}

void LocalPlayback::step_at_rate(int direction, int fps, Instant now) {
  AUCAST_CHECK(fps > 0);
  const Duration at = position(now);
  pause(now);
  const auto frame = [&](Duration::rep k) { return Duration(std::chrono::seconds(1)) * k / fps; };
  Duration::rep k = at * fps / Duration(std::chrono::seconds(1));
  if (direction > 0) {
    while (frame(k) <= at) ++k;
  } else {
    while (k > 0 && frame(k) >= at) --k;
  }
  anchor(std::min(frame(k), total()), now);
}

Duration LocalPlayback::picture_after(Duration position) const {
  const auto end = std::upper_bound(ends_.begin(), ends_.end(), position);
  if (end == ends_.end()) return total();
  const Duration begin = end == ends_.begin() ? Duration::zero() : *std::prev(end);
  const Duration next = begin + ((position - begin) / *picture_time_ + 1) * *picture_time_;
  return *end - next < *picture_time_ / 2 ? *end : next;
}

Duration LocalPlayback::picture_before(Duration position) const {
  const auto end = std::lower_bound(ends_.begin(), ends_.end(), position);
  if (position <= Duration::zero()) return Duration::zero();
  const Duration begin = end == ends_.begin() ? Duration::zero() : *std::prev(end);
  Duration before = begin + (position - begin - Duration(1)) / *picture_time_ * *picture_time_;
  // As picture_after(), which does not stop that close to a keyframe.
  if (before > begin && *end - before < *picture_time_ / 2) before -= *picture_time_;
  return before;
}

void LocalPlayback::step_picture(int direction, Instant now) {
  AUCAST_CHECK(picture_time_.has_value());
  const Duration at = position(now);
  pause(now);
  anchor(direction > 0 ? picture_after(at) : picture_before(at), now);
}

void LocalPlayback::set_speed(int percent, Instant now) {
  anchor(position(now), now);
  speed_percent_ = std::clamp(percent, kSpeedMin, kSpeedMax);
}

void LocalPlayback::change_speed(int direction, Instant now) {
  if (direction > 0) {
    const auto* next = std::upper_bound(kSpeeds.begin(), kSpeeds.end(), speed_percent_);
    if (next != kSpeeds.end()) set_speed(*next, now);
  } else {
    const auto* before = std::lower_bound(kSpeeds.begin(), kSpeeds.end(), speed_percent_);
    if (before != kSpeeds.begin()) set_speed(*std::prev(before), now);
  }
}

void LocalPlayback::mark_loop(Instant now) {
  const Duration at = position(now);
  anchor(at, now);
  if (!loop_begin_) {
    loop_begin_ = at;
  } else if (!loop_end_ && at != *loop_begin_) {
    // Whoever goes back before the second mark means the part between both.
    const auto [first, last] = std::minmax({at, *loop_begin_});
    loop_begin_ = first;
    loop_end_ = last;
    if (at == last) anchor(first, now);
  } else {
    loop_begin_.reset();
    loop_end_.reset();
  }
}

void LocalPlayback::set_repeat(bool repeats, Instant now) {
  const bool ended = over(now);
  anchor(position(now), now);
  repeats_ = repeats;
  if (repeats && ended) anchor(Duration::zero(), now);
}

/// Keyframes whose end lies in [from, to), and the last one when `to` is the end of all.
LocalPlayback::Passed LocalPlayback::between(Duration from, Duration to) const {
  if (from >= to) return {};
  const auto first = std::lower_bound(ends_.begin(), ends_.end(), from);
  const auto last = to == total() ? ends_.end() : std::lower_bound(ends_.begin(), ends_.end(), to);
  Passed sum;
  for (auto end = first; end < last; ++end) {
    ++sum.keyframes;
    sum.time += *end - (end == ends_.begin() ? Duration::zero() : *std::prev(end));
  }
  return sum;
}

LocalPlayback::Passed LocalPlayback::passed(Instant now) const {
  Passed sum = passed_before_;
  const auto add = [&sum](Passed more, Duration::rep times) {
    sum.keyframes += more.keyframes * static_cast<std::uint64_t>(times);
    sum.time += more.time * times;
  };
  const Duration wanted = anchor_position_ + run(now);
  const auto round = loop();
  if (!round || wanted < round->end) {
    add(between(anchor_position_, position(now)), 1);
    return sum;
  }
  const Duration length = round->end - round->begin;
  add(between(anchor_position_, round->end), 1);
  add(between(round->begin, round->end), (wanted - round->end) / length);
  add(between(round->begin, position(now)), 1);
  return sum;
}

std::uint64_t LocalPlayback::keyframes_played(Instant now) const {
  return passed(now).keyframes;
}

Duration LocalPlayback::media_time(Instant now) const {
  return passed(now).time;
}

}  // namespace aucast::playback

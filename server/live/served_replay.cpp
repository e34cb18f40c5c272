#include "server/live/served_replay.h"

#include <algorithm>
#include <utility>

#include "common/earlier.h"
#include "protocol/limits.h"

namespace aucast::server {

ServedReplay::ServedReplay(std::shared_ptr<const protocol::EncodedStream> stream, bool loop,
                           Instant begin, std::shared_ptr<const protocol::SpokenTrack> spoken,
                           const ReplayLimits& limits)
    : replay_(std::move(stream), loop, begin, std::move(spoken)),
      thinning_(limits.keyframe_ms, limits.link) {
  if (limits.link.kbits == 0 || !replay_.has_voice()) return;
  feed_.emplace(limits.keyframe_ms, limits.classic_min, true, replay_.has_captions(),
                replay_.duration_ms());
}

const protocol::LiveChannel& ServedReplay::channel() const {
  if (feed_) return *feed_;
  return replay_;
}

bool ServedReplay::advance(Instant now) {
  bool moved = replay_.advance(now);
  if (!feed_) return moved;
  if (moved) {
    take_spoken(now);
    take_moments();
  }
  // What is left at the end waits for nothing.
  const auto keyframe = replay_.ended() ? thinning_.take_last() : thinning_.pop(now);
  if (keyframe) {
    feed_->add(*keyframe);
    moved = true;
  }
  if (replay_.ended()) feed_->end();
  return moved;
}

std::optional<Instant> ServedReplay::next_at() const {
  std::optional<Instant> thinned;
  if (const auto due = thinning_.due(); due && feed_) thinned = just_after(*due);
  return earlier(replay_.next_at(), thinned);
}

void ServedReplay::take_spoken(SteadyTime now) {
  const auto& voice = replay_.voice();
  next_voice_ = std::max(next_voice_, voice.first_number());
  for (; const auto* const packet = voice.find(next_voice_); ++next_voice_) {
    thinning_.spend(packet->continued.size(), now);
    feed_->add_voice(*packet);
  }
  const auto& captions = replay_.captions();
  next_caption_ = std::max(next_caption_, captions.first_number());
  for (; const auto* const caption = captions.find(next_caption_); ++next_caption_) {
    feed_->add_caption(*caption);
  }
}

/// What is sent next takes the time of all that is left out before it, so that the feed's clock
/// agrees with the replay's.
void ServedReplay::take_moments() {
  constexpr Milliseconds kLongest{protocol::kKeyframeTimeMsMax};
  for (const protocol::LiveMoment& moment : replay_.latest()) {
    if (moment.number < next_moment_) continue;
    next_moment_ = moment.number + 1;
    const auto behind = [&] { return moment.begin + moment.time - feed_->end_of_newest(); };
    protocol::Keyframe keyframe = protocol::keyframe_of(moment.full);
    const auto waiting = thinning_.take_last();
    // After more than an hour, as when the process stood still, one keyframe is not enough.
    if (waiting && behind() > kLongest) feed_->add(*waiting);
    while (behind() > kLongest) {
      keyframe.time_ms = static_cast<std::uint32_t>(kLongest.count());
      feed_->add(keyframe);
    }
    keyframe.time_ms = static_cast<std::uint32_t>(behind().count());
    thinning_.push(std::move(keyframe));
  }
}

}  // namespace aucast::server

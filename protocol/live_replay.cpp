#include "protocol/live_replay.h"

#include <numeric>
#include <utility>

namespace aucast::protocol {
namespace {

double mean_ms(const EncodedStream& stream) {
  const double sum =
      std::accumulate(stream.times.begin(), stream.times.end(), 0.0,
                      [](double ms, KeyframeTime time) { return ms + time.count(); });
  return sum / static_cast<double>(stream.times.size());
}

}  // namespace

LiveReplay::LiveReplay(std::shared_ptr<const EncodedStream> stream, bool loop, Instant begin)
    : LiveChannel(!stream->changes.empty(), loop ? std::nullopt : stream->duration_ms),
      stream_(std::move(stream)),
      clock_(stream_->times, loop, begin) {
  limit_window(mean_ms(*stream_));
}

bool LiveReplay::advance(Instant now) {
  if (!clock_.advance_all(now)) return false;
  ended_ = clock_.ended();
  std::span<const LiveClock::Moment> begun = clock_.passed();
  // An end that is long past left the last moments out; the last state is shown all the same.
  if (begun.empty() && clock_.newest()) begun = {&*clock_.newest(), 1};
  moments_.resize(begun.size());
  for (std::size_t i = 0; i < begun.size(); ++i) {
    const std::size_t keyframe = begun[i].keyframe;
    LiveMoment& moment = moments_[i];
    moment.number = begun[i].number;
    moment.classic = stream_->classic[keyframe];
    moment.full = stream_->negotiated[keyframe];
    if (has_changes()) moment.changes = stream_->changes[keyframe];
  }
  return true;
}

}  // namespace aucast::protocol

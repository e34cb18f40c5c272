#include "client/playback/playback.h"

#include <utility>

#include "common/check.h"

namespace aucast::playback {

namespace {

const DelayMeter& no_delays() {
  static const DelayMeter none;
  return none;
}

}  // namespace

const DelayMeter& Playback::delays() const {
  return no_delays();
}

const DelayMeter& Playback::delays_meant() const {
  return no_delays();
}

SourcePlayback::SourcePlayback(std::unique_ptr<KeyframeSource> source, const Options& options)
    : source_(std::move(source)), controller_(options.speed) {
  AUCAST_CHECK(source_ != nullptr);
  if (options.hold) controller_.set_hold(*options.hold);
  if (options.video_clock) controller_.set_video_clock();
}

void SourcePlayback::pause(Instant now) {
  controller_.pause(now);
  source_->pause();
}

void SourcePlayback::resume(Instant now) {
  controller_.resume(now);
  source_->resume();
}

void SourcePlayback::stop(Instant now) {
  if (over()) return;
  source_->stop();
  controller_.stop(now);
}

}  // namespace aucast::playback

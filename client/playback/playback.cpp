#include "client/playback/playback.h"

namespace aucast::playback {
namespace {

const DelayMeter& no_delays() {
  static const DelayMeter none;
  return none;
}

}  // namespace

std::string_view name(PlaybackState state) {
  switch (state) {
    case PlaybackState::Buffering:
      return "buffering";
    case PlaybackState::Playing:
      return "playing";
    case PlaybackState::Stalled:
      return "stalled";
    case PlaybackState::Stale:
      return "stale";
    case PlaybackState::Paused:
      return "paused";
    case PlaybackState::Ended:
      return "ended";
    case PlaybackState::Stopped:
      return "stopped";
    case PlaybackState::Lost:
      return "lost";
  }
  return "unknown";
}

bool is_over(PlaybackState state) {
  return state == PlaybackState::Ended || state == PlaybackState::Stopped ||
         state == PlaybackState::Lost;
}

const DelayMeter& Playback::delays() const {
  return no_delays();
}

const DelayMeter& Playback::delays_meant() const {
  return no_delays();
}

}  // namespace aucast::playback

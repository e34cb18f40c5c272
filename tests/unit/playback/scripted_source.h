#pragma once

#include <deque>
#include <utility>

#include "client/playback/keyframe_source.h"

namespace aucast::playback::test {

/// A source whose keyframes and end the test puts in by hand.
class ScriptedSource final : public KeyframeSource {
 public:
  std::deque<Keyframe> keyframes;
  SourceStatus now;

  [[nodiscard]] std::optional<Keyframe> take() override {
    if (keyframes.empty()) return std::nullopt;
    const Keyframe next = keyframes.front();
    keyframes.pop_front();
    return next;
  }
  std::deque<Caption> captions;
  [[nodiscard]] std::optional<Caption> take_caption() override {
    if (captions.empty()) return std::nullopt;
    Caption next = std::move(captions.front());
    captions.pop_front();
    return next;
  }
  [[nodiscard]] bool ready() const override {
    return !keyframes.empty() || now.end != EndReason::NotEnded;
  }
  bool wait_until(Instant /*until*/) override { return ready(); }
  [[nodiscard]] SourceStatus status() const override { return now; }
  void stop() override { now.end = EndReason::Stopped; }
};

}  // namespace aucast::playback::test

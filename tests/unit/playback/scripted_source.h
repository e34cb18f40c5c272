#pragma once

#include <deque>
#include <memory>
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
  std::deque<Voice> voice;
  [[nodiscard]] std::optional<Voice> take_voice() override {
    if (voice.empty()) return std::nullopt;
    Voice next = std::move(voice.front());
    voice.pop_front();
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

/// Hands a playback a source that stays the test's own.
[[nodiscard]] inline std::unique_ptr<KeyframeSource> borrow(KeyframeSource& source) {
  class Borrowed final : public KeyframeSource {
   public:
    explicit Borrowed(KeyframeSource& source) : source_(source) {}
    [[nodiscard]] std::optional<Keyframe> take() override { return source_.take(); }
    [[nodiscard]] bool ready() const override { return source_.ready(); }
    bool wait_until(Instant until) override { return source_.wait_until(until); }
    [[nodiscard]] SourceStatus status() const override { return source_.status(); }
    void stop() override { source_.stop(); }

   private:
    KeyframeSource& source_;
  };
  return std::make_unique<Borrowed>(source);
}

}  // namespace aucast::playback::test

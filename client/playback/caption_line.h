#pragma once

#include <cstddef>
#include <deque>
#include <string>

#include "client/playback/keyframe_source.h"
#include "client/playback/playback.h"
#include "common/time.h"

namespace aucast::playback {

/// The caption that belongs to what is seen and heard, out of those that came before their places.
/// Thread: none of its own.
class CaptionLine {
 public:
  static constexpr std::size_t kWaitingMax = 10'000;
  /// The next caption: its place is that of the one before or later. Must not be full().
  void add(Caption caption);
  /// As many wait as may: the next ones stay where they come from.
  [[nodiscard]] bool full() const { return waiting_.size() >= kWaitingMax; }
  /// Takes what has come of `playback`, until it is full.
  void take_from(Playback& playback);
  /// Moves to `place`. The text stays when places go back.
  void move_to(Duration place);
  /// UTF-8; empty: nothing is said.
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::deque<Caption> waiting_;
  std::string text_;
};

}  // namespace aucast::playback

#pragma once

#include <cstddef>
#include <deque>
#include <string>

#include "client/playback/keyframe_source.h"
#include "client/playback/playback.h"
#include "common/time.h"

namespace aucast::playback {

/// Finds the caption for what is seen and heard among those that came ahead of their places.
/// Thread: none of its own.
class CaptionLine {
 public:
  static constexpr std::size_t kWaitingMax = 10'000;
  /// Adds the next caption, whose place is that of the previous one or later. Must not be full().
  void add(Caption caption);
  /// No more captions fit: the next ones stay in the playback.
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

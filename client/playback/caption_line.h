#pragma once

#include <cstddef>
#include <deque>
#include <string>

#include "client/playback/keyframe_source.h"
#include "client/playback/playback.h"
#include "common/time.h"

namespace aucast::playback {

/// Keeps captions that come ahead of their places, and says which one belongs to the place that is
/// seen and heard.
/// Thread: none of its own.
class CaptionLine {
 public:
  static constexpr std::size_t kWaitingMax = 10'000;
  /// Adds the next caption, whose place is that of the previous one or later. Must not be full().
  void add(Caption caption);
  /// Whether no more captions fit. The next ones then stay in the playback.
  [[nodiscard]] bool full() const { return waiting_.size() >= kWaitingMax; }
  /// Takes the captions that `playback` has, until full().
  void take_from(Playback& playback);
  /// Moves to `place`. If places go back, the text stays.
  void move_to(Duration place);
  /// The caption at the place, UTF-8; empty: none.
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::deque<Caption> waiting_;
  std::string text_;
};

}  // namespace aucast::playback

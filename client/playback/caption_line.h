#pragma once

#include <deque>
#include <string>
#include <utility>

#include "client/playback/keyframe_source.h"
#include "common/time.h"

namespace aucast::playback {

/// The caption that belongs to what is seen and heard, out of those that came before their places.
/// Thread: none of its own.
class CaptionLine {
 public:
  /// The next caption: its place is that of the one before or later.
  void add(Caption caption) { waiting_.push_back(std::move(caption)); }
  /// Moves to `place`. The text stays when places go back.
  void move_to(Duration place);
  /// UTF-8; empty: nothing is said.
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::deque<Caption> waiting_;
  std::string text_;
};

}  // namespace aucast::playback

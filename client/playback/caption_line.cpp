#include "client/playback/caption_line.h"

#include <utility>

#include "common/check.h"

namespace aucast::playback {

void CaptionLine::add(Caption caption) {
  AUCAST_CHECK(!full());
  waiting_.push_back(std::move(caption));
}

void CaptionLine::take_from(Playback& playback) {
  while (!full()) {
    auto caption = playback.take_caption();
    if (!caption) return;
    add(std::move(*caption));
  }
}

void CaptionLine::move_to(Duration place) {
  while (!waiting_.empty() && waiting_.front().place <= place) {
    text_ = std::move(waiting_.front().text);
    waiting_.pop_front();
  }
}

}  // namespace aucast::playback

#include "client/playback/caption_line.h"

#include <utility>

namespace aucast::playback {

void CaptionLine::move_to(Duration place) {
  while (!waiting_.empty() && waiting_.front().place <= place) {
    text_ = std::move(waiting_.front().text);
    waiting_.pop_front();
  }
}

}  // namespace aucast::playback

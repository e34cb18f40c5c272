#include "client/playback/file_source.h"

#include <utility>

namespace aucast::playback {

FileSource::FileSource(KeyframeList keyframes, std::optional<Milliseconds> untimed)
    : keyframes_(std::move(keyframes)), untimed_(untimed) {}

std::optional<Keyframe> FileSource::take() {
  if (stopped_ || next_ == keyframes_.size()) return std::nullopt;
  Keyframe keyframe = keyframes_[next_++];
  if (untimed_) {
    keyframe.span = keyframe.time.value_or(*untimed_);
    place_ += keyframe.span;
    keyframe.place = place_;
  }
  return keyframe;
}

bool FileSource::ready() const {
  return true;
}

bool FileSource::wait_until(Instant /*until*/) {
  return true;
}

SourceStatus FileSource::status() const {
  SourceStatus status;
  status.local = true;
  status.end = stopped_ ? EndReason::Stopped : EndReason::EndOfStream;
  status.playout_fill = stopped_ ? 0 : keyframes_.size() - next_;
  status.keyframes_received = keyframes_.size();
  return status;
}

void FileSource::stop() {
  stopped_ = next_ < keyframes_.size();
}

}  // namespace aucast::playback

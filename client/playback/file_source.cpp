#include "client/playback/file_source.h"

#include <utility>

namespace aucast::playback {

void set_places(std::vector<Keyframe>& keyframes, Milliseconds untimed) {
  Milliseconds place{0};
  for (Keyframe& keyframe : keyframes) {
    keyframe.span = keyframe.time.value_or(untimed);
    place += keyframe.span;
    keyframe.place = place;
  }
}

FileSource::FileSource(std::vector<Keyframe> keyframes) : keyframes_(std::move(keyframes)) {}

std::optional<Keyframe> FileSource::take() {
  if (stopped_ || next_ == keyframes_.size()) return std::nullopt;
  return keyframes_[next_++];
}

bool FileSource::ready() const {
  return true;
}

bool FileSource::wait_until(Instant /*until*/) {
  return true;
}

SourceStatus FileSource::status() const {
  SourceStatus status;
  status.end = stopped_ ? EndReason::Stopped : EndReason::EndOfStream;
  status.playout_fill = stopped_ ? 0 : keyframes_.size() - next_;
  status.keyframes_received = keyframes_.size();
  return status;
}

void FileSource::stop() {
  stopped_ = next_ < keyframes_.size();
}

}  // namespace aucast::playback

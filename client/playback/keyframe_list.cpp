#include "client/playback/keyframe_list.h"

namespace aucast::playback {

KeyframeList::KeyframeList(std::initializer_list<Keyframe> keyframes) {
  reserve(keyframes.size());
  for (const Keyframe& keyframe : keyframes) push_back(keyframe);
}

KeyframeList::KeyframeList(const std::vector<Keyframe>& keyframes) {
  reserve(keyframes.size());
  for (const Keyframe& keyframe : keyframes) push_back(keyframe);
}

void KeyframeList::add(const AuFrame& aus, std::optional<Milliseconds> time) {
  for (std::size_t i = 0; i < kAuCount; ++i) {
    const auto number = static_cast<std::uint8_t>(i);
    if (aus.left[i] == aus.right[i]) {
      if (aus.left[i] != 0) aus_.push_back({number, Side::Both, aus.left[i]});
      continue;
    }
    if (aus.left[i] != 0) aus_.push_back({number, Side::Left, aus.left[i]});
    if (aus.right[i] != 0) aus_.push_back({number, Side::Right, aus.right[i]});
  }
  ends_.push_back({aus_.size(), time ? time->count() : kUntimed});
}

AuFrame KeyframeList::aus(std::size_t index) const {
  AuFrame frame;
  for (std::uint64_t i = index == 0 ? 0 : ends_[index - 1].aus; i < ends_[index].aus; ++i) {
    const Au& au = aus_[i];
    // Not set_intensity(), for which "both" of some AUs means the right side alone.
    if (au.side != Side::Right) frame.left[au.number] = au.intensity;
    if (au.side != Side::Left) frame.right[au.number] = au.intensity;
  }
  return frame;
}

std::optional<Milliseconds> KeyframeList::time(std::size_t index) const {
  if (ends_[index].time_ms == kUntimed) return std::nullopt;
  return Milliseconds(ends_[index].time_ms);
}

Keyframe KeyframeList::operator[](std::size_t index) const {
  return {.aus = aus(index), .time = time(index)};
}

}  // namespace aucast::playback

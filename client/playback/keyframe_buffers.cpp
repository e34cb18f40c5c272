#include "client/playback/keyframe_buffers.h"

#include <algorithm>

#include "common/check.h"

namespace aucast::playback {
namespace {

constexpr std::size_t kCapacityMax = 10'000;

}  // namespace

KeyframeBuffers::KeyframeBuffers(BufferOptions options) : options_(options) {
  AUCAST_CHECK(options.receiver_capacity >= 1 && options.receiver_capacity <= kCapacityMax);
  AUCAST_CHECK(options.playout_capacity >= 1);
  AUCAST_CHECK(options.playout_capacity <= options.receiver_capacity);
  AUCAST_CHECK(options.threshold_percent >= 1 && options.threshold_percent <= 100);
}

KeyframeBuffers::Stored KeyframeBuffers::store(const TimedAus& keyframe) {
  const bool full = room() == 0;
  const bool playing = !playout_.empty();
  if (full && playing) return Stored::No;  // case A
  if (full) fill_playout();                // case B

  // Case D compares before it stores, as figure 5.13 does; a threshold of the whole receiver is
  // therefore reached by case B.
  const bool start = !full && !playing && (ended_ || receiver_.size() >= threshold());
  receiver_.push_back(keyframe);  // all but case A
  if (start) fill_playout();
  return Stored::Yes;
}

std::size_t KeyframeBuffers::room() const {
  return options_.receiver_capacity - receiver_.size();
}

void KeyframeBuffers::release() {
  if (playout_.empty()) fill_playout();
}

void KeyframeBuffers::end_of_stream() {
  ended_ = true;
  release();
}

std::optional<TimedAus> KeyframeBuffers::take() {
  if (playout_.empty()) return std::nullopt;
  const TimedAus keyframe = playout_.front();
  playout_.pop_front();
  if (playout_.empty()) fill_playout();
  return keyframe;
}

bool KeyframeBuffers::has_next() const {
  return !playout_.empty();
}

bool KeyframeBuffers::finished() const {
  return ended_ && playout_.empty() && receiver_.empty();
}

void KeyframeBuffers::fill_playout() {
  const std::size_t places = options_.playout_capacity - playout_.size();
  const std::size_t count = std::min(places, receiver_.size());
  for (std::size_t i = 0; i < count; ++i) {
    playout_.push_back(receiver_.front());
    receiver_.pop_front();
  }
}

std::size_t KeyframeBuffers::threshold() const {
  const auto percent = static_cast<std::size_t>(options_.threshold_percent);
  return (options_.receiver_capacity * percent + 99) / 100;
}

}  // namespace aucast::playback

#include "client/net/received_stream.h"

#include <utility>

namespace aucast::net {

using playback::Keyframe;
using playback::KeyframeBuffers;

ReceivedStream::ReceivedStream(const playback::BufferOptions& options,
                               std::optional<Milliseconds> speed)
    : options_(options), speed_(speed), buffers_(options), timing_(options) {}

void ReceivedStream::begin(const protocol::HelloGranted& hello) {
  hello_ = hello;
  buffers_.set_live(hello.live);
  buffers_.set_untimed(untimed());
  if (hello.live && options_.adapt && !options_.low_delay) {
    buffers_.set_delay(timing_.first_delay());
  }
  clock_shift_ = clock_ - Milliseconds(hello.from_ms);
}

Milliseconds ReceivedStream::untimed() const {
  return speed_.value_or(Milliseconds(hello_.keyframe_ms));
}

void ReceivedStream::add(const protocol::DeliverKeyframe& event, Instant now, bool aside) {
  Keyframe keyframe{event.aus, std::nullopt};
  if (event.time_ms) keyframe.time = Milliseconds(*event.time_ms);
  keyframe.spoken = hello_.live && spoken_.voice_end() > clock_;
  keyframe.span = keyframe.time.value_or(Milliseconds(hello_.keyframe_ms));
  clock_ += keyframe.span;
  keyframe.place = clock_;
  if (hello_.live) keyframe.arrived = now;
  if (hello_.live && !paused_) {
    std::optional<Milliseconds> place;
    if (event.place_ms) place = Milliseconds(*event.place_ms);
    if (const auto delay = timing_.arrived(keyframe, untimed(), place)) buffers_.set_delay(*delay);
  }
  let_in();
  if (aside) {
    aside_ = keyframe;
  } else {
    take_in(keyframe);
  }
}

void ReceivedStream::add(const protocol::VoicePacket& packet) {
  spoken_.add(playback::Voice{packet.place + clock_shift_, packet.opus});
}

void ReceivedStream::add(const protocol::CaptionData& caption) {
  spoken_.add(playback::Caption{Milliseconds(caption.place_ms) + clock_shift_, caption.text});
}

void ReceivedStream::break_off() {
  let_in();
  buffers_.release();
  buffers_.set_live(false);
  timing_.begin_again();
}

void ReceivedStream::forget_aside() {
  if (aside_) clock_ -= aside_->span;
  aside_.reset();
}

void ReceivedStream::end() {
  let_in();
  buffers_.end_of_stream();
}

/// What was kept aside counts.
void ReceivedStream::let_in() {
  if (aside_) take_in(*std::exchange(aside_, std::nullopt));
}

void ReceivedStream::take_in(const Keyframe& keyframe) {
  kept_.push_back(keyframe);
  store_kept();
}

void ReceivedStream::store_kept() {
  while (!kept_.empty() && buffers_.store(kept_.front()) == KeyframeBuffers::Stored::Yes) {
    kept_.pop_front();
  }
}

std::optional<Keyframe> ReceivedStream::take() {
  auto keyframe = buffers_.take();
  store_kept();
  return keyframe;
}

void ReceivedStream::set_paused(bool paused) {
  if (paused_ && !paused) timing_.begin_again();
  paused_ = paused;
}

void ReceivedStream::describe(playback::SourceStatus& status) const {
  status.receiver_fill = buffers_.receiver_fill();
  status.playout_fill = buffers_.playout_fill();
  status.buffered = buffers_.buffered();
  status.delay = hello_.live && options_.low_delay ? timing_.low_delay() : buffers_.delay();
  status.keyframes_dropped = buffers_.dropped();
  status.voice_left_out = spoken_.voice_left_out();
  status.captions_left_out = spoken_.captions_left_out();
  status.keyframe_time = Milliseconds(hello_.keyframe_ms);
  status.live = hello_.live;
  status.voice = !hello_.voice.empty();
  status.captions = hello_.text;
  status.stream = hello_.stream;
  status.title = hello_.title;
}

}  // namespace aucast::net

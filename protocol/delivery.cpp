#include "protocol/delivery.h"

#include <utility>

namespace aucast::protocol {

void Delivery::choose(ServedStream stream) {
  recorded_.reset();
  live_.reset();
  stream_ = std::move(stream);
  if (const RecordedStream* const recorded = stream_.recorded()) {
    recorded_.emplace(*recorded, loop_ || stream_.loops_there(), window_, writer_);
  } else if (const auto& channel = stream_.live()) {
    live_.emplace(*channel, window_, writer_);
  }
}

HelloGranted Delivery::grant(const HelloAsked& asked, std::uint32_t keyframe_ms) {
  HelloGranted granted;
  granted.stream = stream_.name;
  granted.title = stream_.title;
  granted.keyframe_ms = keyframe_ms;
  if (recorded_) recorded_->grant(asked, granted);
  if (live_) live_->grant(asked, granted);
  window_.set_size(static_cast<std::size_t>(granted.window));
  return granted;
}

void Delivery::pump(std::string& out) {
  if (recorded_) recorded_->pump(out);
  if (live_) live_->pump(out);
}

void Delivery::pump_new_moments(std::string& out) {
  if (recorded_) recorded_->pump(out);
  if (live_) live_->pump_new_moments(out);
}

bool Delivery::complete() const {
  return recorded_ ? recorded_->complete() : live_ && live_->complete();
}

void Delivery::answer() {
  if (window_.count_answer() && recorded_) recorded_->on_answered();
}

void Delivery::resume() {
  if (window_.paused() && live_) live_->send_full_next();
  window_.set_paused(false);
}

}  // namespace aucast::protocol

#include "protocol/live_delivery.h"

#include <algorithm>
#include <utility>

#include "protocol/limits.h"

namespace aucast::protocol {

void LiveDelivery::grant(const HelloAsked& asked, HelloGranted& granted) {
  granted_ = true;
  delta_ = asked.delta && channel_.has_changes();
  voice_ = asked.voice == kVoiceCodec && channel_.has_voice();
  text_ = asked.text && channel_.has_captions();
  // What is under way grows old: no more of it than a bearable delay.
  const auto window = static_cast<std::size_t>(std::clamp(asked.window, 0, kWindowMax));
  granted.window = static_cast<int>(std::min(window, channel_.window_max()));
  granted.delta = delta_;
  granted.live = true;
  granted.duration_ms = channel_.duration_ms();
  if (voice_) granted.voice = kVoiceCodec;
  granted.text = text_;
}

std::string_view LiveDelivery::packet_of(const LiveMoment& moment, bool full) const {
  if (!granted_) return moment.classic;
  return delta_ && !full ? moment.changes : moment.full;
}

/// Whether every moment that this client is to get has been sent.
bool LiveDelivery::at_end() const {
  if (!channel_.ended()) return false;
  const LiveMoment* const newest = channel_.newest();
  return !last_moment_ || newest == nullptr || *last_moment_ == newest->number;
}

void LiveDelivery::pump(std::string& out) {
  const LiveMoment* const newest = channel_.newest();
  if (newest == nullptr) return;
  send_moment(*newest, out);
  send_spoken(out);
}

void LiveDelivery::pump_new_moments(std::string& out) {
  for (const LiveMoment& moment : channel_.latest()) {
    if (last_moment_ && moment.number > *last_moment_) send_moment(moment, out);
  }
  pump(out);
}

void LiveDelivery::send_moment(const LiveMoment& moment, std::string& out) {
  if (at_end() || !window_.may_send() || last_moment_ == moment.number) return;
  const std::uint64_t merged = last_moment_ ? moment.number - *last_moment_ - 1 : 0;
  const bool full = std::exchange(full_next_, false) || merged > 0;
  const bool cut = !last_moment_ || merged > 0;
  if (!last_moment_) {
    joined_at_ = moment.begin;
    next_voice_ = channel_.voice().first_number();
  }
  writer_.count_merged(merged);
  last_moment_ = moment.number;
  shift_ = sent_to_ - moment.begin;
  if (cut) skip_spoken_before(moment.begin);
  sent_to_ += moment.time;
  send_spoken(out);
  writer_.write_keyframe(packet_of(moment, full), out);
  window_.count_sent();
}

/// What was to be heard before this place is left out; the caption that stands there is not.
void LiveDelivery::skip_spoken_before(Milliseconds place) {
  heard_from_ = place;
  const auto& captions = channel_.captions();
  next_caption_ = std::max(next_caption_, captions.first_number());
  while (const CaptionData* const next = captions.find(next_caption_ + 1)) {
    if (Milliseconds(next->place_ms) > place) break;
    ++next_caption_;
  }
}

/// Where on the client's clock the voice and captions end that may be sent now. What comes after
/// the moments sent has its place there only if the next moment is not left out: so it waits while
/// a moment waits, or would have to.
Milliseconds LiveDelivery::spoken_end() const {
  const bool waits = last_moment_ != channel_.newest()->number || !window_.may_send();
  return waits ? sent_to_ : Milliseconds::max();
}

void LiveDelivery::send_spoken(std::string& out) {
  if (window_.paused() || window_.blocked() || !last_moment_) return;
  const Milliseconds end = spoken_end();
  if (text_) {
    const auto& captions = channel_.captions();
    next_caption_ = std::max(next_caption_, captions.first_number());
    for (; const CaptionData* const caption = captions.find(next_caption_); ++next_caption_) {
      if (Milliseconds(caption->place_ms) + shift_ >= end) break;
      writer_.write_caption(*caption, shift_, out);
    }
  }
  if (!voice_) return;
  const auto& voice = channel_.voice();
  if (const std::uint64_t first = voice.first_number(); first > next_voice_) {
    writer_.count_left_out(first - std::exchange(next_voice_, first));
  }
  for (; const EncodedVoice* const packet = voice.find(next_voice_); ++next_voice_) {
    if (packet->begin < heard_from_) {
      // What was before is nobody's loss.
      if (packet->begin >= joined_at_) writer_.count_left_out(1);
      continue;
    }
    if (packet->begin + shift_ >= end) break;
    writer_.write_voice(*packet, shift_, out);
  }
}

}  // namespace aucast::protocol

#include "protocol/recorded_delivery.h"

#include <algorithm>
#include <optional>

#include "protocol/limits.h"

namespace aucast::protocol {

void RecordedDelivery::grant(const HelloAsked& asked, HelloGranted& granted) {
  const SpokenTrack* const track = stream_.spoken.get();
  delta_ = asked.delta && !stream_.encoded->changes.empty();
  voice_ = asked.voice == kVoiceCodec && track != nullptr && track->voice;
  text_ = asked.text && track != nullptr && track->has_captions();
  if (sends_spoken()) encoded_ = stream_.for_listeners().get();
  packets_ = delta_ ? &encoded_->changes : &encoded_->negotiated;
  // A recorded stream has no clock of its own: without answers nothing would pace it.
  granted.window = std::clamp(asked.window, 1, kWindowMax);
  granted.delta = delta_;
  granted.loop = asked.loop && loops_;
  starts_again_ = loops_ && !granted.loop;
  // A stream that starts again has no length.
  if (!starts_again_) granted.duration_ms = encoded_->duration_ms;
  granted.from_ms = begin_at(asked.from_ms);
  if (voice_) granted.voice = kVoiceCodec;
  granted.text = text_;
}

/// Goes to where a client that asks for `from_ms` begins, and returns that place.
std::uint64_t RecordedDelivery::begin_at(std::uint64_t from_ms) {
  const auto [keyframe, begin] = entry_at(*encoded_, from_ms, starts_again_);
  next_packet_ = next_answered_ = keyframe;
  sent_to_ = answered_to_ = Milliseconds(begin);
  // The packet that is sounding at the beginning, and the caption that stands there, belong to it.
  heard_from_ = sent_to_;
  if (!stream_.spoken || begin == 0) return begin;
  const auto& captions = stream_.spoken->captions;
  while (next_caption_ + 1 < captions.size() && captions[next_caption_ + 1].place_ms <= begin) {
    ++next_caption_;
  }
  return begin;
}

void RecordedDelivery::on_answered() {
  if (!sends_spoken()) return;
  const auto& times = encoded_->times;
  answered_to_ += times[next_answered_ % times.size()];
  ++next_answered_;
}

/// Whether there is another keyframe.
bool RecordedDelivery::has_next() const {
  const bool again = starts_again_ && encoded_->extent == Extent::Whole;
  return next_packet_ < packets_->size() || (again && !packets_->empty());
}

bool RecordedDelivery::broken_off() const {
  return encoded_->extent == Extent::BrokenOff && !has_next();
}

bool RecordedDelivery::complete() const {
  return window_.settled() && at_end() && (!voice_ || stream_.spoken->voice->complete());
}

void RecordedDelivery::pump(std::string& out) {
  while (window_.may_send() && has_next()) {
    if (is_full(out)) return;
    if (next_packet_ == packets_->size()) begin_turn();
    if (sends_spoken()) {
      const Milliseconds end = sent_to_ + encoded_->times[next_packet_];
      if (!spoken_may_reach(end)) return;
      const bool turns = loops_ && ends_turn(end - turn_begin_);
      if (!send_spoken(end, turns ? end : Milliseconds::max(), out)) return;
      sent_to_ = end;
    }
    // The first one names the whole face, wherever the stream begins.
    const bool full = delta_ && writer_.counts().keyframes == 0;
    const PacketList& packets = full ? encoded_->negotiated : *packets_;
    writer_.write_keyframe(packets[next_packet_++], out);
    if (window_.count_sent()) on_answered();
  }
  // Before {-2}: what sounds on after the last keyframe, while the face holds.
  if (sends_spoken() && complete()) {
    static_cast<void>(send_spoken(Milliseconds::max(), Milliseconds::max(), out));
  }
}

/// Whether `out` has all that one call may put out. Then the rest waits for set_blocked(false).
bool RecordedDelivery::is_full(const std::string& out) {
  if (out.size() >= kOutputBytesMax) window_.set_blocked(true);
  return window_.blocked();
}

void RecordedDelivery::begin_turn() {
  next_packet_ = 0;
  next_voice_ = 0;
  next_caption_ = 0;
  turn_begin_ = sent_to_;
}

/// Whether the next keyframe, which ends at this place of its turn, is the last of the turn. The
/// newest that a relay has so far need not be.
bool RecordedDelivery::ends_turn(Milliseconds place) const {
  if (next_packet_ + 1 < packets_->size()) return false;
  const std::optional<std::uint64_t> duration = encoded_->duration_ms;
  return encoded_->extent == Extent::Whole || (duration && place >= Milliseconds(*duration));
}

/// Whether the sound up to `end` is there and may run so far ahead of the answers.
bool RecordedDelivery::spoken_may_reach(Milliseconds end) const {
  if (!voice_) return true;
  if (stream_.spoken->voice->encoded_until() < end - turn_begin_) return false;
  return window_.in_flight() == 0 || end <= answered_to_ + kVoiceAheadMax;
}

/// The sound that begins before `end`. Of the voice, what is over by `turn_end`: in a loop what
/// would reach into the next turn would cost the beginning of that. Returns false if not all of it
/// is sent, since there is no more room in `out`.
bool RecordedDelivery::send_spoken(Milliseconds end, Milliseconds turn_end, std::string& out) {
  if (text_) {
    const auto& captions = stream_.spoken->captions;
    for (; next_caption_ < captions.size(); ++next_caption_) {
      if (Milliseconds(captions[next_caption_].place_ms) + turn_begin_ >= end) break;
      if (is_full(out)) return false;
      writer_.write_caption(captions[next_caption_], turn_begin_, out);
    }
  }
  if (!voice_) return true;
  const auto voice = stream_.spoken->voice->packets();
  for (; next_voice_ < voice.size(); ++next_voice_) {
    if (voice[next_voice_].begin + turn_begin_ >= end) break;
    if (voice[next_voice_].end + turn_begin_ > turn_end) break;
    if (voice[next_voice_].end + turn_begin_ <= heard_from_) continue;
    if (is_full(out)) return false;
    writer_.write_voice(voice[next_voice_], turn_begin_, out);
  }
  return true;
}

}  // namespace aucast::protocol

#include "protocol/delivery.h"

#include <algorithm>
#include <utility>

#include "protocol/codec.h"
#include "protocol/limits.h"

namespace aucast::protocol {

HelloGranted Delivery::grant(const HelloAsked& asked, std::uint32_t keyframe_ms) {
  const LiveChannel* const live = stream_.live().get();
  const SpokenTrack* const track = live != nullptr ? nullptr : spoken();
  granted_ = true;
  window_ = window_for(asked.window);
  if (live != nullptr) {
    delta_ = asked.delta && live->has_changes();
    voice_ = asked.voice == kVoiceCodec && live->has_voice();
    text_ = asked.text && live->has_captions();
  } else {
    delta_ = asked.delta && !stream_.recorded()->encoded->changes.empty();
    voice_ = asked.voice == kVoiceCodec && track != nullptr && track->voice;
    text_ = asked.text && track != nullptr && track->has_captions();
  }
  HelloGranted granted;
  granted.window = static_cast<int>(window_);
  granted.delta = delta_;
  granted.live = live != nullptr;
  granted.stream = stream_.name;
  granted.loop = asked.loop && live == nullptr && loops();
  one_turn_ = granted.loop;
  // A stream that starts again has no length.
  if (live != nullptr) granted.duration_ms = live->duration_ms();
  if (live == nullptr && !loops()) granted.duration_ms = recorded().duration_ms;
  granted.keyframe_ms = keyframe_ms;
  granted.from_ms = begin_at(asked.from_ms);
  if (voice_) granted.voice = kVoiceCodec;
  granted.text = text_;
  granted.title = stream_.title;
  return granted;
}

/// Goes to where a client that asks for `from_ms` begins, and returns that place. A live stream
/// always begins at 0, with the present moment.
std::uint64_t Delivery::begin_at(std::uint64_t from_ms) {
  if (stream_.live()) return 0;
  const auto [keyframe, begin] = entry_at(recorded(), from_ms, loops());
  next_packet_ = next_answered_ = keyframe;
  sent_to_ = answered_to_ = Milliseconds(begin);
  // The packet that is sounding at the beginning, and the caption that stands there, belong to it.
  heard_from_ = sent_to_;
  const SpokenTrack* const track = spoken();
  if (track == nullptr || begin == 0) return begin;
  const auto& captions = track->captions;
  while (next_caption_ + 1 < captions.size() && captions[next_caption_ + 1].place_ms <= begin) {
    ++next_caption_;
  }
  return begin;
}

void Delivery::answer() {
  if (in_flight_ == 0) {
    ++banked_;
    return;
  }
  --in_flight_;
  if (stream_.live() || !sends_spoken()) return;
  const auto& times = recorded().times;
  answered_to_ += times[next_answered_ % times.size()];
  ++next_answered_;
}

void Delivery::resume() {
  full_next_ = full_next_ || paused_;
  paused_ = false;
}

const EncodedStream& Delivery::recorded() const {
  const RecordedStream& stream = *stream_.recorded();
  return sends_spoken() ? *stream.for_listeners() : *stream.encoded;
}

const PacketList& Delivery::packets() const {
  if (!granted_) return stream_.recorded()->encoded->classic;
  return delta_ ? recorded().changes : recorded().negotiated;
}

std::string_view Delivery::packet_of(const LiveMoment& moment, bool full) const {
  if (!granted_) return moment.classic;
  return delta_ && !full ? moment.changes : moment.full;
}

std::size_t Delivery::window_for(int asked) const {
  const auto most = static_cast<std::size_t>(std::clamp(asked, 0, kWindowMax));
  // A recorded stream has no clock of its own: without answers nothing would pace it.
  if (!stream_.live()) return std::max<std::size_t>(most, 1);
  // What is under way grows old: no more of it than a bearable delay.
  return std::min(most, stream_.live()->window_max());
}

bool Delivery::may_send() const {
  return !paused_ && !blocked_ && (window_ == 0 || in_flight_ < window_);
}

/// Whether there is another keyframe of a recorded stream.
bool Delivery::has_next() const {
  const bool again = loops() && recorded().extent == Extent::Whole;
  return next_packet_ < packets().size() || (again && !packets().empty());
}

bool Delivery::broken_off() const {
  return !stream_.live() && recorded().extent == Extent::BrokenOff && !has_next();
}

/// Whether every keyframe that this client is to get has been sent.
bool Delivery::at_end() const {
  if (!stream_.live()) return recorded().extent == Extent::Whole && !has_next();
  if (!stream_.live()->ended()) return false;
  const LiveMoment* const newest = stream_.live()->newest();
  return !last_moment_ || newest == nullptr || *last_moment_ == newest->number;
}

bool Delivery::complete() const {
  const bool all_there = !voice_ || stream_.live() || spoken()->voice->complete();
  return !paused_ && !blocked_ && in_flight_ == 0 && at_end() && all_there;
}

void Delivery::send_keyframe(std::string_view packet, std::string& out) {
  out += packet;
  ++sent_.keyframes;
  sent_.payload_bytes += packet.size();
  if (window_ == 0) return;
  ++in_flight_;
  if (banked_ > 0) {
    --banked_;
    answer();
  }
}

void Delivery::pump(std::string& out) {
  if (!stream_.live()) {
    send_recorded(out);
  } else if (const LiveMoment* const newest = stream_.live()->newest()) {
    send_moment(*newest, out);
    send_live_spoken(out);
  }
}

void Delivery::pump_new_moments(std::string& out) {
  for (const LiveMoment& moment : stream_.live()->latest()) {
    if (last_moment_ && moment.number > *last_moment_) send_moment(moment, out);
  }
  pump(out);
}

// === Recorded

void Delivery::send_recorded(std::string& out) {
  while (may_send() && has_next()) {
    if (is_full(out)) return;
    if (next_packet_ == packets().size()) begin_turn();
    if (sends_spoken()) {
      const Milliseconds end = sent_to_ + recorded().times[next_packet_];
      if (!spoken_may_reach(end)) return;
      const bool turns = in_loop() && ends_turn(end - turn_begin_);
      if (!send_spoken(end, turns ? end : Milliseconds::max(), out)) return;
      sent_to_ = end;
    }
    // The first one names the whole face, wherever the stream begins.
    const bool full = delta_ && sent_.keyframes == 0;
    const PacketList& encoded = full ? recorded().negotiated : packets();
    send_keyframe(encoded[next_packet_++], out);
  }
  // What sounds on after the last keyframe, while the face holds.
  if (sends_spoken() && complete()) {
    static_cast<void>(send_spoken(Milliseconds::max(), Milliseconds::max(), out));
  }
}

/// Whether `out` has all that one call may put out. Then the rest waits for set_blocked(false).
bool Delivery::is_full(const std::string& out) {
  if (out.size() >= kOutputBytesMax) blocked_ = true;
  return blocked_;
}

void Delivery::begin_turn() {
  next_packet_ = 0;
  next_voice_ = 0;
  next_caption_ = 0;
  turn_begin_ = sent_to_;
}

/// Whether the next keyframe, which ends at this place of its turn, is the last of the turn. The
/// newest that a relay has so far need not be.
bool Delivery::ends_turn(Milliseconds place) const {
  if (next_packet_ + 1 < packets().size()) return false;
  const std::optional<std::uint64_t> duration = recorded().duration_ms;
  return recorded().extent == Extent::Whole || (duration && place >= Milliseconds(*duration));
}

/// Whether the sound up to `end` is there and may run so far ahead of the answers.
bool Delivery::spoken_may_reach(Milliseconds end) const {
  if (!voice_) return true;
  if (spoken()->voice->encoded_until() < end - turn_begin_) return false;
  return in_flight_ == 0 || end <= answered_to_ + kVoiceAheadMax;
}

/// The sound that begins before `end`. Of the voice, what is over by `turn_end`: in a loop what
/// would reach into the next turn would cost the beginning of that. Returns false if not all of it
/// is sent, since there is no more room in `out`.
bool Delivery::send_spoken(Milliseconds end, Milliseconds turn_end, std::string& out) {
  if (text_) {
    const auto& captions = spoken()->captions;
    for (; next_caption_ < captions.size(); ++next_caption_) {
      if (Milliseconds(captions[next_caption_].place_ms) + turn_begin_ >= end) break;
      if (is_full(out)) return false;
      send_caption(captions[next_caption_], turn_begin_, out);
    }
  }
  if (!voice_) return true;
  const auto voice = spoken()->voice->packets();
  for (; next_voice_ < voice.size(); ++next_voice_) {
    if (voice[next_voice_].begin + turn_begin_ >= end) break;
    if (voice[next_voice_].end + turn_begin_ > turn_end) break;
    if (voice[next_voice_].end + turn_begin_ <= heard_from_) continue;
    if (is_full(out)) return false;
    send_voice(voice[next_voice_], turn_begin_, out);
  }
  return true;
}

// === Live

void Delivery::send_moment(const LiveMoment& moment, std::string& out) {
  if (at_end() || !may_send() || last_moment_ == moment.number) return;
  const std::uint64_t merged = last_moment_ ? moment.number - *last_moment_ - 1 : 0;
  const bool full = std::exchange(full_next_, false) || merged > 0;
  const bool cut = !last_moment_ || merged > 0;
  if (!last_moment_) {
    joined_at_ = moment.begin;
    next_voice_ = stream_.live()->voice().first_number();
  }
  sent_.keyframes_merged += merged;
  last_moment_ = moment.number;
  shift_ = sent_to_ - moment.begin;
  if (cut) skip_spoken_before(moment.begin);
  sent_to_ += moment.time;
  send_live_spoken(out);
  send_keyframe(packet_of(moment, full), out);
}

/// What was to be heard before this place is left out; the caption that stands there is not.
void Delivery::skip_spoken_before(Milliseconds place) {
  heard_from_ = place;
  const auto& captions = stream_.live()->captions();
  next_caption_ = std::max(next_caption_, captions.first_number());
  while (const CaptionData* const next = captions.find(next_caption_ + 1)) {
    if (Milliseconds(next->place_ms) > place) break;
    ++next_caption_;
  }
}

/// Where on the client's clock the voice and captions end that may be sent now. What comes after
/// the moments sent has its place there only if the next moment is not left out: so it waits while
/// a moment waits, or would have to.
Milliseconds Delivery::live_spoken_end() const {
  const bool waits = last_moment_ != stream_.live()->newest()->number || !may_send();
  return waits ? sent_to_ : Milliseconds::max();
}

void Delivery::send_live_spoken(std::string& out) {
  if (paused_ || blocked_ || !last_moment_) return;
  const Milliseconds end = live_spoken_end();
  if (text_) {
    const auto& captions = stream_.live()->captions();
    next_caption_ = std::max(next_caption_, captions.first_number());
    for (; const CaptionData* const caption = captions.find(next_caption_); ++next_caption_) {
      if (Milliseconds(caption->place_ms) + shift_ >= end) break;
      send_caption(*caption, shift_, out);
    }
  }
  if (!voice_) return;
  const auto& voice = stream_.live()->voice();
  if (voice.first_number() > next_voice_) {
    sent_.voice_left_out += voice.first_number() - std::exchange(next_voice_, voice.first_number());
  }
  for (; const EncodedVoice* const packet = voice.find(next_voice_); ++next_voice_) {
    if (packet->begin < heard_from_) {
      // What was before is nobody's loss.
      if (packet->begin >= joined_at_) ++sent_.voice_left_out;
      continue;
    }
    if (packet->begin + shift_ >= end) break;
    send_voice(*packet, shift_, out);
  }
}

void Delivery::send_voice(const EncodedVoice& voice, Milliseconds shift, std::string& out) {
  const std::size_t before = out.size();
  if (!voice_cursor_.send(voice, shift, out)) {
    ++sent_.voice_left_out;
    return;
  }
  ++sent_.voice_packets;
  sent_.spoken_bytes += out.size() - before;
}

void Delivery::send_caption(const CaptionData& caption, Milliseconds shift, std::string& out) {
  // The caption that stands where a live client goes on began before that.
  last_caption_ = std::max(Milliseconds(caption.place_ms) + shift, last_caption_);
  const std::string packet =
      encode(CaptionData{static_cast<std::uint64_t>(last_caption_.count()), caption.text});
  // Another server's may have been so long that it only fitted with its place there.
  if (packet.size() > kCaptionBytesMax) return;
  sent_.spoken_bytes += packet.size();
  out += packet;
}

}  // namespace aucast::protocol

#include "client/net/au_reader.h"

#include <algorithm>
#include <utility>
#include <variant>

namespace aucast::net {
namespace {

using playback::EndReason;
using playback::Keyframe;
using playback::KeyframeBuffers;
using protocol::SessionFailed;

constexpr std::size_t kWindowAsked = 64;

EndReason end_reason(SessionFailed::Why why) {
  switch (why) {
    case SessionFailed::Why::Lost:
      return EndReason::ConnectionLost;
    case SessionFailed::Why::ProtocolError:
      return EndReason::ProtocolError;
    case SessionFailed::Why::Refused:
      return EndReason::Refused;
    case SessionFailed::Why::Silent:
      break;
  }
  return EndReason::Unreachable;
}

/// What the user can do about it.
std::string_view remedy(SessionFailed::Why why) {
  switch (why) {
    case SessionFailed::Why::Lost:
      return "; the server's log may say why";
    case SessionFailed::Why::ProtocolError:
      return "; is it an au-transmitter?";
    case SessionFailed::Why::Refused:
      return "";
    case SessionFailed::Why::Silent:
      break;
  }
  return "; is it an au-transmitter? --connect-timeout sets how long to wait";
}

}  // namespace

protocol::ClientSessionOptions AuReader::session_options(const AuReaderOptions& options,
                                                         const Manner& manner) {
  protocol::ClientSessionOptions session;
  session.negotiate = manner.hello;
  session.hello.window =
      manner.answers ? static_cast<int>(std::min(kWindowAsked, options.buffers.receiver_capacity))
                     : 0;
  session.hello.stream = options.stream;
  session.hello.delta = true;
  session.hello.token = options.token;
  if (options.voice) session.hello.voice = protocol::kVoiceCodec;
  session.hello.text = options.captions;
  session.silence_max = options.silence_max;
  return session;
}

void AuReader::begin_session() {
  protocol::ClientSessionOptions again = session_options(options_, manner_);
  if (!status_.live) {
    again.hello.from_ms = static_cast<std::uint64_t>((clock_ - clock_shift_).count());
  }
  session_ = protocol::ClientSession(std::move(again));
}

AuReader::AuReader(AuReaderOptions options)
    : options_(std::move(options)),
      manner_{.hello = !options_.classic, .answers = !options_.buffers.low_delay},
      session_(session_options(options_, manner_)),
      buffers_(options_.buffers),
      timing_(options_.buffers),
      retries_({options_.reconnect, options_.one_round, options_.hosts}) {}

Reaction AuReader::connected(Instant now, Duration round_trip) {
  connected_at_ = now;
  timing_.connected(round_trip);
  status_.connected = true;
  status_.receive_seconds = 0;
  waiting_.clear();
  called_for_speak_ = false;  // the call may have come while there was no connection to speak on
  Reaction reaction;
  reaction.changed = true;
  react(session_.on_connected(now), reaction, now);
  return reaction;
}

Reaction AuReader::received(std::string_view bytes, Instant now) {
  waiting_ += bytes;
  Reaction reaction;
  decode_waiting(reaction, now);
  return reaction;
}

Reaction AuReader::closed(Instant now, std::string_view broke) {
  Reaction reaction;
  react(session_.on_closed(broke), reaction, now);
  return reaction;
}

Reaction AuReader::time(Instant now) {
  Reaction reaction;
  if (!waiting_.empty()) return reaction;
  react(session_.on_time(now), reaction, now);
  answer(reaction.send);
  return reaction;
}

std::optional<Instant> AuReader::deadline() const {
  // What waits for room is not silence of the server's.
  if (status_.end != EndReason::NotEnded || !waiting_.empty()) return std::nullopt;
  const auto deadline = session_.deadline();
  const auto due = ledger_.deadline(session_, wishes(), now_);
  return due ? std::min(deadline.value_or(Instant::max()), *due) : deadline;
}

Reaction AuReader::unreachable(std::string reason) {
  Reaction reaction;
  reaction.changed = true;
  std::optional<Milliseconds> wait;
  if (status_.end == EndReason::NotEnded) wait = retries_.unreachable(keyframes_came());
  if (wait) {
    begin_again(reaction, reason, *wait);
  } else {
    reaction.next = Reaction::Next::Close;
    end(EndReason::Unreachable, std::move(reason));
  }
  return reaction;
}

Reaction AuReader::refused(EndReason why, const std::string& reason) {
  Reaction reaction;
  reaction.changed = true;
  reaction.next = Reaction::Next::Close;
  end(why, options_.peer + ": " + reason);
  return reaction;
}

/// After a loss: what was received is played until the next attempt.
void AuReader::begin_again(Reaction& reaction, const std::string& reason, Milliseconds wait) {
  if (first_) take_in(*std::exchange(first_, std::nullopt));
  buffers_.release();
  buffers_.set_live(false);
  lost_.keyframes += session_.keyframes_received();
  lost_.bytes += session_.payload_bytes();
  ledger_.forget();
  manner_.hello = !options_.classic;
  begin_session();
  timing_.begin_again();
  status_.connected = false;
  status_.negotiated = false;
  ++status_.reconnects;
  reaction.send.clear();
  reaction.next = Reaction::Next::ReconnectLater;
  reaction.retry_after = wait;
  status_.reason = reason;
  status_.retry_after = wait;
  status_.detail = reason + "; trying again in " + std::to_string(wait.count() / 1000) + " s";
}

Retries::Keyframes AuReader::keyframes_came() const {
  return {.earlier = lost_.keyframes > 0, .now = session_.keyframes_received() > 0};
}

Reaction AuReader::speak(Instant now) {
  called_for_speak_ = false;
  Reaction reaction;
  answer(reaction.send);
  reaction.changed = !reaction.send.empty();
  decode_waiting(reaction, now);
  return reaction;
}

std::string AuReader::farewell() {
  return session_.stop();
}

bool AuReader::wants_bytes() const {
  return waiting_.empty();
}

bool AuReader::may_decode() const {
  return status_.end == EndReason::NotEnded && kept_.size() < kept_max() && ledger_.has_room();
}

/// Keyframe by keyframe, so that each is answered before the session counts the next as sent ahead.
void AuReader::decode_waiting(Reaction& reaction, Instant now) {
  std::string_view rest = waiting_;
  while (!rest.empty() && may_decode() && reaction.next == Reaction::Next::GoOn) {
    react(session_.on_bytes(rest), reaction, now);
  }
  waiting_.erase(0, waiting_.size() - rest.size());
}

void AuReader::react(const std::vector<protocol::ClientEvent>& events, Reaction& reaction,
                     Instant now) {
  now_ = now;
  for (const protocol::ClientEvent& event : events) {
    if (status_.end != EndReason::NotEnded) break;
    status_.receive_seconds = seconds(now - connected_at_);
    std::visit([&](const auto& what) { handle(what, reaction); }, event);
  }
}

void AuReader::handle(const protocol::SendBytes& event, Reaction& reaction) {
  reaction.send += event.bytes;
}

void AuReader::handle(const protocol::DeliverKeyframe& event, Reaction& reaction) {
  reaction.changed = true;
  const bool first = session_.keyframes_received() == 1;
  if (first && retries_.ever_granted() && !negotiated()) forget_hello();
  retries_.keyframe_came();
  Keyframe keyframe{event.aus, std::nullopt};
  if (event.time_ms) keyframe.time = Milliseconds(*event.time_ms);
  const Milliseconds time = keyframe.time.value_or(status_.keyframe_time);
  keyframe.spoken = status_.live && spoken_.voice_end() > clock_;
  clock_ += time;
  keyframe.place = clock_;
  keyframe.span = time;
  if (status_.live) note_live(event, keyframe);

  ledger_.owe(now_);
  if (first && manner_.hello && !negotiated()) {
    first_ = keyframe;
  } else {
    if (first_) take_in(*std::exchange(first_, std::nullopt));
    take_in(keyframe);
  }
  answer(reaction.send);
}

void AuReader::handle(const protocol::Granted& event, Reaction& reaction) {
  retries_.granted();
  if (!manner_.answers && !event.hello.live) {
    // Only a live stream goes without answers; a recorded one would come keyframe by keyframe.
    manner_.answers = true;
    connect_anew(reaction);
    return;
  }
  reaction.changed = true;
  status_.negotiated = true;
  status_.keyframe_time = Milliseconds(event.hello.keyframe_ms);
  status_.live = event.hello.live;
  buffers_.set_live(status_.live);
  buffers_.set_untimed(options_.speed.value_or(status_.keyframe_time));
  if (options_.buffers.adapt && !options_.buffers.low_delay && status_.live)
    buffers_.set_delay(timing_.first_delay());
  clock_shift_ = clock_ - Milliseconds(event.hello.from_ms);
  status_.voice = !event.hello.voice.empty();
  status_.captions = event.hello.text;
  status_.stream = event.hello.stream;
  status_.title = event.hello.title;
  answer(reaction.send);  // the user may have paused already
}

/// A classic server has begun: nothing that the hello of an earlier connection said holds. Until a
/// keyframe proves it one, it may be that earlier server, which is just about to come back.
void AuReader::forget_hello() {
  const playback::SourceStatus unknown;
  status_.keyframe_time = unknown.keyframe_time;
  status_.live = unknown.live;
  status_.voice = unknown.voice;
  status_.captions = unknown.captions;
  status_.stream = unknown.stream;
  status_.title = unknown.title;
  buffers_.set_live(false);
  buffers_.set_untimed(options_.speed.value_or(status_.keyframe_time));
  clock_shift_ = clock_;  // its stream begins here
}

void AuReader::handle(const protocol::DeliverVoice& event, Reaction& reaction) {
  reaction.changed = true;
  spoken_.add(playback::Voice{event.packet.place + clock_shift_, event.packet.opus});
}

void AuReader::handle(const protocol::DeliverCaption& event, Reaction& reaction) {
  reaction.changed = true;
  spoken_.add(
      playback::Caption{Milliseconds(event.caption.place_ms) + clock_shift_, event.caption.text});
}

void AuReader::handle(const protocol::StreamEnded& /*event*/, Reaction& reaction) {
  reaction.changed = true;
  reaction.next = Reaction::Next::Close;
  end(EndReason::EndOfStream, "the stream of " + options_.peer + " has ended");
}

void AuReader::handle(const protocol::ReconnectClassic& /*event*/, Reaction& reaction) {
  manner_.hello = false;
  connect_anew(reaction);
}

/// Asks for a new connection at once, to talk in another way. Nothing from this one counts.
void AuReader::connect_anew(Reaction& reaction) {
  reaction = {};
  reaction.changed = true;
  reaction.next = Reaction::Next::Reconnect;
  if (first_) clock_ -= first_->span;
  first_.reset();
  ledger_.forget();
  status_.connected = false;
  begin_session();
}

void AuReader::handle(const protocol::SessionFailed& event, Reaction& reaction) {
  reaction.changed = true;
  if (const auto wait = retries_.failed(event, keyframes_came())) {
    return begin_again(reaction, options_.peer + ": " + event.reason, *wait);
  }
  reaction.next = Reaction::Next::Close;
  status_.refusal = event.code;
  end(end_reason(event.why), options_.peer + ": " + event.reason + std::string(remedy(event.why)));
}

void AuReader::note_live(const protocol::DeliverKeyframe& event, Keyframe& keyframe) {
  keyframe.arrived = now_;
  if (user_paused_) return;
  std::optional<Milliseconds> place;
  if (event.place_ms) place = Milliseconds(*event.place_ms);
  const Milliseconds untimed = options_.speed.value_or(status_.keyframe_time);
  if (const auto delay = timing_.arrived(keyframe, untimed, place)) buffers_.set_delay(*delay);
}

void AuReader::take_in(const Keyframe& keyframe) {
  store_kept();
  const bool stored = kept_.empty() && buffers_.store(keyframe) == KeyframeBuffers::Stored::Yes;
  if (!stored) kept_.push_back(keyframe);
}

void AuReader::store_kept() {
  while (!kept_.empty() && buffers_.store(kept_.front()) == KeyframeBuffers::Stored::Yes) {
    kept_.pop_front();
  }
}

void AuReader::answer(std::string& send) {
  if (status_.end == EndReason::NotEnded) send += ledger_.speak(session_, wishes(), now_);
}

AnswerLedger::Wishes AuReader::wishes() const {
  return {user_paused_, !kept_.empty(), status_.voice};
}

bool AuReader::negotiated() const {
  return session_.level() == protocol::Level::Negotiated;
}

/// How many keyframes are kept beside the buffers. In classic one: what comes after it is not read.
/// In level 2 as many as may be under way when the server is told to pause.
std::size_t AuReader::kept_max() const {
  return negotiated() ? static_cast<std::size_t>(std::max(session_.window(), 1)) : 1;
}

void AuReader::end(EndReason reason, std::string detail) {
  if (status_.end != EndReason::NotEnded) return;
  status_.end = reason;
  status_.detail = std::move(detail);
  status_.connected = false;
  if (first_) take_in(*std::exchange(first_, std::nullopt));
  buffers_.end_of_stream();
}

std::optional<Keyframe> AuReader::take() {
  if (left()) return std::nullopt;
  auto keyframe = buffers_.take();
  store_kept();
  return keyframe;
}

std::optional<playback::Voice> AuReader::take_voice() {
  return left() ? std::nullopt : spoken_.take_voice();
}

std::optional<playback::Caption> AuReader::take_caption() {
  return left() ? std::nullopt : spoken_.take_caption();
}

bool AuReader::ready() const {
  return left() || buffers_.has_next() || buffers_.finished();
}

bool AuReader::has_output() const {
  if (status_.end != EndReason::NotEnded || !status_.connected) return false;
  return (!waiting_.empty() && may_decode()) || ledger_.has_output(session_, wishes(), now_);
}

bool AuReader::calls_for_speak() {
  if (called_for_speak_ || !has_output()) return false;
  called_for_speak_ = true;
  return true;
}

void AuReader::set_paused(bool paused) {
  if (user_paused_ && !paused) timing_.begin_again();
  user_paused_ = paused;
}

void AuReader::leave() {
  if (left() || buffers_.finished()) return;
  status_.connected = false;
  status_.end = EndReason::Stopped;
  status_.detail = "stopped by the user";
}

playback::SourceStatus AuReader::status() const {
  playback::SourceStatus status = status_;
  status.receiver_fill = buffers_.receiver_fill();
  status.playout_fill = buffers_.playout_fill();
  status.paused = user_paused_ || session_.paused();
  status.keyframes_received = lost_.keyframes + session_.keyframes_received();
  status.bytes_received = lost_.bytes + session_.payload_bytes();
  status.keyframes_dropped = buffers_.dropped();
  status.voice_left_out = spoken_.voice_left_out();
  status.captions_left_out = spoken_.captions_left_out();
  status.pauses_sent = ledger_.pauses_sent();
  status.resumes_sent = ledger_.resumes_sent();
  status.delay = buffers_.delay();
  if (status_.live && options_.buffers.low_delay) {
    status.delay = timing_.low_delay();
  }
  status.buffered = buffers_.buffered();
  return status;
}

}  // namespace aucast::net

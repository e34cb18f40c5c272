#include "client/net/au_reader.h"

#include <algorithm>
#include <utility>
#include <variant>

namespace aucast::net {
namespace {

using playback::EndReason;
using protocol::SessionFailed;

constexpr std::size_t kWindowAsked = 64;

int window_asked(const AuReaderOptions& options) {
  return static_cast<int>(std::min(kWindowAsked, options.buffers.receiver_capacity));
}

/// How the first connection is begun.
protocol::ClientSessionOptions first_manner(const AuReaderOptions& options) {
  protocol::ClientSessionOptions manner;
  manner.negotiate = !options.classic;
  manner.hello.window = options.buffers.low_delay ? 0 : window_asked(options);
  manner.hello.stream = options.stream;
  manner.hello.delta = true;
  manner.hello.token = options.token;
  if (options.voice) manner.hello.voice = protocol::kVoiceCodec;
  manner.hello.text = options.captions;
  manner.silence_max = options.silence_max;
  return manner;
}

struct Failure {
  EndReason end;
  std::string_view remedy;  ///< what the user can do about it
};

Failure failure(SessionFailed::Why why) {
  switch (why) {
    case SessionFailed::Why::Lost:
      return {EndReason::ConnectionLost, "; the server's log may say why"};
    case SessionFailed::Why::ProtocolError:
      return {EndReason::ProtocolError, "; is it an au-transmitter?"};
    case SessionFailed::Why::Refused:
      return {EndReason::Refused, ""};
    case SessionFailed::Why::Silent:
      break;
  }
  return {EndReason::Unreachable,
          "; is it an au-transmitter? --connect-timeout sets how long to wait"};
}

}  // namespace

AuReader::AuReader(AuReaderOptions options)
    : options_(std::move(options)),
      manner_(first_manner(options_)),
      session_(manner_),
      retries_({options_.reconnect, options_.one_round, options_.hosts}),
      received_(options_.buffers, options_.speed) {}

void AuReader::begin_session() {
  const Milliseconds from = received_.hello().live ? Milliseconds::zero() : received_.place();
  manner_.hello.from_ms = static_cast<std::uint64_t>(from.count());
  session_ = protocol::ClientSession(manner_);
}

Reaction AuReader::connected(Instant now, Duration round_trip) {
  connected_at_ = now;
  received_.connected(round_trip);
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

/// After a loss.
void AuReader::begin_again(Reaction& reaction, const std::string& reason, Milliseconds wait) {
  received_.break_off();
  lost_.keyframes += session_.keyframes_received();
  lost_.bytes += session_.payload_bytes();
  ledger_.forget();
  manner_.negotiate = !options_.classic;
  begin_session();
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

bool AuReader::may_decode() const {
  return status_.end == EndReason::NotEnded && received_.kept() < kept_max() && ledger_.has_room();
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
  // A classic server has begun: nothing that the hello of an earlier connection said holds. Until a
  // keyframe proves it one, it may be that earlier server, which is just about to come back.
  if (first && retries_.ever_granted() && !negotiated()) received_.begin({});
  retries_.keyframe_came();
  const bool answers_hello = first && manner_.negotiate && !negotiated();  // as a classic one does
  received_.add(event, now_, answers_hello);
  ledger_.owe(now_);
  answer(reaction.send);
}

void AuReader::handle(const protocol::Granted& event, Reaction& reaction) {
  retries_.granted();
  if (manner_.hello.window == 0 && !event.hello.live) {
    // Only a live stream goes without answers; a recorded one would come keyframe by keyframe.
    manner_.hello.window = window_asked(options_);
    connect_anew(reaction);
    return;
  }
  reaction.changed = true;
  status_.negotiated = true;
  received_.begin(event.hello);
  answer(reaction.send);  // the user may have paused already
}

void AuReader::handle(const protocol::DeliverVoice& event, Reaction& reaction) {
  reaction.changed = true;
  received_.add(event.packet);
}

void AuReader::handle(const protocol::DeliverCaption& event, Reaction& reaction) {
  reaction.changed = true;
  received_.add(event.caption);
}

void AuReader::handle(const protocol::StreamEnded& /*event*/, Reaction& reaction) {
  reaction.changed = true;
  reaction.next = Reaction::Next::Close;
  end(EndReason::EndOfStream, "the stream of " + options_.peer + " has ended");
}

void AuReader::handle(const protocol::ReconnectClassic& /*event*/, Reaction& reaction) {
  manner_.negotiate = false;
  connect_anew(reaction);
}

/// Asks for a new connection at once, to talk in another way. Nothing from this one counts.
void AuReader::connect_anew(Reaction& reaction) {
  reaction = {};
  reaction.changed = true;
  reaction.next = Reaction::Next::Reconnect;
  received_.forget_aside();
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
  const auto [reason, remedy] = failure(event.why);
  end(reason, options_.peer + ": " + event.reason + std::string(remedy));
}

void AuReader::answer(std::string& send) {
  if (status_.end == EndReason::NotEnded) send += ledger_.speak(session_, wishes(), now_);
}

AnswerLedger::Wishes AuReader::wishes() const {
  return {received_.paused(), received_.kept() > 0, !received_.hello().voice.empty()};
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
  received_.end();
}

std::optional<playback::Keyframe> AuReader::take() {
  return left() ? std::nullopt : received_.take();
}

std::optional<playback::Voice> AuReader::take_voice() {
  return left() ? std::nullopt : received_.spoken().take_voice();
}

std::optional<playback::Caption> AuReader::take_caption() {
  return left() ? std::nullopt : received_.spoken().take_caption();
}

bool AuReader::ready() const {
  return left() || received_.ready();
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

void AuReader::leave() {
  if (left() || received_.finished()) return;
  status_.connected = false;
  status_.end = EndReason::Stopped;
  status_.detail = "stopped by the user";
}

playback::SourceStatus AuReader::status() const {
  playback::SourceStatus status = status_;
  received_.describe(status);
  status.paused = received_.paused() || session_.paused();
  status.keyframes_received = lost_.keyframes + session_.keyframes_received();
  status.bytes_received = lost_.bytes + session_.payload_bytes();
  status.pauses_sent = ledger_.pauses_sent();
  status.resumes_sent = ledger_.resumes_sent();
  return status;
}

}  // namespace aucast::net

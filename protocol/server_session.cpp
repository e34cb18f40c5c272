#include "protocol/server_session.h"

#include <algorithm>
#include <utility>

#include "common/check.h"
#include "common/overloaded.h"
#include "protocol/codec.h"
#include "protocol/decoder.h"
#include "protocol/joining.h"
#include "protocol/limits.h"
#include "protocol/spare_codes.h"
#include "protocol/stream_choice.h"

namespace aucast::protocol {
namespace {

constexpr char kTlsFirstByte = '\x16';  ///< of a client that speaks TLS

using Why = CloseConnection::Why;

ServedStream first_of(const ServerCatalogue& catalogue) {
  return catalogue.streams.empty() ? ServedStream{} : catalogue.streams.front();
}

}  // namespace

std::string_view name(CloseConnection::Why why) {
  switch (why) {
    case Why::Finished:
      return "finished";
    case Why::Stopped:
      return "stopped";
    case Why::SentAway:
      return "sent away";
    case Why::PeerGone:
      return "peer gone";
    case Why::ProtocolError:
      return "protocol error";
    case Why::Refused:
      return "refused";
    case Why::BrokenOff:
      return "broken off";
  }
  return "unknown";
}

struct ServerSession::State {
  enum class Phase : std::uint8_t {
    Grace,           ///< waiting for a first byte
    Hello,           ///< a '{' came first
    AwaitingStream,  ///< the stream comes from another server, which has not described it yet
    Streaming,
    HeldBack,  ///< the refusal, until the deadline
    Closed,
  };

  const ServerCatalogue* catalogue = nullptr;
  Joining joining;
  Delivery delivery;
  std::optional<HelloAsked> asked;  ///< nullopt: classic
  ClientPacketDecoder decoder;
  Phase phase = Phase::Grace;
  std::optional<Instant> deadline;
  bool peer_ended = false;
  ErrorReply held_back;
  char first_byte = '\0';  ///< the very first byte that came
  SpareCodes spare_codes;

  // Of the call that is being worked on.
  Instant now;
  std::size_t due = 0;         ///< packets in flight since before it
  std::size_t early_left = 0;  ///< answers that it may still take to packets that it sent itself
  std::vector<ServerEvent> events;

  State(const ServerCatalogue& from, const Joining& how, Instant at)
      : catalogue(&from),
        joining(how),
        delivery(first_of(from), from.loop),
        spare_codes(at),
        now(at) {}

  void begin_call(Instant at);
  [[nodiscard]] std::vector<ServerEvent> take_events() { return std::exchange(events, {}); }
  [[nodiscard]] std::string& output();
  [[nodiscard]] Level level() const { return asked ? Level::Negotiated : Level::Classic; }
  void send(std::string_view bytes) { output() += bytes; }
  void close(Why why, std::string reason);
  void say_last(std::string_view bytes, Why why, std::string reason);
  void refuse(int code, const std::string& text);
  void carry_out(Joining::Answer answer);
  void take_stream(StreamChoice choice);
  void turn_away(const Joining::Refusal& refusal);
  void await_stream(Milliseconds patience);
  void give_up_stream();
  [[nodiscard]] std::optional<ErrorReply> comes_round() const;
  void read(std::string_view bytes);
  void note_first_byte(std::string_view bytes);
  void handle(const ClientPacket& packet);
  void handle_code(Code code);
  void take_answer();
  [[nodiscard]] bool spend_spare_code();
  void handle_fault(const DecodeError& fault);
  void send_due(bool at_moment = false);
  void settle_peer_end();
};

void ServerSession::State::begin_call(Instant at) {
  now = at;
  early_left = kEarlyAnswersMax - delivery.window().banked();
  due = delivery.window().in_flight();
}

/// What the running call has to send so far.
std::string& ServerSession::State::output() {
  auto* last = events.empty() ? nullptr : std::get_if<SendBytes>(&events.back());
  if (last == nullptr) last = &std::get<SendBytes>(events.emplace_back(SendBytes{}));
  return last->bytes;
}

void ServerSession::State::close(Why why, std::string reason) {
  phase = Phase::Closed;
  deadline.reset();
  events.emplace_back(CloseConnection{why, std::move(reason)});
}

/// Closes after the last bytes.
void ServerSession::State::say_last(std::string_view bytes, Why why, std::string reason) {
  send(bytes);
  close(why, std::move(reason));
}

void ServerSession::State::refuse(int code, const std::string& text) {
  say_last(encode(ErrorReply{code, text}), Why::Refused, std::to_string(code) + ' ' + text);
}

/// Carries out the decision about a client that wants to be let in, or still waits for its stream.
void ServerSession::State::carry_out(Joining::Answer answer) {
  std::visit(Overloaded{[this](StreamChoice& choice) { take_stream(std::move(choice)); },
                        [this](const Joining::Refusal& refusal) { turn_away(refusal); },
                        [this](HandOver& publisher) {
                          phase = Phase::Closed;
                          deadline.reset();
                          events.emplace_back(std::move(publisher));
                        },
                        [this](const StreamList& list) {
                          say_last(encode(list), Why::Finished,
                                   "the list of streams was asked for");
                        }},
             answer);
}

void ServerSession::State::take_stream(StreamChoice choice) {
  delivery.choose(std::move(choice.stream));
  if (choice.state == StreamChoice::State::NotYet) {
    await_stream(choice.patience);
    return;
  }
  if (asked) {
    const ServedStream& stream = delivery.stream();
    const std::uint32_t keyframe_ms =
        stream.upstream() != nullptr ? stream.upstream()->keyframe_ms : catalogue->keyframe_ms;
    HelloGranted granted = delivery.grant(*asked, keyframe_ms);
    granted.servers = servers_told(*catalogue, stream, *asked);
    send(encode(granted));
  }
  phase = Phase::Streaming;
  deadline.reset();
  send_due();
}

void ServerSession::State::turn_away(const Joining::Refusal& refusal) {
  if (refusal.silent) {
    close(Why::Refused, refusal.reply.text);
  } else if (refusal.after > Duration::zero()) {
    held_back = refusal.reply;
    phase = Phase::HeldBack;
    deadline = now + refusal.after;
  } else {
    refuse(refusal.reply.code, refusal.reply.text);
  }
}

void ServerSession::State::await_stream(Milliseconds patience) {
  if (phase == Phase::AwaitingStream) return;
  phase = Phase::AwaitingStream;
  deadline = now + patience;
}

void ServerSession::State::give_up_stream() {
  constexpr const char* kNotYet = "the stream has not come yet; try again later";
  if (asked) {
    refuse(kBusy, kNotYet);
  } else {
    close(Why::Refused, kNotYet);
  }
}

/// The refusal of a relay that this stream has begun to come through.
std::optional<ErrorReply> ServerSession::State::comes_round() const {
  return asked ? relay_refused(*catalogue, delivery.stream(), *asked) : std::nullopt;
}

void ServerSession::State::read(std::string_view bytes) {
  if (!bytes.empty() && first_byte == '\0') first_byte = bytes.front();
  const auto listens = [this] { return phase != Phase::HeldBack && phase != Phase::Closed; };
  while (!bytes.empty() && listens()) {
    note_first_byte(bytes);
    if (const auto packet = decoder.next(bytes)) {
      handle(*packet);
    } else if (decoder.error()) {
      handle_fault(*decoder.error());
    }
  }
}

void ServerSession::State::note_first_byte(std::string_view bytes) {
  if (phase != Phase::Grace || decoder.mid_packet()) return;
  const std::size_t first = bytes.find_first_not_of(" \r\n");
  if (first == std::string_view::npos || bytes[first] != '{') return;
  phase = Phase::Hello;
  deadline = now + kHelloTimeMax;
}

void ServerSession::State::handle(const ClientPacket& packet) {
  if (const auto* code = std::get_if<Code>(&packet)) {
    if (phase == Phase::Grace && *code != Code::Stop) carry_out(joining.classic(now));
    const bool heard =
        phase == Phase::Grace || phase == Phase::Streaming || phase == Phase::AwaitingStream;
    if (heard) handle_code(*code);
    return;
  }
  // After the grace the connection is classic already and stays so.
  if (phase != Phase::Hello) return;
  if (const auto* hello = std::get_if<HelloAsked>(&packet)) {
    asked = *hello;
    carry_out(joining.hello(*hello, now));
  } else {
    carry_out(joining.list(std::get<StreamsAsked>(packet), now));
  }
}

void ServerSession::State::handle_code(Code code) {
  switch (code) {
    case Code::Received:
      take_answer();
      break;
    case Code::Pause:
      if (!spend_spare_code() || delivery.window().paused()) return;
      delivery.pause();
      if (level() == Level::Classic) take_answer();
      break;
    case Code::Resume:
      if (!spend_spare_code()) return;
      delivery.resume();
      break;
    case Code::Stop:
      say_last(encode(End{}), Why::Stopped, "the client sent -4");
      return;
  }
  if (phase == Phase::Streaming) send_due();
}

void ServerSession::State::take_answer() {
  if (!delivery.window().answers()) {  // nothing is to be answered
    static_cast<void>(spend_spare_code());
    return;
  }
  if (due > 0) {
    --due;
  } else if (early_left == 0) {
    close(Why::ProtocolError, "more than " + std::to_string(kEarlyAnswersMax) +
                                  " answers came before the packets they answer");
    return;
  } else {
    --early_left;
  }
  delivery.answer();
}

/// Closes the connection to a peer that floods us with codes that answer nothing.
bool ServerSession::State::spend_spare_code() {
  if (spare_codes.spend(now)) return true;
  close(Why::ProtocolError, "a flood of codes that answer nothing");
  return false;
}

void ServerSession::State::handle_fault(const DecodeError& fault) {
  if (fault.position == 0 && first_byte == kTlsFirstByte) {
    close(Why::ProtocolError, "the client speaks TLS, which this server does not (--tls-cert)");
    return;
  }
  const std::string reason = fault.reason + " (" + std::string(name(fault.fault)) + " at byte " +
                             std::to_string(fault.position) + ")";
  if (phase == Phase::Hello && fault.fault != DecodeFault::TooManyBlanks) {  // those are before it
    refuse(kMalformed, reason);
  } else {
    close(Why::ProtocolError, reason);
  }
}

/// Sends what may be sent now, and {-2} when everything has been answered. `at_moment`: a stream
/// has something new.
void ServerSession::State::send_due(bool at_moment) {
  const std::uint64_t before = delivery.sent().keyframes;
  if (at_moment) {
    delivery.pump_new_moments(output());
  } else {
    delivery.pump(output());
  }
  if (output().empty()) events.pop_back();
  spare_codes.earn(delivery.sent().keyframes - before);
  if (delivery.complete()) say_last(encode(End{}), Why::Finished, "the stream was sent whole");
  if (delivery.broken_off())
    close(Why::BrokenOff, "its server is gone, and no other sends the rest");
}

/// A peer that has shut its side can neither answer nor resume any more.
void ServerSession::State::settle_peer_end() {
  if (!peer_ended) return;
  if (phase == Phase::Hello) close(Why::PeerGone, "the client ended within its hello");
  if (phase == Phase::Grace) carry_out(joining.classic(now));
  if (phase != Phase::Streaming && phase != Phase::AwaitingStream) return;
  // What it waits for is still to come: a live stream's next moment, the rest of what a relay
  // receives, the voice, or room. Whether a banked answer is left for it shows then.
  const AnswerWindow& window = delivery.window();
  if (window.paused()) {
    close(Why::PeerGone, "the client ended while it was paused");
  } else if (window.in_flight() > 0) {
    close(Why::PeerGone, "the client ended before it had answered everything");
  }
}

ServerSession::ServerSession(const ServerCatalogue& catalogue, Duration round_trip, Instant now,
                             Admission admission, TokenCount token_count, Silence silence)
    : state_((AUCAST_CHECK(!catalogue.streams.empty() || catalogue.patience),
              std::make_unique<State>(catalogue,
                                      Joining(catalogue, admission, token_count, silence), now))) {
  const Duration patience = kGraceRoundTrips * std::clamp<Duration>(round_trip, {}, kGraceMax);
  // Where nobody is served without a hello it may take its time.
  const bool token_needed = !catalogue.token.empty() || admission == Admission::Owner;
  const bool hello_needed = silence == Silence::Refused || token_needed;
  state_->deadline = now + (hello_needed ? Duration(kHelloTimeMax)
                                         : std::clamp<Duration>(patience, kGraceMin, kGraceMax));
}

ServerSession::~ServerSession() = default;
ServerSession::ServerSession(ServerSession&&) noexcept = default;
ServerSession& ServerSession::operator=(ServerSession&&) noexcept = default;

std::vector<ServerEvent> ServerSession::on_bytes(std::string_view bytes, Instant now) {
  state_->begin_call(now);
  state_->read(bytes);
  return state_->take_events();
}

std::vector<ServerEvent> ServerSession::on_peer_end(Instant now) {
  state_->begin_call(now);
  state_->peer_ended = true;
  state_->settle_peer_end();
  return state_->take_events();
}

std::vector<ServerEvent> ServerSession::on_lost(Instant now) {
  state_->begin_call(now);
  if (state_->phase != State::Phase::Closed) {
    state_->close(Why::PeerGone, "the connection was lost");
  }
  return state_->take_events();
}

std::vector<ServerEvent> ServerSession::on_time(Instant now) {
  state_->begin_call(now);
  if (!state_->deadline || now < *state_->deadline) return {};
  switch (state_->phase) {
    case State::Phase::Grace:
      state_->carry_out(state_->joining.classic(now));
      break;
    case State::Phase::Hello:
      state_->refuse(kMalformed, "the hello was not complete within " +
                                     std::to_string(kHelloTimeMax.count() / 1000) + " seconds");
      break;
    case State::Phase::AwaitingStream:
      state_->give_up_stream();
      break;
    case State::Phase::HeldBack:
      state_->refuse(state_->held_back.code, state_->held_back.text);
      break;
    case State::Phase::Streaming:
    case State::Phase::Closed:
      break;
  }
  return state_->take_events();
}

std::vector<ServerEvent> ServerSession::on_moment(Instant now) {
  const bool awaits = state_->phase == State::Phase::AwaitingStream;
  const bool grows =
      state_->phase == State::Phase::Streaming && state_->delivery.stream().upstream() != nullptr;
  if (!live() && !awaits && !grows) return {};
  state_->begin_call(now);
  if (awaits) {
    state_->carry_out(state_->joining.stream_of(state_->asked));
  } else if (const auto refusal = state_->comes_round()) {
    state_->refuse(refusal->code, refusal->text);
  } else {
    state_->send_due(true);
  }
  state_->settle_peer_end();
  return state_->take_events();
}

std::vector<ServerEvent> ServerSession::on_voice(Instant now) {
  if (state_->phase != State::Phase::Streaming || !state_->delivery.waits_for_voice()) return {};
  state_->begin_call(now);
  state_->send_due();
  state_->settle_peer_end();
  return state_->take_events();
}

std::vector<ServerEvent> ServerSession::set_blocked(bool blocked, Instant now) {
  if (state_->phase != State::Phase::Streaming || blocked == state_->delivery.window().blocked())
    return {};
  state_->delivery.set_blocked(blocked);
  if (blocked) return {};
  state_->begin_call(now);
  state_->send_due();
  state_->settle_peer_end();
  return state_->take_events();
}

std::vector<ServerEvent> ServerSession::stop(Instant now) {
  state_->begin_call(now);
  if (state_->phase != State::Phase::Closed) {
    state_->say_last(encode(End{}), Why::Stopped, "the server stops");
  }
  return state_->take_events();
}

std::vector<ServerEvent> ServerSession::send_away(Instant now) {
  state_->begin_call(now);
  if (movable()) state_->close(Why::SentAway, "the server stops, and another one goes on");
  return state_->take_events();
}

bool ServerSession::movable() const {
  return state_->asked && (state_->phase == State::Phase::Streaming ||
                           state_->phase == State::Phase::AwaitingStream);
}

std::optional<Instant> ServerSession::deadline() const {
  return state_->deadline;
}

Level ServerSession::level() const {
  return state_->level();
}

bool ServerSession::paused() const {
  return state_->delivery.window().paused();
}

bool ServerSession::awaiting_answer() const {
  return state_->phase == State::Phase::Streaming && state_->delivery.window().in_flight() > 0 &&
         !paused();
}

bool ServerSession::blocked() const {
  return state_->phase == State::Phase::Streaming && state_->delivery.window().blocked();
}

bool ServerSession::live() const {
  return state_->phase == State::Phase::Streaming && state_->delivery.stream().live() != nullptr;
}

std::string_view ServerSession::stream_name() const {
  return state_->delivery.stream().name;
}

const EncodedStream* ServerSession::recorded() const {
  const RecordedStream* const recorded = state_->delivery.stream().recorded();
  return recorded == nullptr ? nullptr : recorded->encoded.get();
}

const SentCounts& ServerSession::sent() const {
  return state_->delivery.sent();
}

}  // namespace aucast::protocol

#include "protocol/server_session.h"

#include <algorithm>
#include <utility>

#include "common/check.h"
#include "protocol/codec.h"
#include "protocol/decoder.h"
#include "protocol/limits.h"
#include "protocol/secret.h"

namespace aucast::protocol {
namespace {

constexpr char kTlsFirstByte = '\x16';  ///< of a client that speaks TLS

using Why = CloseConnection::Why;

}  // namespace

std::string_view name(CloseConnection::Why why) {
  switch (why) {
    case Why::Finished:
      return "finished";
    case Why::Stopped:
      return "stopped";
    case Why::PeerGone:
      return "peer gone";
    case Why::ProtocolError:
      return "protocol error";
    case Why::Refused:
      return "refused";
  }
  return "unknown";
}

struct ServerSession::State {
  enum class Phase : std::uint8_t {
    Grace,  ///< waiting for a first byte
    Hello,  ///< a '{' came first
    Streaming,
    WrongToken,  ///< it was shown; the refusal is held back until the deadline
    Draining,    ///< the last byte is said; reading the peer's last words
    Closed,
  };

  const ServerCatalogue* catalogue = nullptr;
  TokenCount token_count;
  ServedStream stream;
  ClientPacketDecoder decoder;
  Phase phase = Phase::Grace;
  Level level = Level::Classic;
  std::optional<Instant> deadline;
  Instant now;  ///< of the call that is being worked on

  std::size_t window = 1;
  std::size_t next_packet = 0;
  std::size_t in_flight = 0;  ///< sent and not answered
  std::size_t banked = 0;     ///< answers that came while there was nothing to answer
  bool paused = false;
  bool peer_ended = false;
  const char* no_room = nullptr;  ///< why there is none for this client
  bool delta = false;             ///< the changes-only form was granted
  char first_byte = '\0';         ///< that came at all
  std::uint64_t packets_sent = 0;
  std::uint64_t payload_bytes = 0;

  // Live only.
  bool held = false;                         ///< by hold()
  bool full_next = true;                     ///< the next packet must not be changes only
  std::optional<std::uint64_t> last_moment;  ///< the number of the last one sent
  std::uint64_t packets_merged = 0;

  /// Codes that answer nothing and may still come at `spare_codes_at`.
  std::size_t spare_codes = kSpareCodesMax;
  Instant spare_codes_at;

  /// Answers that the running call may still bring to packets which it sent itself.
  std::size_t early_left = 0;
  std::size_t due = 0;  ///< packets in flight since before the running call

  CloseConnection farewell;  ///< what the drain ends with
  std::size_t drained_bytes = 0;
  std::vector<ServerEvent> events;

  void begin_call(Instant at);
  [[nodiscard]] std::vector<ServerEvent> take_events() { return std::exchange(events, {}); }
  void send(std::string_view bytes);
  void close(Why why, std::string reason);
  void say_last(std::string_view bytes, Why why, std::string reason);
  void refuse(int code, const std::string& text);
  void start_streaming();
  void grant(const HelloAsked& asked);
  [[nodiscard]] std::uint64_t begin_at(std::uint64_t from_ms);
  void list_streams();
  void read(std::string_view bytes);
  void note_first_byte(std::string_view bytes);
  void handle(const ClientPacket& packet);
  void handle_code(Code code);
  void take_answer();
  [[nodiscard]] bool spend_spare_code();
  [[nodiscard]] bool permitted(std::string_view token);
  void handle_fault(const DecodeError& fault);
  [[nodiscard]] const PacketList& packets() const;
  [[nodiscard]] std::string_view packet_of(const LiveMoment& moment, bool full) const;
  [[nodiscard]] std::size_t window_for(int asked) const;
  [[nodiscard]] bool at_end() const;
  [[nodiscard]] bool may_send() const;
  void send_keyframe(std::string_view packet);
  void pump();
  void send_recorded();
  void send_latest();
  void send_moment(const LiveMoment& moment);
  void settle_peer_end();
};

void ServerSession::State::begin_call(Instant at) {
  now = at;
  early_left = kEarlyAnswersMax - banked;
  due = in_flight;
}

void ServerSession::State::send(std::string_view bytes) {
  auto* last = events.empty() ? nullptr : std::get_if<SendBytes>(&events.back());
  if (last == nullptr) last = &std::get<SendBytes>(events.emplace_back(SendBytes{}));
  last->bytes += bytes;
}

void ServerSession::State::close(Why why, std::string reason) {
  phase = Phase::Closed;
  deadline.reset();
  events.emplace_back(CloseConnection{why, std::move(reason)});
}

/// The closing of level 1: the last bytes, the end of sending, then the peer's last words.
void ServerSession::State::say_last(std::string_view bytes, Why why, std::string reason) {
  send(bytes);
  events.emplace_back(ShutdownSending{});
  if (peer_ended) {
    close(why, std::move(reason));
    return;
  }
  farewell = {why, std::move(reason)};
  phase = Phase::Draining;
  deadline = now + kDrainTimeMax;
}

void ServerSession::State::refuse(int code, const std::string& text) {
  say_last(encode(ErrorReply{code, text}), Why::Refused, std::to_string(code) + ' ' + text);
}

void ServerSession::State::start_streaming() {
  if (level == Level::Classic && !permitted({})) return;
  if (no_room != nullptr) {
    close(Why::Refused, no_room);
    return;
  }
  phase = Phase::Streaming;
  deadline.reset();
  pump();
}

void ServerSession::State::grant(const HelloAsked& asked) {
  if (asked.version != kProtocolVersion) {
    refuse(505, "version " + std::to_string(asked.version) + " is not spoken here, only " +
                    std::to_string(kProtocolVersion));
    return;
  }
  // Before anything else is told: what is served here is no stranger's business.
  if (!permitted(asked.token)) return;
  if (!asked.stream.empty()) {
    const auto found =
        std::find_if(catalogue->streams.begin(), catalogue->streams.end(),
                     [&](const ServedStream& candidate) { return candidate.name == asked.stream; });
    if (found == catalogue->streams.end()) {
      refuse(404, "there is no stream '" + asked.stream + "' here");
      return;
    }
    stream = *found;
  }
  if (no_room != nullptr) {
    refuse(503, no_room);
    return;
  }
  level = Level::Negotiated;
  window = window_for(asked.window);
  delta =
      asked.delta && (stream.live ? stream.live->has_changes() : !stream.recorded->changes.empty());
  HelloGranted granted;
  granted.window = static_cast<int>(window);
  granted.delta = delta;
  granted.live = stream.live != nullptr;
  granted.stream = stream.name;
  // A stream that starts again has no length.
  if (stream.live) granted.duration_ms = stream.live->duration_ms();
  if (stream.recorded && !catalogue->loop) granted.duration_ms = stream.recorded->duration_ms;
  granted.keyframe_ms = catalogue->keyframe_ms;
  granted.from_ms = begin_at(asked.from_ms);
  send(encode(granted));
  start_streaming();
}

/// Sets out with the first keyframe that ends after `from_ms`, and returns the place where it
/// begins. A live stream has no other place than now.
std::uint64_t ServerSession::State::begin_at(std::uint64_t from_ms) {
  if (from_ms == 0 || stream.live) return 0;
  const auto& times = stream.recorded->times;
  if (catalogue->loop) {
    std::uint64_t whole = 0;
    for (const KeyframeTime time : times) whole += time.count();
    from_ms = whole == 0 ? 0 : from_ms % whole;
  }
  std::uint64_t begin = 0;
  for (next_packet = 0; from_ms > 0 && next_packet < times.size(); ++next_packet) {
    const std::uint64_t time = times[next_packet].count();
    if (begin + time > from_ms) break;
    begin += time;
  }
  return begin;
}

/// Whether the token opens this server; refuses if not, and makes who guesses wait.
bool ServerSession::State::permitted(std::string_view token) {
  if (catalogue->token.empty()) return true;
  if (token.empty()) {
    refuse(401, "a token is needed here (--token-file)");
  } else if (!token_count.may_try(now)) {
    // Whether this one is right must not show.
    refuse(503, "too many wrong tokens from this address");
  } else if (same_secret(token, catalogue->token)) {
    return true;
  } else {
    phase = Phase::WrongToken;
    deadline = now + kWrongTokenTime;
    token_count.add_wrong(now);
  }
  return false;
}

void ServerSession::State::list_streams() {
  StreamList list;
  for (const ServedStream& served : catalogue->streams) list.names.push_back(served.name);
  say_last(encode(list), Why::Finished, "the list of streams was asked for");
}

void ServerSession::State::read(std::string_view bytes) {
  if (!bytes.empty() && first_byte == '\0') first_byte = bytes.front();
  const auto listens = [this] {
    return phase != Phase::WrongToken && phase != Phase::Draining && phase != Phase::Closed;
  };
  while (!bytes.empty() && listens()) {
    note_first_byte(bytes);
    if (const auto packet = decoder.next(bytes)) {
      handle(*packet);
    } else if (decoder.error()) {
      handle_fault(*decoder.error());
    }
  }
  if (phase == Phase::Draining) {
    drained_bytes += bytes.size();
    if (drained_bytes > kDrainBytesMax) close(farewell.why, farewell.reason);
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
    if (phase == Phase::Grace && *code != Code::Stop) start_streaming();
    if (phase == Phase::Grace || phase == Phase::Streaming) handle_code(*code);
    return;
  }
  // After the grace the connection is classic already and stays so.
  if (phase != Phase::Hello) return;
  if (const auto* asked = std::get_if<HelloAsked>(&packet)) {
    grant(*asked);
  } else if (permitted(std::get<StreamsAsked>(packet).token)) {
    list_streams();
  }
}

void ServerSession::State::handle_code(Code code) {
  switch (code) {
    case Code::Received:
      take_answer();
      break;
    case Code::Pause:
      if (!spend_spare_code() || paused) return;
      paused = true;
      if (level == Level::Classic) take_answer();
      break;
    case Code::Resume:
      if (!spend_spare_code()) return;
      full_next = full_next || paused;
      paused = false;
      break;
    case Code::Stop:
      say_last(encode(End{}), Why::Stopped, "the client sent -4");
      return;
  }
  if (phase == Phase::Streaming) pump();
}

void ServerSession::State::take_answer() {
  if (window == 0) {  // nothing is to be answered
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
  if (in_flight > 0) {
    --in_flight;
  } else {
    ++banked;
  }
}

/// Closes on who floods us with what answers nothing.
bool ServerSession::State::spend_spare_code() {
  const auto earned = std::chrono::duration_cast<std::chrono::milliseconds>(now - spare_codes_at) *
                      kSpareCodesPerSecond / 1000;
  if (earned.count() > 0) {
    spare_codes_at = now;
    spare_codes = std::min(spare_codes + static_cast<std::size_t>(earned.count()), kSpareCodesMax);
  }
  if (spare_codes > 0) {
    --spare_codes;
    return true;
  }
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
    refuse(400, reason);
  } else {
    close(Why::ProtocolError, reason);
  }
}

const PacketList& ServerSession::State::packets() const {
  if (level == Level::Classic) return stream.recorded->classic;
  return delta ? stream.recorded->changes : stream.recorded->negotiated;
}

std::string_view ServerSession::State::packet_of(const LiveMoment& moment, bool full) const {
  if (level == Level::Classic) return moment.classic;
  return delta && !full ? moment.changes : moment.full;
}

std::size_t ServerSession::State::window_for(int asked) const {
  const auto most = static_cast<std::size_t>(std::clamp(asked, 0, kWindowMax));
  // A recorded stream has no clock of its own: without answers nothing would pace it.
  if (!stream.live) return std::max<std::size_t>(most, 1);
  // What is under way grows old: no more of it than a bearable delay.
  return std::min(most, stream.live->window_max());
}

bool ServerSession::State::may_send() const {
  return !paused && !held && (window == 0 || in_flight < window);
}

/// Everything that this client is to get has been sent.
bool ServerSession::State::at_end() const {
  if (!stream.live) {
    return packets().empty() || (next_packet == packets().size() && !catalogue->loop);
  }
  if (!stream.live->ended()) return false;
  const LiveMoment* const newest = stream.live->newest();
  return !last_moment || newest == nullptr || *last_moment == newest->number;
}

void ServerSession::State::send_keyframe(std::string_view packet) {
  send(packet);
  ++packets_sent;
  payload_bytes += packet.size();
  spare_codes = std::min(spare_codes + kSpareCodesPerPacket, kSpareCodesMax);
  if (window == 0) return;
  if (banked > 0) {
    --banked;
  } else {
    ++in_flight;
  }
}

/// Sends what may be sent now, and the end when everything has been answered.
void ServerSession::State::pump() {
  if (!stream.live) {
    send_recorded();
  } else if (const LiveMoment* const newest = stream.live->newest()) {
    send_moment(*newest);
  }
  if (!paused && !held && in_flight == 0 && at_end()) {
    say_last(encode(End{}), Why::Finished, "the stream was sent whole");
  }
}

void ServerSession::State::send_recorded() {
  while (may_send() && !at_end()) {
    if (next_packet == packets().size()) next_packet = 0;
    // The first one names the whole face, wherever the stream begins.
    const bool full = delta && packets_sent == 0;
    const PacketList& encoded = full ? stream.recorded->negotiated : packets();
    send_keyframe(encoded[next_packet++]);
  }
}

/// Who keeps up gets each of several moments that began at once.
void ServerSession::State::send_latest() {
  for (const LiveMoment& moment : stream.live->latest()) {
    if (last_moment && moment.number > *last_moment) send_moment(moment);
  }
}

void ServerSession::State::send_moment(const LiveMoment& moment) {
  if (at_end() || !may_send() || last_moment == moment.number) return;
  const std::uint64_t merged = last_moment ? moment.number - *last_moment - 1 : 0;
  const bool full = std::exchange(full_next, false) || merged > 0;
  packets_merged += merged;
  last_moment = moment.number;
  send_keyframe(packet_of(moment, full));
}

/// A peer that has shut its side can neither answer nor resume any more.
void ServerSession::State::settle_peer_end() {
  if (!peer_ended) return;
  switch (phase) {
    case Phase::Grace:
      start_streaming();
      break;
    case Phase::Hello:
      close(Why::PeerGone, "the client ended within its hello");
      break;
    case Phase::Draining:
      close(farewell.why, farewell.reason);
      break;
    default:
      break;
  }
  if (phase != Phase::Streaming) return;
  // Live, the next moment is still to come; whether it can be answered shows then.
  if (stream.live && !paused && in_flight == 0) return;
  close(Why::PeerGone, paused ? "the client ended while it was paused"
                              : "the client ended before it had answered everything");
}

ServerSession::ServerSession(const ServerCatalogue& catalogue, Duration round_trip, Instant now,
                             Admission admission, TokenCount token_count)
    : state_(std::make_unique<State>()) {
  AUCAST_CHECK(!catalogue.streams.empty());
  state_->catalogue = &catalogue;
  state_->token_count = token_count;
  state_->stream = catalogue.streams.front();
  if (admission == Admission::Full) state_->no_room = "the server is full";
  if (admission == Admission::FullAddress) state_->no_room = "too many clients from this address";
  const Duration patience = kGraceRoundTrips * std::clamp<Duration>(round_trip, {}, kGraceMax);
  // Where a token is needed nobody is served without a hello, so it may take its time.
  state_->deadline =
      now + (catalogue.token.empty() ? std::clamp<Duration>(patience, kGraceMin, kGraceMax)
                                     : Duration(kHelloTimeMax));
  state_->spare_codes_at = now;
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
  if (state_->phase == State::Phase::Draining) {
    state_->close(state_->farewell.why, state_->farewell.reason);
  } else if (state_->phase != State::Phase::Closed) {
    state_->close(Why::PeerGone, "the connection was lost");
  }
  return state_->take_events();
}

std::vector<ServerEvent> ServerSession::on_time(Instant now) {
  state_->begin_call(now);
  if (!state_->deadline || now < *state_->deadline) return {};
  switch (state_->phase) {
    case State::Phase::Grace:
      state_->start_streaming();
      break;
    case State::Phase::Hello:
      state_->refuse(400, "the hello was not complete within 5 seconds");
      break;
    case State::Phase::WrongToken:
      state_->refuse(401, "this token does not open this server (--token-file)");
      break;
    case State::Phase::Draining:
      state_->close(state_->farewell.why, state_->farewell.reason);
      break;
    default:
      break;
  }
  return state_->take_events();
}

std::vector<ServerEvent> ServerSession::on_moment(Instant now) {
  if (!live()) return {};
  state_->begin_call(now);
  state_->send_latest();
  state_->pump();
  state_->settle_peer_end();
  return state_->take_events();
}

std::vector<ServerEvent> ServerSession::hold(bool held, Instant now) {
  if (!live() || held == state_->held) return {};
  state_->held = held;
  if (held) return {};
  state_->begin_call(now);
  state_->pump();
  state_->settle_peer_end();
  return state_->take_events();
}

std::vector<ServerEvent> ServerSession::stop(Instant now) {
  state_->begin_call(now);
  if (state_->phase != State::Phase::Draining && state_->phase != State::Phase::Closed) {
    state_->say_last(encode(End{}), Why::Stopped, "the server stops");
  }
  return state_->take_events();
}

std::optional<Instant> ServerSession::deadline() const {
  return state_->deadline;
}

Level ServerSession::level() const {
  return state_->level;
}

bool ServerSession::paused() const {
  return state_->paused;
}

bool ServerSession::awaiting_answer() const {
  return state_->phase == State::Phase::Streaming && state_->in_flight > 0 && !state_->paused;
}

bool ServerSession::live() const {
  return state_->phase == State::Phase::Streaming && state_->stream.live != nullptr;
}

std::string_view ServerSession::stream_name() const {
  return state_->stream.name;
}

const EncodedStream* ServerSession::recorded() const {
  return state_->stream.recorded.get();
}

std::uint64_t ServerSession::packets_sent() const {
  return state_->packets_sent;
}

std::uint64_t ServerSession::payload_bytes() const {
  return state_->payload_bytes;
}

std::uint64_t ServerSession::packets_merged() const {
  return state_->packets_merged;
}

}  // namespace aucast::protocol

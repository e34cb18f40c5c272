#include "protocol/client_session.h"

#include <algorithm>
#include <utility>

#include "protocol/codec.h"
#include "protocol/decoder.h"
#include "protocol/limits.h"

namespace aucast::protocol {

struct ClientSession::State {
  enum class Phase : std::uint8_t {
    Idle,     ///< not connected yet
    Waiting,  ///< nothing complete has come
    Streaming,
    Over,
  };

  ClientSessionOptions options;
  ServerPacketDecoder decoder;
  Phase phase = Phase::Idle;
  Level level = Level::Classic;
  int window = 1;
  bool stopped = false;       ///< -4 was sent
  bool paused = false;        ///< -1 was sent, -3 not yet
  bool pause_wanted = false;  ///< -1 is to be sent as soon as possible
  std::size_t unanswered = 0;
  std::uint64_t keyframes_received = 0;
  std::uint64_t payload_bytes = 0;
  AuFrame running;  ///< the face that a changes-only packet changes
  HelloGranted granted;
  std::optional<Milliseconds> voice_to{};  ///< the end of the last voice packet
  std::optional<Instant> deadline;
  std::vector<ClientEvent> events;

  [[nodiscard]] std::vector<ClientEvent> take_events() { return std::exchange(events, {}); }
  void finish(ClientEvent last);
  void fail(SessionFailed::Why why, std::string reason, std::optional<int> code = std::nullopt);
  void handle(const Keyframe& keyframe);
  void handle(const End&);
  void handle(const HelloGranted& hello);
  void handle(const ErrorReply& error);
  void handle(const StreamList&);
  void handle(const VoiceData& voice);
  void handle(const CaptionData& caption);
  [[nodiscard]] std::optional<std::string> objection(const HelloGranted& hello) const;
  void lose(std::string_view broke);
  [[nodiscard]] bool took_hello_for_garbage() const;
};

/// The last event of the session.
void ClientSession::State::finish(ClientEvent last) {
  phase = Phase::Over;
  deadline.reset();
  events.push_back(std::move(last));
}

void ClientSession::State::fail(SessionFailed::Why why, std::string reason,
                                std::optional<int> code) {
  if (stopped) {
    finish(StreamEnded{});
  } else {
    finish(SessionFailed{why, std::move(reason), code});
  }
}

void ClientSession::State::handle(const Keyframe& keyframe) {
  const bool first = keyframes_received == 0;
  phase = Phase::Streaming;
  deadline.reset();
  ++keyframes_received;
  payload_bytes += decoder.taken_bytes();
  if (keyframe.changes_only && (!granted.delta || first)) {
    fail(SessionFailed::Why::ProtocolError,
         granted.delta ? "the first packet of the server names only changes"
                       : "the server sent changes only, which was not agreed");
    return;
  }
  if (keyframe.changes_only) {
    apply_terms(running, keyframe.terms);
  } else {
    running = frame_from_terms(keyframe.terms);
  }
  if (stopped) return;
  if (level == Level::Classic || window > 0) ++unanswered;
  events.emplace_back(
      DeliverKeyframe{running, keyframe.time_ms, keyframe.place_ms, keyframe.changes_only});
}

void ClientSession::State::handle(const End&) {
  finish(StreamEnded{});
}

std::optional<std::string> ClientSession::State::objection(const HelloGranted& hello) const {
  if (!options.negotiate || phase != Phase::Waiting) {
    return "the server sent a hello where none was due";
  }
  if (hello.version != kProtocolVersion) {
    return "the server answered in version " + std::to_string(hello.version) + ", asked was " +
           std::to_string(kProtocolVersion);
  }
  const int asked = options.hello.window;
  const int least = std::min(asked, 1);
  if (hello.window < least || hello.window > std::max(asked, 1)) {
    return "the server granted a window of " + std::to_string(hello.window) + ", asked was " +
           std::to_string(asked);
  }
  if (hello.from_ms > options.hello.from_ms) {
    return "the server begins at " + std::to_string(hello.from_ms) + " ms, asked was " +
           std::to_string(options.hello.from_ms);
  }
  if (hello.delta && !options.hello.delta) {
    return "the server granted changes only, which was not asked for";
  }
  if (!hello.voice.empty() && hello.voice != options.hello.voice) {
    return "the server granted a voice in " + hello.voice + ", which was not asked for";
  }
  if (hello.text && !options.hello.text) {
    return "the server granted captions, which were not asked for";
  }
  if (hello.loop && !options.hello.loop) {
    return "the server granted one turn of a loop, which was not asked for";
  }
  return std::nullopt;
}

void ClientSession::State::handle(const HelloGranted& hello) {
  if (const auto reason = objection(hello)) {
    fail(SessionFailed::Why::ProtocolError, *reason);
    return;
  }
  phase = Phase::Streaming;
  deadline.reset();
  level = Level::Negotiated;
  window = hello.window;
  granted = hello;
  events.emplace_back(Granted{hello});
  if (std::exchange(pause_wanted, false)) {
    paused = true;
    events.emplace_back(SendBytes{encode(Code::Pause)});
  }
}

void ClientSession::State::handle(const ErrorReply& error) {
  // The decoder lets nothing but printable text through.
  fail(SessionFailed::Why::Refused,
       "the server refused: " + std::to_string(error.code) + ' ' + error.text, error.code);
}

void ClientSession::State::handle(const StreamList&) {
  fail(SessionFailed::Why::ProtocolError,
       "the server sent a list of streams that was not asked for");
}

void ClientSession::State::handle(const VoiceData& voice) {
  if (granted.voice.empty()) {
    fail(SessionFailed::Why::ProtocolError, "the server sent voice, which was not agreed");
  } else if (!voice.place_ms && !voice_to) {
    fail(SessionFailed::Why::ProtocolError, "the server's first voice packet has no place");
  } else if (!stopped) {
    const Milliseconds place = voice.place_ms ? Milliseconds(*voice.place_ms) : *voice_to;
    voice_to = place + opus_duration(voice.opus).value_or(Milliseconds{0});
    events.emplace_back(DeliverVoice{{place, voice.opus}});
  }
}

void ClientSession::State::handle(const CaptionData& caption) {
  if (!granted.text) {
    fail(SessionFailed::Why::ProtocolError, "the server sent captions, which were not agreed");
  } else if (!stopped) {
    events.emplace_back(DeliverCaption{caption});
  }
}

/// A classic server closes on a hello: after its first packet, or with that packet lost in the
/// reset that closing with unread bytes causes.
bool ClientSession::State::took_hello_for_garbage() const {
  return options.negotiate && level == Level::Classic && keyframes_received <= 1;
}

void ClientSession::State::lose(std::string_view broke) {
  if (stopped) {
    finish(StreamEnded{});
  } else if (took_hello_for_garbage()) {
    finish(ReconnectClassic{});
  } else {
    std::string how = decoder.mid_packet()
                          ? "the connection ended within a packet"
                          : "the connection ended before the end of the stream, {-2}";
    if (!broke.empty()) how.append(": ").append(broke);
    fail(SessionFailed::Why::Lost, std::move(how));
  }
}

ClientSession::ClientSession(ClientSessionOptions options) : state_(std::make_unique<State>()) {
  state_->options = std::move(options);
}

ClientSession::~ClientSession() = default;
ClientSession::ClientSession(ClientSession&&) noexcept = default;
ClientSession& ClientSession::operator=(ClientSession&&) noexcept = default;

std::vector<ClientEvent> ClientSession::on_connected(Instant now) {
  if (state_->phase != State::Phase::Idle) return {};
  state_->phase = State::Phase::Waiting;
  state_->deadline = now + state_->options.silence_max;
  if (state_->options.negotiate) {
    state_->events.emplace_back(SendBytes{encode(state_->options.hello)});
  }
  return state_->take_events();
}

std::vector<ClientEvent> ClientSession::on_bytes(std::string_view& bytes) {
  State& state = *state_;
  if (state.phase != State::Phase::Waiting && state.phase != State::Phase::Streaming) {
    bytes = {};
  } else if (const auto packet = state.decoder.next(bytes)) {
    std::visit([&state](const auto& kind) { state.handle(kind); }, *packet);
  } else if (const auto& error = state.decoder.error()) {
    state.fail(SessionFailed::Why::ProtocolError,
               "the server sent what is not the protocol: " + error->reason + " (" +
                   std::string(name(error->fault)) + " at byte " + std::to_string(error->position) +
                   ")");
  }
  return state.take_events();
}

std::vector<ClientEvent> ClientSession::on_closed(std::string_view broke) {
  if (state_->phase == State::Phase::Waiting || state_->phase == State::Phase::Streaming) {
    state_->lose(broke);
  }
  return state_->take_events();
}

std::vector<ClientEvent> ClientSession::on_time(Instant now) {
  if (state_->deadline && now >= *state_->deadline) {
    const auto silence = std::chrono::duration_cast<Milliseconds>(state_->options.silence_max);
    state_->fail(SessionFailed::Why::Silent,
                 "nothing came from the server within " + std::to_string(silence.count()) + " ms");
  }
  return state_->take_events();
}

std::optional<Instant> ClientSession::deadline() const {
  return state_->deadline;
}

std::string ClientSession::answer_received() {
  State& state = *state_;
  if (state.phase != State::Phase::Streaming || state.stopped || state.unanswered == 0) return {};
  --state.unanswered;
  if (state.level == Level::Classic && std::exchange(state.pause_wanted, false)) {
    state.paused = true;
    return encode(Code::Pause);
  }
  return encode(Code::Received);
}

std::string ClientSession::pause() {
  State& state = *state_;
  if (state.phase == State::Phase::Over || state.stopped || state.paused) return {};
  const bool classic = state.level == Level::Classic;
  if (state.phase != State::Phase::Streaming || (classic && state.unanswered == 0)) {
    state.pause_wanted = true;
    return {};
  }
  if (classic) --state.unanswered;
  state.pause_wanted = false;
  state.paused = true;
  return encode(Code::Pause);
}

std::string ClientSession::resume() {
  State& state = *state_;
  state.pause_wanted = false;
  if (state.phase != State::Phase::Streaming || state.stopped || !state.paused) return {};
  state.paused = false;
  return encode(Code::Resume);
}

std::string ClientSession::stop() {
  State& state = *state_;
  const bool connected =
      state.phase == State::Phase::Waiting || state.phase == State::Phase::Streaming;
  if (!connected || std::exchange(state.stopped, true)) return {};
  state.unanswered = 0;
  return encode(Code::Stop);
}

Level ClientSession::level() const {
  return state_->level;
}

int ClientSession::window() const {
  return state_->window;
}

bool ClientSession::paused() const {
  return state_->paused;
}

std::size_t ClientSession::unanswered() const {
  return state_->unanswered;
}

std::uint64_t ClientSession::keyframes_received() const {
  return state_->keyframes_received;
}

std::uint64_t ClientSession::payload_bytes() const {
  return state_->payload_bytes;
}

}  // namespace aucast::protocol

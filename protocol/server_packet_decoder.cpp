#include <array>
#include <deque>
#include <utility>

#include "protocol/decoder.h"
#include "protocol/keyframe_parser.h"
#include "protocol/limits.h"
#include "protocol/word_packet.h"

namespace aucast::protocol {
namespace {

constexpr std::array<std::string_view, 3> kWords = {"hello", "error", "streams"};

struct Arrived {
  ServerPacket packet;
  std::size_t bytes = 0;
};

}  // namespace

struct ServerPacketDecoder::State {
  enum class Place : std::uint8_t {
    Between,
    Opened,   ///< after '{'
    Minus,    ///< after "{-"
    EndRead,  ///< after "{-2"
    Keyframe,
    Word,
  };

  Place place = Place::Between;
  KeyframeParser keyframe{TermSyntax::Wire};
  WordPacket word{kWords};
  std::size_t blanks = 0;        ///< in a row, between packets
  std::size_t packet_bytes = 0;  ///< of the packet begun, its '{' included
  std::uint64_t bytes_seen = 0;  ///< the position of the next byte
  std::deque<Arrived> arrived;
  std::size_t taken_bytes = 0;
  std::optional<DecodeError> error;

  void accept(char byte);
  std::optional<ByteFault> between(char byte);
  std::optional<ByteFault> within(char byte);
  std::optional<ByteFault> open(char byte);
  std::optional<ByteFault> end_mark(char byte);
  std::optional<ByteFault> close();
  std::optional<ByteFault> close_word();
  void deliver(ServerPacket packet);
  template <typename T>
  std::optional<ByteFault> deliver_parsed(std::variant<T, FieldFault> parsed);
  [[nodiscard]] std::size_t packet_bytes_max() const;
};

void ServerPacketDecoder::State::accept(char byte) {
  auto fault = place == Place::Between ? between(byte) : within(byte);
  if (fault) error = DecodeError{fault->fault, bytes_seen - fault->back, std::move(fault->reason)};
  ++bytes_seen;
}

std::optional<ByteFault> ServerPacketDecoder::State::between(char byte) {
  if (byte == '{') {
    place = Place::Opened;
    blanks = 0;
    packet_bytes = 1;
    return std::nullopt;
  }
  if (!is_blank(byte)) return unexpected("'{'", byte);
  if (++blanks > kBlankBytesMax) {
    return ByteFault{DecodeFault::TooManyBlanks,
                     "more than " + std::to_string(kBlankBytesMax) + " blanks between packets"};
  }
  return std::nullopt;
}

std::size_t ServerPacketDecoder::State::packet_bytes_max() const {
  const bool is_hello = place == Place::Word && !word.text().starts_with('s');
  return is_hello ? kHelloBytesMax : kPacketBytesMax;
}

std::optional<ByteFault> ServerPacketDecoder::State::within(char byte) {
  if (++packet_bytes > packet_bytes_max()) {
    return ByteFault{DecodeFault::PacketTooLong,
                     "no closing brace within " + std::to_string(packet_bytes_max()) + " bytes"};
  }
  switch (place) {
    case Place::Opened:
      return open(byte);
    case Place::Minus:
    case Place::EndRead:
      return end_mark(byte);
    case Place::Keyframe:
      return byte == '}' ? close() : keyframe.accept(byte);
    default:
      return byte == '}' ? close_word() : word.accept(byte);
  }
}

std::optional<ByteFault> ServerPacketDecoder::State::open(char byte) {
  if (is_blank(byte)) return std::nullopt;
  if (byte == '-') {
    place = Place::Minus;
    return std::nullopt;
  }
  // A word stands directly after the brace; elsewhere a small letter is just an illegal byte.
  if (packet_bytes == 2 && byte >= 'a' && byte <= 'z') {
    place = Place::Word;
    word = WordPacket(kWords);
    return word.accept(byte);
  }
  place = Place::Keyframe;
  keyframe = KeyframeParser(TermSyntax::Wire);
  return byte == '}' ? close() : keyframe.accept(byte);
}

std::optional<ByteFault> ServerPacketDecoder::State::end_mark(char byte) {
  if (is_digit(byte) && (place == Place::EndRead || byte != '2')) {
    return ByteFault{DecodeFault::UnknownPacket, "of the negative packets only {-2} exists"};
  }
  if (place == Place::Minus) {
    if (byte != '2') return unexpected("'2' of {-2}", byte);
    place = Place::EndRead;
    return std::nullopt;
  }
  if (is_blank(byte)) return std::nullopt;
  if (byte != '}') return unexpected("'}' of {-2}", byte);
  deliver(End{});
  return std::nullopt;
}

std::optional<ByteFault> ServerPacketDecoder::State::close() {
  if (auto fault = keyframe.finish('}')) return fault;
  deliver(keyframe.take());
  return std::nullopt;
}

template <typename T>
std::optional<ByteFault> ServerPacketDecoder::State::deliver_parsed(
    std::variant<T, FieldFault> parsed) {
  if (auto* fault = std::get_if<FieldFault>(&parsed)) {
    return ByteFault{DecodeFault::BadField, std::move(fault->reason),
                     packet_bytes - 1 - fault->position};
  }
  deliver(std::get<T>(std::move(parsed)));
  return std::nullopt;
}

std::optional<ByteFault> ServerPacketDecoder::State::close_word() {
  if (auto fault = word.finish()) return fault;
  switch (word.text().front()) {
    case 'h':
      return deliver_parsed(parse_hello_granted(word.text()));
    case 'e':
      return deliver_parsed(parse_error_reply(word.text()));
    default:
      return deliver_parsed(parse_stream_list(word.text()));
  }
}

void ServerPacketDecoder::State::deliver(ServerPacket packet) {
  arrived.push_back({std::move(packet), packet_bytes});
  place = Place::Between;
}

ServerPacketDecoder::ServerPacketDecoder() : state_(std::make_unique<State>()) {}
ServerPacketDecoder::~ServerPacketDecoder() = default;
ServerPacketDecoder::ServerPacketDecoder(ServerPacketDecoder&&) noexcept = default;
ServerPacketDecoder& ServerPacketDecoder::operator=(ServerPacketDecoder&&) noexcept = default;

void ServerPacketDecoder::feed(std::string_view bytes) {
  for (const char byte : bytes) {
    if (state_->error) return;
    state_->accept(byte);
  }
}

std::optional<ServerPacket> ServerPacketDecoder::next() {
  if (state_->arrived.empty()) return std::nullopt;
  Arrived front = std::move(state_->arrived.front());
  state_->arrived.pop_front();
  state_->taken_bytes = front.bytes;
  return std::move(front.packet);
}

const std::optional<DecodeError>& ServerPacketDecoder::error() const {
  return state_->error;
}

bool ServerPacketDecoder::mid_packet() const {
  return !state_->error && state_->place != State::Place::Between;
}

std::uint64_t ServerPacketDecoder::bytes_seen() const {
  return state_->bytes_seen;
}

std::size_t ServerPacketDecoder::taken_bytes() const {
  return state_->taken_bytes;
}

}  // namespace aucast::protocol

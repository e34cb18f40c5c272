#include <array>
#include <deque>
#include <utility>

#include "common/text.h"
#include "protocol/decoder.h"
#include "protocol/keyframe_parser.h"
#include "protocol/limits.h"
#include "protocol/word_packet.h"

namespace aucast::protocol {
namespace {

constexpr std::array<std::string_view, 2> kWords = {"hello", "streams"};

ByteFault unknown_code(std::string_view bytes) {
  return {DecodeFault::UnknownCode,
          "'" + escaped(bytes) + "' is no control code; those are 1, -1, -3 and -4"};
}

}  // namespace

struct ClientPacketDecoder::State {
  enum class Place : std::uint8_t {
    First,  ///< nothing but blanks so far: a word may come
    Codes,
    Minus,  ///< after '-'
    Word,   ///< after '{'
  };

  Place place = Place::First;
  WordPacket word{kWords};
  std::size_t blanks = 0;        ///< in a row
  std::size_t packet_bytes = 0;  ///< of the word packet begun, its '{' included
  std::uint64_t bytes_seen = 0;  ///< the position of the next byte
  std::deque<ClientPacket> arrived;
  std::optional<DecodeError> error;

  void accept(char byte);
  std::optional<ByteFault> between(char byte);
  std::optional<ByteFault> after_minus(char byte);
  std::optional<ByteFault> within_word(char byte);
  std::optional<ByteFault> close_word();
  template <typename T>
  std::optional<ByteFault> deliver_parsed(std::variant<T, FieldFault> parsed);
  void deliver(ClientPacket packet);
};

void ClientPacketDecoder::State::accept(char byte) {
  std::optional<ByteFault> fault;
  switch (place) {
    case Place::First:
    case Place::Codes:
      fault = between(byte);
      break;
    case Place::Minus:
      fault = after_minus(byte);
      break;
    case Place::Word:
      fault = within_word(byte);
      break;
  }
  if (fault) error = DecodeError{fault->fault, bytes_seen - fault->back, std::move(fault->reason)};
  ++bytes_seen;
}

std::optional<ByteFault> ClientPacketDecoder::State::between(char byte) {
  if (is_blank(byte)) {
    if (++blanks <= kBlankBytesMax) return std::nullopt;
    return ByteFault{DecodeFault::TooManyBlanks, "more than " + std::to_string(kBlankBytesMax) +
                                                     " blanks without a control code"};
  }
  blanks = 0;
  if (byte == '1') {
    deliver(Code::Received);
    return std::nullopt;
  }
  if (byte == '-') {
    place = Place::Minus;
    return std::nullopt;
  }
  if (byte == '{' && place == Place::First) {
    place = Place::Word;
    packet_bytes = 1;
    return std::nullopt;
  }
  return unknown_code(std::string_view(&byte, 1));
}

std::optional<ByteFault> ClientPacketDecoder::State::after_minus(char byte) {
  switch (byte) {
    case '1':
      deliver(Code::Pause);
      return std::nullopt;
    case '3':
      deliver(Code::Resume);
      return std::nullopt;
    case '4':
      deliver(Code::Stop);
      return std::nullopt;
    default:
      return unknown_code(std::string{'-', byte});
  }
}

std::optional<ByteFault> ClientPacketDecoder::State::within_word(char byte) {
  if (++packet_bytes > kHelloBytesMax) {
    return ByteFault{DecodeFault::PacketTooLong,
                     "no closing brace within " + std::to_string(kHelloBytesMax) + " bytes"};
  }
  return byte == '}' ? close_word() : word.accept(byte);
}

template <typename T>
std::optional<ByteFault> ClientPacketDecoder::State::deliver_parsed(
    std::variant<T, FieldFault> parsed) {
  if (auto* fault = std::get_if<FieldFault>(&parsed)) {
    return ByteFault{DecodeFault::BadField, std::move(fault->reason),
                     packet_bytes - 1 - fault->position};
  }
  deliver(std::get<T>(std::move(parsed)));
  return std::nullopt;
}

std::optional<ByteFault> ClientPacketDecoder::State::close_word() {
  if (auto fault = word.finish()) return fault;
  if (word.word() == "hello") return deliver_parsed(parse_hello_asked(word.text()));
  return deliver_parsed(parse_streams_asked(word.text()));
}

void ClientPacketDecoder::State::deliver(ClientPacket packet) {
  arrived.push_back(std::move(packet));
  place = Place::Codes;
}

ClientPacketDecoder::ClientPacketDecoder() : state_(std::make_unique<State>()) {}
ClientPacketDecoder::~ClientPacketDecoder() = default;
ClientPacketDecoder::ClientPacketDecoder(ClientPacketDecoder&&) noexcept = default;
ClientPacketDecoder& ClientPacketDecoder::operator=(ClientPacketDecoder&&) noexcept = default;

void ClientPacketDecoder::feed(std::string_view bytes) {
  for (const char byte : bytes) {
    if (state_->error) return;
    state_->accept(byte);
  }
}

std::optional<ClientPacket> ClientPacketDecoder::next() {
  if (state_->arrived.empty()) return std::nullopt;
  ClientPacket front = std::move(state_->arrived.front());
  state_->arrived.pop_front();
  return front;
}

const std::optional<DecodeError>& ClientPacketDecoder::error() const {
  return state_->error;
}

bool ClientPacketDecoder::mid_packet() const {
  return !state_->error &&
         (state_->place == State::Place::Minus || state_->place == State::Place::Word);
}

std::uint64_t ClientPacketDecoder::bytes_seen() const {
  return state_->bytes_seen;
}

}  // namespace aucast::protocol

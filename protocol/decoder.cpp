#include "protocol/decoder.h"

#include <array>
#include <string>

#include "common/text.h"
#include "protocol/caption.h"
#include "protocol/limits.h"
#include "protocol/voice_packet.h"

namespace aucast::protocol {
namespace {

constexpr std::array<std::string_view, 5> kServerWords = {"hello", "error", "streams", "a", "t"};
constexpr std::array<std::string_view, 2> kClientWords = {"hello", "streams"};

ByteFault unknown_code(std::string_view bytes) {
  return {DecodeFault::UnknownCode,
          "'" + escaped(bytes) + "' is no control code; those are 1, -1, -3 and -4"};
}

}  // namespace

template <typename Packet>
std::optional<Packet> PacketDecoder<Packet>::next(std::string_view& bytes) {
  while (!bytes.empty() && !error_) {
    if (auto fault = accept(bytes.front())) {
      error_ = DecodeError{fault->fault, bytes_seen_ - fault->back, std::move(fault->reason)};
    }
    ++bytes_seen_;
    bytes.remove_prefix(1);
    if (packet_) return std::exchange(packet_, std::nullopt);
  }
  bytes = {};
  return std::nullopt;
}

template <typename Packet>
std::optional<ByteFault> PacketDecoder<Packet>::blank() {
  if (++blanks_ <= kBlankBytesMax) return std::nullopt;
  return ByteFault{DecodeFault::TooManyBlanks,
                   "more than " + std::to_string(kBlankBytesMax) + " blanks in a row"};
}

template <typename Packet>
std::optional<ByteFault> PacketDecoder<Packet>::count(std::size_t max) {
  blanks_ = 0;
  if (++packet_bytes_ <= max) return std::nullopt;
  return ByteFault{DecodeFault::PacketTooLong,
                   "no closing brace within " + std::to_string(max) + " bytes"};
}

template <typename Packet>
void PacketDecoder<Packet>::deliver(Packet packet) {
  packet_ = std::move(packet);
  taken_bytes_ = std::exchange(packet_bytes_, 0);
}

template <typename Packet>
template <typename T>
std::optional<ByteFault> PacketDecoder<Packet>::deliver_parsed(std::variant<T, FieldFault> parsed) {
  if (auto* fault = std::get_if<FieldFault>(&parsed)) {
    return ByteFault{DecodeFault::BadField, std::move(fault->reason),
                     packet_bytes_ - 1 - fault->position};
  }
  deliver(std::get<T>(std::move(parsed)));
  return std::nullopt;
}

template class PacketDecoder<ServerPacket>;
template class PacketDecoder<ClientPacket>;

// === From a server

ServerPacketDecoder::ServerPacketDecoder() : PacketDecoder(WordPacket(kServerWords)) {}

std::optional<ByteFault> ServerPacketDecoder::accept(char byte) {
  if (packet_bytes_ == 0) {
    if (is_blank(byte)) return blank();
    if (byte != '{') return unexpected("'{'", byte);
    inside_ = Inside::Opened;
    return count(1);
  }
  if (auto fault = count(bytes_max())) return fault;
  switch (inside_) {
    case Inside::Opened:
      return open(byte);
    case Inside::Minus:
    case Inside::EndRead:
      return end_mark(byte);
    case Inside::Keyframe:
      return byte == '}' ? close() : keyframe_.accept(byte);
    case Inside::Word:
      break;
  }
  return byte == '}' ? close_word() : word_.accept(byte);
}

std::size_t ServerPacketDecoder::bytes_max() const {
  if (inside_ != Inside::Word) return kPacketBytesMax;
  switch (word_.text().front()) {
    case 's':
      return kPacketBytesMax;
    case 'a':
      return kVoiceBytesMax;
    case 't':
      return kCaptionBytesMax;
    default:
      return kHelloBytesMax;
  }
}

std::optional<ByteFault> ServerPacketDecoder::open(char byte) {
  if (is_blank(byte)) return std::nullopt;
  if (byte == '-') {
    inside_ = Inside::Minus;
    return std::nullopt;
  }
  // A word stands directly after the brace; elsewhere a small letter is just an illegal byte.
  if (packet_bytes_ == 2 && byte >= 'a' && byte <= 'z') {
    inside_ = Inside::Word;
    word_ = WordPacket(kServerWords);
    return word_.accept(byte);
  }
  inside_ = Inside::Keyframe;
  keyframe_ = KeyframeParser(TermSyntax::Wire);
  return byte == '}' ? close() : keyframe_.accept(byte);
}

std::optional<ByteFault> ServerPacketDecoder::end_mark(char byte) {
  if (is_digit(byte) && (inside_ == Inside::EndRead || byte != '2')) {
    return ByteFault{DecodeFault::UnknownPacket, "of the negative packets only {-2} exists"};
  }
  if (inside_ == Inside::Minus) {
    if (byte != '2') return unexpected("'2' of {-2}", byte);
    inside_ = Inside::EndRead;
    return std::nullopt;
  }
  if (is_blank(byte)) return std::nullopt;
  if (byte != '}') return unexpected("'}' of {-2}", byte);
  deliver(End{});
  return std::nullopt;
}

std::optional<ByteFault> ServerPacketDecoder::close() {
  if (auto fault = keyframe_.finish('}')) return fault;
  deliver(keyframe_.take());
  return std::nullopt;
}

std::optional<ByteFault> ServerPacketDecoder::close_word() {
  if (auto fault = word_.finish()) return fault;
  switch (word_.text().front()) {
    case 'h':
      return deliver_parsed(parse_hello_granted(word_.text()));
    case 'e':
      return deliver_parsed(parse_error_reply(word_.text()));
    case 'a':
      return deliver_parsed(parse_voice_data(word_.text()));
    case 't':
      return deliver_parsed(parse_caption(word_.text()));
    default:
      return deliver_parsed(parse_stream_list(word_.text()));
  }
}

// === From a client

ClientPacketDecoder::ClientPacketDecoder() : PacketDecoder(WordPacket(kClientWords)) {}

std::optional<ByteFault> ClientPacketDecoder::accept(char byte) {
  const bool begun = packet_bytes_ > 0;
  if (!begun && is_blank(byte)) return blank();
  if (auto fault = count(kHelloBytesMax)) return fault;
  if (begun && minus_) return after_minus(byte);
  if (begun) return byte == '}' ? close_word() : word_.accept(byte);
  const bool word_allowed = std::exchange(word_allowed_, false);
  minus_ = byte == '-';
  if (byte == '1') {
    deliver(Code::Received);
  } else if (!minus_ && !(byte == '{' && word_allowed)) {
    return unknown_code(std::string_view(&byte, 1));
  }
  return std::nullopt;
}

std::optional<ByteFault> ClientPacketDecoder::after_minus(char byte) {
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

std::optional<ByteFault> ClientPacketDecoder::close_word() {
  if (auto fault = word_.finish()) return fault;
  if (word_.word() == "hello") return deliver_parsed(parse_hello_asked(word_.text()));
  return deliver_parsed(parse_streams_asked(word_.text()));
}

}  // namespace aucast::protocol

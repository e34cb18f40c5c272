#include "protocol/decode_fault.h"

#include "common/text.h"

namespace aucast::protocol {

std::string_view name(DecodeFault fault) {
  switch (fault) {
    case DecodeFault::IllegalByte:
      return "illegal byte";
    case DecodeFault::NumberTooBig:
      return "number too big";
    case DecodeFault::PacketTooLong:
      return "packet too long";
    case DecodeFault::TooManyBlanks:
      return "too many blanks";
    case DecodeFault::UnknownPacket:
      return "unknown packet";
    case DecodeFault::BadField:
      return "bad field";
    case DecodeFault::UnknownCode:
      return "unknown code";
  }
  return "unknown fault";
}

ByteFault unexpected(const std::string& expected, char byte) {
  return {DecodeFault::IllegalByte,
          "expected " + expected + ", found '" + escaped(std::string_view(&byte, 1)) + "'"};
}

}  // namespace aucast::protocol

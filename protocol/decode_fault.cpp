#include "protocol/decoder.h"

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

}  // namespace aucast::protocol

#include "client/playback/keyframe_source.h"

namespace aucast::playback {

std::string_view name(EndReason reason) {
  switch (reason) {
    case EndReason::NotEnded:
      return "not_ended";
    case EndReason::EndOfStream:
      return "end_of_stream";
    case EndReason::Stopped:
      return "stopped";
    case EndReason::ConnectionLost:
      return "connection_lost";
    case EndReason::ProtocolError:
      return "protocol_error";
    case EndReason::Unreachable:
      return "unreachable";
    case EndReason::Refused:
      return "refused";
  }
  return "unknown";
}

}  // namespace aucast::playback

#include "tests/unit/protocol/session_text.h"

#include <utility>

#include "protocol/codec.h"
#include "tests/unit/protocol/packets.h"

namespace aucast::test {

std::string_view name_of(protocol::SessionFailed::Why why) {
  switch (why) {
    case protocol::SessionFailed::Why::Lost:
      return "lost";
    case protocol::SessionFailed::Why::ProtocolError:
      return "protocol error";
    case protocol::SessionFailed::Why::Refused:
      return "refused";
    case protocol::SessionFailed::Why::Silent:
      return "silent";
  }
  return "unknown";
}

using namespace protocol;

namespace {

std::string text_of_event(const SendBytes& send) {
  return "send " + send.bytes;
}
std::string text_of_event(const CloseConnection& close) {
  return "close " + std::string(name(close.why));
}
std::string text_of_event(const HandOver& over) {
  return "hand over " + over.hello.publish;
}
std::string text_of_event(const DeliverKeyframe& keyframe) {
  std::string text = "store {" + format_au_set(keyframe.aus);
  if (keyframe.time_ms) text += ";" + std::to_string(*keyframe.time_ms);
  if (keyframe.place_ms) text += "@" + std::to_string(*keyframe.place_ms);
  return text + "}";
}
std::string text_of_event(const DeliverVoice& voice) {
  return "voice " + std::to_string(voice.packet.place.count());
}
std::string text_of_event(const DeliverCaption& caption) {
  return "caption " + std::to_string(caption.caption.place_ms) + " '" + caption.caption.text + "'";
}
std::string text_of_event(const Granted& granted) {
  return "granted window=" + std::to_string(granted.hello.window);
}
std::string text_of_event(const StreamEnded&) {
  return "ended";
}
std::string text_of_event(const ReconnectClassic&) {
  return "reconnect";
}
std::string text_of_event(const SessionFailed& failed) {
  return "fail " + std::string(name_of(failed.why));
}

template <typename Event>
std::string joined(const std::vector<Event>& events) {
  std::string text;
  for (const Event& event : events) {
    if (!text.empty()) text += " | ";
    text += std::visit([](const auto& kind) { return text_of_event(kind); }, event);
  }
  return text;
}

}  // namespace

std::string text_of(const std::vector<ServerEvent>& events) {
  return joined(events);
}

std::string text_of(const std::vector<ClientEvent>& events) {
  return joined(events);
}

std::vector<ClientEvent> read_all(ClientSession& session, std::string_view bytes) {
  std::vector<ClientEvent> all;
  while (!bytes.empty()) {
    for (ClientEvent& event : session.on_bytes(bytes)) all.push_back(std::move(event));
  }
  return all;
}

std::string reason_of(const std::vector<ServerEvent>& events) {
  for (const ServerEvent& event : events) {
    if (const auto* close = std::get_if<CloseConnection>(&event)) return close->reason;
  }
  return {};
}

std::string reason_of(const std::vector<ClientEvent>& events) {
  for (const ClientEvent& event : events) {
    if (const auto* failed = std::get_if<SessionFailed>(&event)) return failed->reason;
  }
  return {};
}

EncodedStream encoded(std::initializer_list<std::string_view> negotiated,
                      std::initializer_list<std::string_view> classic) {
  EncodedStream stream;
  stream.negotiated = packets(negotiated);
  stream.classic = classic.size() == 0 ? stream.negotiated : packets(classic);
  return stream;
}

EncodedStream encoded(const std::vector<Keyframe>& keyframes, int classic_min) {
  EncodedStream stream = encode_stream(keyframes, 250, classic_min);
  stream.duration_ms.reset();  // so that the hellos of the tests stay short
  return stream;
}

ServedStream served(std::string name, EncodedStream stream) {
  return {std::move(name),
          RecordedStream{std::make_shared<const EncodedStream>(std::move(stream))}};
}

}  // namespace aucast::test

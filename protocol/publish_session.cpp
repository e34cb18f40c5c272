#include "protocol/publish_session.h"

#include <utility>

#include "protocol/codec.h"

namespace aucast::protocol {
namespace {

constexpr const char* kTakesNone =
    "it takes no streams: it runs without --accept-push, or is older than that";

}  // namespace

std::string PublishSession::hello() const {
  HelloAsked hello;
  hello.token = asked_.token;
  hello.relay = asked_.id;
  hello.publish = asked_.stream;
  return encode(hello);
}

/// A server that takes the stream answers as a client would. Any other answer is read as a
/// server's.
PublishSession::Answer PublishSession::on_bytes(std::string_view bytes) {
  if (as_client_.error()) return read_as_server(bytes);
  read_ += bytes;
  std::string_view rest = bytes;
  const auto packet = as_client_.next(rest);
  if (as_client_.error()) return read_as_server(read_);
  if (!packet) return std::monostate{};
  const auto* hello = std::get_if<HelloAsked>(&*packet);
  // A server that never heard of publishers grants what was not asked for.
  if (hello == nullptr || !hello->takes) return Failed{kTakesNone};
  return Taken{std::move(read_)};
}

PublishSession::Answer PublishSession::read_as_server(std::string_view bytes) {
  const auto packet = as_server_.next(bytes);
  if (packet) {
    if (const auto* error = std::get_if<ErrorReply>(&*packet)) {
      return Failed{"the server refused: " + std::to_string(error->code) + ' ' + error->text};
    }
    return Failed{std::holds_alternative<Keyframe>(*packet)
                      ? "it speaks classic only, and takes no streams"
                      : kTakesNone};
  }
  if (const auto& error = as_server_.error()) {
    return Failed{"the server sent what is not the protocol: " + error->reason};
  }
  return std::monostate{};
}

std::string PublishSession::closed_reason() {
  return "it closed before it answered; is it an au-transmitter with --accept-push?";
}

}  // namespace aucast::protocol

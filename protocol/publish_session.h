#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "common/time.h"
#include "protocol/decoder.h"
#include "protocol/packet.h"

namespace aucast::protocol {

/// The publisher's side of a new connection: it offers a stream to a server, and reads the answer.
/// If the server takes the stream, the roles change: its answer is a client's hello, to be read by
/// a ServerSession on this side. No socket and no clock. Thread: none of its own.
class PublishSession {
 public:
  struct Asked {
    std::string stream;  ///< the name under which it is offered
    std::string token;   ///< empty: none
    std::string id;      ///< to tell this publisher from others
  };
  /// The stream is taken. `bytes` is everything that has come, for a ServerSession.
  struct Taken {
    std::string bytes;
  };
  /// The stream is not taken. `reason` is a sentence; text from the peer is escaped.
  struct Failed {
    std::string reason;
  };
  /// monostate: the answer is not complete yet.
  using Answer = std::variant<std::monostate, Taken, Failed>;

  explicit PublishSession(Asked asked) : asked_(std::move(asked)) {}

  /// The bytes to send first.
  [[nodiscard]] std::string hello() const;
  /// Reads bytes from the server. Do not call it after an answer.
  [[nodiscard]] Answer on_bytes(std::string_view bytes);
  /// What to report when the server closes before it has answered.
  [[nodiscard]] static std::string closed_reason();

 private:
  [[nodiscard]] Answer read_as_server(std::string_view bytes);

  Asked asked_;
  std::string read_;
  ClientPacketDecoder as_client_;
  ServerPacketDecoder as_server_;
};

}  // namespace aucast::protocol

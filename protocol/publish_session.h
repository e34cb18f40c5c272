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
/// If the stream is taken, the roles turn: the server's answer is a client's hello, for a
/// ServerSession. No socket and no clock. Thread: none of its own.
class PublishSession {
 public:
  struct Asked {
    std::string stream;  ///< under which name
    std::string token;   ///< empty: none
    std::string id;      ///< of this server, to tell it from other publishers
  };
  /// The stream is taken. Holds the bytes that have come, for a ServerSession.
  struct Taken {
    std::string bytes;
  };
  /// The stream is not taken; a sentence, peer text escaped.
  struct Failed {
    std::string reason;
  };
  /// nullopt: the answer is not complete yet.
  using Answer = std::variant<std::monostate, Taken, Failed>;

  explicit PublishSession(Asked asked) : asked_(std::move(asked)) {}

  /// The bytes to send first.
  [[nodiscard]] std::string hello() const;
  /// Reads what has come. Not to be called after an answer.
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

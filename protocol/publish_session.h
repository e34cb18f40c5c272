#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "common/time.h"
#include "protocol/decoder.h"
#include "protocol/packet.h"

namespace aucast::protocol {

/// The first words of who brings a stream to a server: says so, and reads the answer. When it is
/// taken the roles turn: the server's answer is a client's hello, for a ServerSession. No socket
/// and no clock. Thread: none of its own.
class PublishSession {
 public:
  struct Asked {
    std::string stream;  ///< under which name
    std::string token;   ///< empty: none
    std::string id;      ///< of this server, to tell it from other publishers
  };
  /// It is taken: the bytes that have come, for a ServerSession.
  struct Taken {
    std::string bytes;
  };
  /// It is not; a sentence, peer text escaped.
  struct Failed {
    std::string reason;
  };
  /// Nothing: more is to come.
  using Answer = std::variant<std::monostate, Taken, Failed>;

  explicit PublishSession(Asked asked) : asked_(std::move(asked)) {}

  /// What is said at the beginning.
  [[nodiscard]] std::string hello() const;
  /// What has come. Not after an answer.
  [[nodiscard]] Answer on_bytes(std::string_view bytes);
  /// How it is to be said that the server has closed before it answered.
  [[nodiscard]] static std::string closed_reason();

 private:
  [[nodiscard]] Answer read_as_server(std::string_view bytes);

  Asked asked_;
  std::string read_;
  ClientPacketDecoder as_client_;
  ServerPacketDecoder as_server_;
};

}  // namespace aucast::protocol

#pragma once

#include <cstdint>
#include <string>
#include <variant>

#include "protocol/packet.h"

namespace aucast::protocol {

// What a session has its owner do: instructions to whoever has the connection, to be carried out in
// the order returned. Those that only a client has are in client_session.h.

struct SendBytes {
  std::string bytes;
};

/// Nothing more is to be sent: close the connection as PROTOCOL.md, section 8, says. Its owner
/// drains it (link::Link::finish()); what the peer still sends does not concern the session.
struct CloseConnection {
  enum class Why : std::uint8_t {
    Finished,       ///< everything was sent
    Stopped,        ///< the client's -4, or stop() of the server
    SentAway,       ///< send_away() of the server: the stream goes on elsewhere
    PeerGone,       ///< the peer closed or was lost before the end
    ProtocolError,  ///< the peer broke the protocol; `reason` says how, escaped
    Refused,        ///< the client is not served; `reason` says why. It was sent an {error ...},
                    ///< or nothing if it is a classic client
    BrokenOff,      ///< the stream came from another server, which is lost: the rest cannot be sent
  };
  Why why = Why::Finished;
  std::string reason;
};

/// The client offers a stream, and is allowed to. From now on the connection belongs to a
/// ClientSession, whose hello has `takes`.
struct HandOver {
  HelloAsked hello;
};

using ServerEvent = std::variant<SendBytes, CloseConnection, HandOver>;

}  // namespace aucast::protocol

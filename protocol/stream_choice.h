#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "common/time.h"
#include "protocol/limits.h"
#include "protocol/packet.h"
#include "protocol/server_session.h"

namespace aucast::protocol {

/// What a server has for a hello.
struct StreamChoice {
  enum class State : std::uint8_t {
    Ready,
    NotYet,   ///< it comes from another server, which has not said enough of it; ask again
    Refused,  ///< by `refusal`
  };
  State state = State::Ready;
  ServedStream stream;  ///< with what is known of it now
  ErrorReply refusal{};
  Milliseconds patience{kStreamWaitMax};  ///< NotYet: how long it is worth waiting
};

/// Finds the stream that is asked for; `asked` is nothing for a classic client, which gets the
/// first. A relay that would get its own stream back, or would be one too many, is refused.
[[nodiscard]] StreamChoice choose_stream(const ServerCatalogue& catalogue,
                                         const std::optional<HelloAsked>& asked);

/// What the hello says in `origin`; empty: nothing.
[[nodiscard]] std::string servers_told(const ServerCatalogue& catalogue, const ServedStream& stream,
                                       const HelloAsked& asked);

}  // namespace aucast::protocol

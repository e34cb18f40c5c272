#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "common/time.h"
#include "protocol/limits.h"
#include "protocol/packet.h"
#include "protocol/server_session.h"

namespace aucast::protocol {

/// The stream that a client gets.
struct StreamChoice {
  enum class State : std::uint8_t {
    Ready,
    NotYet,   ///< it comes from another server, which has not described it yet; ask again
    Refused,  ///< `refusal` says why
  };
  State state = State::Ready;
  ServedStream stream;  ///< as far as it is known now
  ErrorReply refusal{};
  Milliseconds patience{kStreamWaitMax};  ///< NotYet: how long it is worth waiting
};

/// Finds the stream that is asked for; `asked` is nullopt for a classic client, which gets the
/// first. Refuses a relay if relay_refused() says so.
[[nodiscard]] StreamChoice choose_stream(const ServerCatalogue& catalogue,
                                         const std::optional<HelloAsked>& asked);

/// The refusal if a relay would get its own stream back, or if the stream would come through more
/// than kRelayHopsMax relays; nullopt if neither is so, or if `asked` is not a relay's hello. The
/// answer may change when the stream comes another way.
[[nodiscard]] std::optional<ErrorReply> relay_refused(const ServerCatalogue& catalogue,
                                                      const ServedStream& stream,
                                                      const HelloAsked& asked);

/// The value of `origin` in the server's hello; empty: leave it out.
[[nodiscard]] std::string servers_told(const ServerCatalogue& catalogue, const ServedStream& stream,
                                       const HelloAsked& asked);

}  // namespace aucast::protocol

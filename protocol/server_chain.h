#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace aucast::protocol {

// A chain: the IDs of the servers through which a stream comes, as `ID,ID,...`, first the server
// that makes the stream, then each relay. It shows whether a relay would get its own stream back.

/// Whether the text is 1 to kRelayHopsMax IDs.
[[nodiscard]] bool is_server_chain(std::string_view text);
/// Whether the text can be an ID, which has the form of a stream's name and at most
/// kServerIdBytesMax bytes.
[[nodiscard]] bool is_server_id(std::string_view text);

/// How many servers a chain names; 0 for an empty text.
[[nodiscard]] std::size_t servers_in(std::string_view chain);
[[nodiscard]] bool passes_through(std::string_view chain, std::string_view id);
/// The chain with one more server at its end.
[[nodiscard]] std::string chained(std::string chain, std::string_view id);

}  // namespace aucast::protocol

#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace aucast::protocol {

// The servers that a stream comes through, by their IDs: `ID,ID,...`, the one that makes it first,
// then each relay. By it a relay is found that would get its own stream back.

/// 1 to kRelayHopsMax IDs, each a stream's name of at most kServerIdBytesMax bytes.
[[nodiscard]] bool is_server_chain(std::string_view text);
[[nodiscard]] bool is_server_id(std::string_view text);

/// How many servers a chain names; an empty text: none.
[[nodiscard]] std::size_t servers_in(std::string_view chain);
[[nodiscard]] bool passes_through(std::string_view chain, std::string_view id);
/// The chain with one more server at its end.
[[nodiscard]] std::string chained(std::string chain, std::string_view id);

}  // namespace aucast::protocol

#pragma once

#include <string>
#include <string_view>

namespace aucast::test {

/// Plays a transcript (protocol/transcripts/README.md describes the format) against a
/// ServerSession, where the transcript's client is the peer. Returns what went otherwise than
/// written, with the line, or nothing when all went as written.
[[nodiscard]] std::string replay_on_server(std::string_view transcript);

/// The same against a ClientSession, where the transcript's server is the peer and the codes that
/// the client sends are what its owner says.
[[nodiscard]] std::string replay_on_client(std::string_view transcript);

/// The same for one in which the roles turn: up to there against a ServerSession that is brought a
/// stream and against a PublishSession, from there on against the ServerSession of the publisher
/// and the ClientSession of who takes the stream.
[[nodiscard]] std::string replay_on_publisher(std::string_view transcript);

/// True when the transcript is meant for that side.
[[nodiscard]] bool is_for(std::string_view transcript, std::string_view side);

/// Bytes written with \n, \r, \t, \\, \xNN and \*N[text] (text N times).
[[nodiscard]] std::string unescaped(std::string_view text);

}  // namespace aucast::test

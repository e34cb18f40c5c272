#pragma once

#include <string>
#include <string_view>

namespace aucast::test {

/// Plays a transcript (protocol/transcripts/README.md describes the format) against a
/// ServerSession, where the transcript's client is the peer. Returns what differed from the
/// transcript, with the line; empty: nothing did.
[[nodiscard]] std::string replay_on_server(std::string_view transcript);

/// The same against a ClientSession, where the transcript's server is the peer. The owner of
/// the session makes it send the codes that the transcript's client sends.
[[nodiscard]] std::string replay_on_client(std::string_view transcript);

/// The same for a transcript in which the roles turn. Up to the turn it is played against a
/// ServerSession, to which a stream is brought, and a PublishSession; from the turn on, against the
/// ServerSession of the publisher and the ClientSession of whoever takes the stream.
[[nodiscard]] std::string replay_on_publisher(std::string_view transcript);

/// True when the transcript is meant for that side.
[[nodiscard]] bool is_for(std::string_view transcript, std::string_view side);

/// Bytes written with \n, \r, \t, \\, \xNN and \*N[text] (text N times).
[[nodiscard]] std::string unescaped(std::string_view text);

}  // namespace aucast::test

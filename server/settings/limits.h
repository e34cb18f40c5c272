#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>

#include "common/link_limits.h"

/// The limits of au-transmitter alone; the limits for every peer of the protocol are in
/// protocol/limits.h. Of the limits here, PROTOCOL.md lists the ones that a peer may meet.
namespace aucast::server {

/// About what fits into one network packet. When this many bytes wait, --batch sends them at once.
inline constexpr std::size_t kBatchBytesMax = 1200;
/// How many connections are accepted before the clients have their turn. With one at a time, each
/// would have to wait for a round of the event loop, which is long while thousands are sent
/// something.
inline constexpr int kAcceptsInARow = 16;
/// The pause when no descriptor is left: long enough to leave the processor to the clients, short
/// enough for new ones not to notice.
inline constexpr std::chrono::milliseconds kAcceptPause{200};
inline constexpr link::AcceptLimits kAcceptLimits{kAcceptsInARow, kAcceptPause};
/// How many clients at a time are told that there is no room; the others' connections are just
/// closed.
inline constexpr std::size_t kRefusalsMax = 64;
/// If --max-clients is 0, how many descriptors are kept from clients, for refusals and everything
/// else.
inline constexpr std::size_t kDescriptorsKept = 128;
/// The most bytes of a recorded stream that a relay keeps.
inline constexpr std::size_t kRelayedBytesMax = std::size_t{1} << 30U;
/// The most keyframes, voice packets and captions of a live stream in a second; a relay leaves a
/// sender that sends more.
inline constexpr std::uint32_t kRelayedPerSecondMax = 2000;
/// Longest time to dial a host (name, connection and TLS together), so that a dead one does not
/// delay the next for long.
inline constexpr std::chrono::milliseconds kDialTimeMax{5000};
/// The waits when all hosts have failed: the first, which then doubles each time, and the longest.
inline constexpr std::chrono::milliseconds kRedialWaitFirst{1000};
inline constexpr std::chrono::milliseconds kRedialWaitMax{5000};
inline constexpr std::chrono::milliseconds kNextHostWaitMax{100};  ///< before another host is tried
/// How long a publisher waits for the answer of the server.
inline constexpr std::chrono::milliseconds kPublishAnswerTimeMax{10'000};
/// A recorded stream that was sent whole is offered again after this time.
inline constexpr std::chrono::milliseconds kOfferAgain{30'000};
inline constexpr std::size_t kPushedStreamsMax = 64;          ///< from publishers, at a time
inline constexpr std::size_t kClientLogLinesPerSecond = 300;  ///< lines about single clients
inline constexpr std::size_t kHttpConnectionsMax = 32;        ///< at a time; more are closed
inline constexpr std::size_t kHttpHeadBytesMax = 4096;  ///< our monitoring needs about a hundred
inline constexpr std::chrono::milliseconds kHttpTimeMax{5000};
inline constexpr std::size_t kWebConnectionsMax = 256;  ///< not counting WebSockets, at a time
/// More than kHttpHeadBytesMax, since browsers also send other sites' cookies.
inline constexpr std::size_t kWebHeadBytesMax = 8192;
/// Longest time in which a client takes no bytes of the file that it asked for.
inline constexpr std::chrono::milliseconds kWebStallTimeMax{20'000};

}  // namespace aucast::server

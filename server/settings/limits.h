#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>

#include "common/link_limits.h"

/// The limits of au-transmitter alone; those of every peer of the protocol are in
/// protocol/limits.h. PROTOCOL.md lists these too, for peers that meet them.
namespace aucast::server {

/// What fits in one packet of the network; more does not wait for --batch.
inline constexpr std::size_t kBatchBytesMax = 1200;
/// Connections taken before the clients have their turn: one at a time would take a loop of
/// events each, which is long while thousands are sent something.
inline constexpr int kAcceptsInARow = 16;
/// With no descriptor left: long enough to leave the processor to the clients, short enough not to
/// be felt by new ones.
inline constexpr std::chrono::milliseconds kAcceptPause{200};
inline constexpr link::AcceptLimits kAcceptLimits{kAcceptsInARow, kAcceptPause};
/// Clients that are told that there is no room for them, at a time; what is more is just closed.
inline constexpr std::size_t kRefusalsMax = 64;
/// Descriptors that are left for those and for all that is no client, where --max-clients is 0.
inline constexpr std::size_t kDescriptorsKept = 128;
/// Of a recorded stream that a relay holds.
inline constexpr std::size_t kRelayedBytesMax = std::size_t{1} << 30U;
/// Keyframes, voice packets and captions of a live stream within a second, beyond which its sender
/// floods a relay.
inline constexpr std::uint32_t kRelayedPerSecondMax = 2000;
/// For a host's name, connection and TLS: the next one shall not wait long for one that is dead.
inline constexpr std::chrono::milliseconds kDialTimeMax{5000};
/// When all hosts have failed: the first wait, and the longest, of those that double.
inline constexpr std::chrono::milliseconds kRedialWaitFirst{1000};
inline constexpr std::chrono::milliseconds kRedialWaitMax{5000};
inline constexpr std::chrono::milliseconds kNextHostWaitMax{100};  ///< before another one is tried
inline constexpr std::chrono::milliseconds kPublishAnswerTimeMax{10'000};  ///< wait of a publisher
/// Time until a recorded stream that was sent whole is offered again.
inline constexpr std::chrono::milliseconds kOfferAgain{30'000};
inline constexpr std::size_t kPushedStreamsMax = 64;          ///< brought by publishers, at a time
inline constexpr std::size_t kClientLogLinesPerSecond = 300;  ///< about single clients
inline constexpr std::size_t kHttpConnectionsMax = 32;        ///< at a time; more are closed
inline constexpr std::size_t kHttpHeadBytesMax = 4096;        ///< ours need a hundred
inline constexpr std::chrono::milliseconds kHttpTimeMax{5000};
inline constexpr std::size_t kWebConnectionsMax = 256;  ///< that are no WebSocket, at a time
inline constexpr std::size_t kWebHeadBytesMax = 8192;   ///< browsers send cookies of others, too
/// Longest time in which a client takes nothing of the file that it asked for.
inline constexpr std::chrono::milliseconds kWebStallTimeMax{20'000};

}  // namespace aucast::server

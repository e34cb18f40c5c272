#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>

/// The limits for a peer of the protocol: on sizes, numbers and times. PROTOCOL.md has the same
/// tables. Limits on what waits between our own threads are in the classes concerned.
namespace aucast::protocol {

inline constexpr int kProtocolVersion = 2;
inline constexpr std::uint16_t kDefaultPort = 4650;

/// A keyframe or a list of streams, braces included.
inline constexpr std::size_t kPacketBytesMax = 4096;
/// A hello of either side, a client's {streams} or an error, braces included.
inline constexpr std::size_t kHelloBytesMax = 512;
/// A voice packet or a caption, braces included.
inline constexpr std::size_t kVoiceBytesMax = 2048;
inline constexpr std::size_t kCaptionBytesMax = 1024;
inline constexpr std::size_t kTitleBytesMax = 120;  ///< of a stream's title in UTF-8
/// How far voice runs ahead of the last answered keyframe's end, and beyond the last keyframe's.
inline constexpr std::chrono::milliseconds kVoiceAheadMax{2000};
inline constexpr std::size_t kBlankBytesMax = 1024;  ///< blanks in a row, between packets or codes
inline constexpr std::size_t kEarlyAnswersMax = 4096;  ///< answers that come before their keyframes
/// Spare codes (-1 and -3; also 1 if the window is 0) cost one credit each. A connection begins
/// with this many credits, which is also the most that it can have, ...
inline constexpr std::size_t kSpareCodesMax = 4096;
inline constexpr std::size_t kSpareCodesPerSecond = 100;  ///< ... gains these every second ...
inline constexpr std::size_t kSpareCodesPerPacket = 2;  ///< ... and these with every keyframe sent
inline constexpr std::size_t kStreamLineBytesMax = 65536;  ///< a line of a stream file
inline constexpr std::size_t kStreamNameBytesMax = 64;
inline constexpr std::size_t kTokenBytesMax = 256;
inline constexpr std::size_t kServerIdBytesMax = 16;  ///< an ID in `relay=` and `origin=`
inline constexpr std::size_t kRelayHopsMax = 8;  ///< relays between the first server and a client
inline constexpr int kWindowMax = 256;           ///< the largest window that is granted
inline constexpr std::int64_t kKeyframeTimeMsMax = 3'600'000;   ///< of one keyframe: an hour
inline constexpr std::int64_t kPlaceMsMax = 1'000'000'000'000;  ///< about 31 years
/// The most digits of a place, and of a number of a hello or a list: as kPlaceMsMax has.
inline constexpr std::size_t kNumberDigitsMax = 13;

inline constexpr std::chrono::milliseconds kDefaultKeyframeTime{250};
inline constexpr std::chrono::milliseconds kGraceMin{100};   ///< shortest wait for code or hello
inline constexpr std::chrono::milliseconds kGraceMax{3000};  ///< longest wait for code or hello
inline constexpr int kGraceRoundTrips = 3;  ///< the wait in round trips, within these limits
inline constexpr std::chrono::milliseconds kHelloTimeMax{5000};  ///< from its '{' to its '}'
/// How long the refusal of a wrong token is held back.
inline constexpr std::chrono::milliseconds kWrongTokenWait{1000};
inline constexpr std::chrono::milliseconds kTlsHandshakeTimeMax{10'000};
/// Draining: the longest time without progress while the last packets are sent, and then the
/// longest wait for the peer to close; and the most bytes that are read from the peer meanwhile.
inline constexpr std::chrono::milliseconds kDrainTimeMax{2000};
inline constexpr std::size_t kDrainBytesMax = 65536;
/// Changes-only form: the longest sum of times from a full keyframe to any changes-only one that
/// builds on it, both included.
inline constexpr std::chrono::milliseconds kFullKeyframeEvery{10'000};
/// Live: keyframe time that may be in flight to one client; limits the client's window.
inline constexpr std::chrono::milliseconds kLiveWindowTime{2000};

// Limits of our programs that are not part of the protocol; other programs may choose their own.

// A peer that vanished without closing is noticed within a minute: if nothing is under way to it,
// by TCP's keep-alive probes; otherwise by bytes that it does not acknowledge.
/// Silence before the first probe.
inline constexpr std::chrono::milliseconds kKeepAliveIdle{30'000};
inline constexpr std::chrono::milliseconds kKeepAliveInterval{10'000};  ///< between two probes
inline constexpr int kKeepAliveProbes = 3;  ///< this many unanswered probes end the connection
/// Longest time that sent bytes may stay unacknowledged.
inline constexpr std::chrono::milliseconds kUnansweredTimeMax{60'000};

/// How many bytes are read from a client in its turn.
inline constexpr std::size_t kReadBytesMax = 1024;
/// While this many bytes or more wait to be sent to a client, nothing is read from it. This is also
/// about how much of a recorded stream is handed out at once.
inline constexpr std::size_t kOutputBytesMax = 65536;
/// The most wrong tokens from one address within kWrongTokensTime; after these the address must
/// wait.
inline constexpr std::size_t kWrongTokensMax = 8;
inline constexpr std::chrono::milliseconds kWrongTokensTime{1000};
/// How many wrong tokens, of all addresses together, are remembered. When more come, the oldest are
/// forgotten: their addresses may guess again a little sooner.
inline constexpr std::size_t kGuessesMax = 65'536;
/// The most captions of a live stream that are kept. Who sends more of them ahead of the face loses
/// the oldest.
inline constexpr std::size_t kLiveCaptionsMax = 64;
/// Longest wait of a client for a stream that a relay does not have yet. The client would give up
/// after 10 s of silence, without knowing why.
inline constexpr std::chrono::milliseconds kStreamWaitMax{8000};
inline constexpr std::size_t kPublisherFileBytesMax = 65536;  ///< the file of --accept-push

inline constexpr std::size_t kWebFrameBytesMax = 65536;  ///< payload of a client's WebSocket frame
/// Silence of a client after which it is sent a Ping: less than the 60 s after which many proxies
/// drop a connection.
inline constexpr std::chrono::milliseconds kWebPingIdle{25'000};
inline constexpr std::chrono::milliseconds kWebPongTimeMax{30'000};

/// Keyframes that a classic server may send ahead of the answers while the user pauses.
inline constexpr std::size_t kOwedAnswersMax = 128;
inline constexpr std::chrono::milliseconds kFarewellTimeMax{1000};  ///< for sending -4

}  // namespace aucast::protocol

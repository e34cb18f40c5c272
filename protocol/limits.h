#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>

/// Every number that bounds the protocol, in one place. PROTOCOL.md carries the same table.
namespace aucast::protocol {

inline constexpr int kProtocolVersion = 2;
inline constexpr std::uint16_t kDefaultPort = 4650;

inline constexpr std::size_t kPacketBytesMax = 4096;   ///< a keyframe, braces included
inline constexpr std::size_t kHelloBytesMax = 512;     ///< a hello or its answer, with braces
inline constexpr std::size_t kBlankBytesMax = 1024;    ///< blanks between two packets
inline constexpr std::size_t kEarlyAnswersMax = 4096;  ///< answers banked before they are due
/// Codes that answer nothing (pauses and resumes, answers where none is due): so many at once, ...
inline constexpr std::size_t kSpareCodesMax = 4096;
inline constexpr std::size_t kSpareCodesPerSecond = 100;   ///< ... so many more every second, ...
inline constexpr std::size_t kSpareCodesPerPacket = 2;     ///< ... and for every packet sent
inline constexpr std::size_t kStreamLineBytesMax = 65536;  ///< a line of a stream file
inline constexpr std::size_t kStreamNameBytesMax = 64;
inline constexpr std::size_t kTokenBytesMax = 256;  ///< what a hello may show
inline constexpr int kWindowMax = 256;
inline constexpr std::int64_t kDurationMsMax = 3'600'000;       ///< time of one keyframe: an hour
inline constexpr std::int64_t kPlaceMsMax = 1'000'000'000'000;  ///< about 31 years

inline constexpr std::chrono::milliseconds kDefaultKeyframeTime{250};
inline constexpr std::chrono::milliseconds kGraceMin{100};   ///< wait for a first byte, at least
inline constexpr std::chrono::milliseconds kGraceMax{3000};  ///< and at most
inline constexpr int kGraceRoundTrips = 3;                   ///< in between: so many round trips
inline constexpr std::chrono::milliseconds kHelloTimeMax{5000};  ///< for a hello begun with {
inline constexpr std::chrono::milliseconds kTlsHandshakeTimeMax{10'000};
inline constexpr std::chrono::milliseconds kDrainTimeMax{2000};  ///< for last words after {-2}
inline constexpr std::size_t kDrainBytesMax = 65536;
/// At least so often a packet of the changes-only form is full.
inline constexpr std::chrono::milliseconds kFullKeyframeEvery{10'000};
/// Live: what may be under way to one client, as its window.
inline constexpr std::chrono::milliseconds kLiveWindowTime{2000};
inline constexpr std::size_t kReportedErrorsMax = 20;  ///< of one stream file

}  // namespace aucast::protocol

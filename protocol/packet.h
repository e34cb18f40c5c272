#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "common/action_unit.h"
#include "protocol/limits.h"

namespace aucast::protocol {

/// The level of the protocol that both sides speak.
enum class Level : std::uint8_t { Classic = 1, Negotiated = 2 };

/// One keyframe as written in a packet or on a line of a stream file.
struct Keyframe {
  std::vector<AuTerm> terms;  ///< in the order written; empty only in the changes-only form
  bool changes_only = false;  ///< {~...}: AUs that are not named stay as they were
  std::optional<std::uint32_t> time_ms;   ///< how long the face takes to reach it
  std::optional<std::uint64_t> place_ms;  ///< when it is reached; only with time_ms
  friend bool operator==(const Keyframe&, const Keyframe&) = default;
};

/// {-2}: end of transmission.
struct End {
  friend bool operator==(const End&, const End&) = default;
};

/// One Opus packet of the voice: {a DATA} begins where the last one ended, {a@PLACE DATA} at that
/// place.
struct VoiceData {
  std::optional<std::uint64_t> place_ms;
  std::string opus;
  friend bool operator==(const VoiceData&, const VoiceData&) = default;
};

/// {t@PLACE DATA}: what is said from this place until the next caption; an empty text: nothing is
/// said.
struct CaptionData {
  std::uint64_t place_ms = 0;
  std::string text;  ///< UTF-8 without control characters other than line feeds
  friend bool operator==(const CaptionData&, const CaptionData&) = default;
};

/// The only codec that `voice=` can name.
inline constexpr std::string_view kVoiceCodec = "opus";

/// The client's {hello ...}. A key that is absent has the value given here; unknown keys are
/// ignored.
struct HelloAsked {
  int version = 2;
  int window = 1;  ///< 0-999999; more than 256 counts as 256; 0: no answers, for live streams only
  std::string stream;  ///< empty: the first one
  std::string token;
  bool delta = false;         ///< understands the changes-only form
  std::uint64_t from_ms = 0;  ///< of a recorded stream: where to begin, as a sum of keyframe times
  std::string voice{};        ///< the codec it plays: kVoiceCodec; empty: it wants no voice
  bool text = false;          ///< it wants captions
  bool loop = false;          ///< wants only one turn of a looped stream, which it repeats itself
  std::string relay{};        ///< its own ID, if it is a relay or a publisher; empty: it is neither
  std::string publish{};      ///< the name of the stream that it offers; empty: it offers none, and
                              ///< asks for one
  bool takes = false;  ///< a server's answer to `publish`: send the stream, as the other keys say
  friend bool operator==(const HelloAsked&, const HelloAsked&) = default;
};

/// The server's {hello ...}.
struct HelloGranted {
  int version = 2;
  int window = 1;      ///< 0-256; 0: without answers
  bool delta = false;  ///< the changes-only form is used
  std::string stream;
  bool live = false;
  std::optional<std::uint64_t> duration_ms;  ///< of the whole stream; nullopt: unknown
  std::uint32_t keyframe_ms =
      kDefaultKeyframeTime.count();  ///< time of a keyframe without one of its own
  std::uint64_t from_ms = 0;         ///< of a recorded stream: where the first keyframe begins
  std::string voice{};               ///< kVoiceCodec: voice packets may come; empty: none will
  bool text = false;                 ///< captions may come
  bool loop = false;                 ///< only one turn of a looped stream is sent
  std::string title{};               ///< of the stream, for people; UTF-8
  std::string servers{};             ///< the stream's chain (server_chain.h); for relays only
  friend bool operator==(const HelloGranted&, const HelloGranted&) = default;
};

/// The codes of section 10 of PROTOCOL.md.
enum RefusalCode : int {
  kMalformed = 400,
  kTokenNeeded = 401,
  kNotAllowed = 403,
  kNoSuchStream = 404,
  kNameTaken = 409,
  kBusy = 503,
  kOtherVersion = 505,
  kRoundAbout = 508,
};

/// {error CODE TEXT}: a RefusalCode, or one that a newer server has, and a sentence.
struct ErrorReply {
  int code = kMalformed;
  std::string text;
  friend bool operator==(const ErrorReply&, const ErrorReply&) = default;
};

/// A stream of a server's list. What the server did not say, or does not know, is left out.
struct ListedStream {
  std::string name;
  std::optional<bool> live{};                  ///< false: a recorded one
  std::optional<std::uint64_t> duration_ms{};  ///< of the whole stream
  std::string title{};                         ///< for people; UTF-8
  friend bool operator==(const ListedStream&, const ListedStream&) = default;
};

/// {streams NAME NAME ...}, or with details {streams stream=NAME live=1 stream=NAME ...}.
struct StreamList {
  std::vector<ListedStream> streams;
  friend bool operator==(const StreamList&, const StreamList&) = default;
};

/// {streams}, sent by a client instead of a hello.
struct StreamsAsked {
  std::string token;
  bool details = false;  ///< the client can read more than names
  friend bool operator==(const StreamsAsked&, const StreamsAsked&) = default;
};

/// The client's control codes; the values are what is written on the wire.
enum class Code : std::int8_t { Received = 1, Pause = -1, Resume = -3, Stop = -4 };

using ServerPacket =
    std::variant<Keyframe, End, HelloGranted, ErrorReply, StreamList, VoiceData, CaptionData>;
using ClientPacket = std::variant<Code, HelloAsked, StreamsAsked>;

}  // namespace aucast::protocol

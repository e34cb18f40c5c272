#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "common/action_unit.h"

namespace aucast::protocol {

/// How much of the protocol both sides speak.
enum class Level : std::uint8_t { Classic = 1, Negotiated = 2 };

/// One keyframe as written in a packet or on a line of a stream file.
struct Keyframe {
  std::vector<AuTerm> terms;                 ///< as written; empty only in the changes-only form
  bool changes_only = false;                 ///< {~...}: what is not named stays as it was
  std::optional<std::uint32_t> duration_ms;  ///< how long the face takes to reach it
  std::optional<std::uint64_t> place_ms;     ///< when it is reached; only with duration_ms
  friend bool operator==(const Keyframe&, const Keyframe&) = default;
};

/// {-2}: end of transmission.
struct End {
  friend bool operator==(const End&, const End&) = default;
};

/// {a DATA}: one Opus packet of the voice, which goes on where the last one ended, or begins at a
/// place: {a@PLACE DATA}.
struct VoiceData {
  std::optional<std::uint64_t> place_ms;
  std::string opus;
  friend bool operator==(const VoiceData&, const VoiceData&) = default;
};

/// {t@PLACE DATA}: what is said from this place until the next caption; empty: nothing.
struct CaptionData {
  std::uint64_t place_ms = 0;
  std::string text;  ///< UTF-8 without control characters other than line feeds
  friend bool operator==(const CaptionData&, const CaptionData&) = default;
};

/// The one codec that `voice=` can name.
inline constexpr std::string_view kVoiceCodec = "opus";

/// The client's {hello ...}. Absent keys keep these values; unknown keys were ignored.
struct HelloAsked {
  int version = 2;
  int window = 1;      ///< 0-999999, above 256 counts as 256; 0: no answers, live only
  std::string stream;  ///< empty: the first one
  std::string token;
  bool delta = false;         ///< understands the changes-only form
  std::uint64_t from_ms = 0;  ///< recorded: where to begin, as a sum of keyframe times
  std::string voice{};        ///< the codec it plays: kVoiceCodec; empty: it wants no voice
  bool text = false;          ///< it wants captions
  bool loop = false;      ///< of a recording in a loop it wants one turn, which it repeats itself
  std::string relay{};    ///< the ID of a relay that asks or of a publisher; empty: it is none
  std::string publish{};  ///< the stream that it brings, in place of asking for one
  bool takes = false;     ///< the answer to that: bring it; the rest says how
  friend bool operator==(const HelloAsked&, const HelloAsked&) = default;
};

/// The server's {hello ...}.
struct HelloGranted {
  int version = 2;
  int window = 1;      ///< 0-256; 0: nothing is answered
  bool delta = false;  ///< the changes-only form is used
  std::string stream;
  bool live = false;
  std::optional<std::uint64_t> duration_ms;  ///< of the whole stream, if known
  std::uint32_t keyframe_ms = 250;           ///< time of a packet without one of its own
  std::uint64_t from_ms = 0;                 ///< recorded: where the first keyframe begins
  std::string voice{};                       ///< kVoiceCodec: there will be voice packets
  bool text = false;                         ///< there will be captions
  bool loop = false;                         ///< this is one turn of a recording in a loop
  std::string title{};                       ///< of the stream, for people; UTF-8
  std::string servers{};  ///< that the stream comes through (server_chain.h); only for relays
  friend bool operator==(const HelloGranted&, const HelloGranted&) = default;
};

/// {error CODE TEXT}: a code of PROTOCOL.md section 10 and a sentence.
struct ErrorReply {
  int code = 400;
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
  bool details = false;  ///< it reads more than names
  friend bool operator==(const StreamsAsked&, const StreamsAsked&) = default;
};

/// The client's control codes; the values are what is written on the wire.
enum class Code : std::int8_t { Received = 1, Pause = -1, Resume = -3, Stop = -4 };

using ServerPacket =
    std::variant<Keyframe, End, HelloGranted, ErrorReply, StreamList, VoiceData, CaptionData>;
using ClientPacket = std::variant<Code, HelloAsked, StreamsAsked>;

}  // namespace aucast::protocol

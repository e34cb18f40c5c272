#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "common/result.h"

namespace aucast::protocol {

// The messages that go through NATS, as ENGINE.md defines them: a line that says what the message
// is, then packets of level 2.

inline constexpr std::uint16_t kEnginePort = 4222;  ///< the default port of NATS
/// The longest message; a longer one is not ours.
inline constexpr std::size_t kEngineBytesMax = 65536;
inline constexpr std::size_t kEngineLineBytesMax = 256;

/// What the origin sends: new packets, or an answer.
struct EngineMessage {
  enum class Kind : std::uint8_t {
    Batch,  ///< new packets, to everybody
    State,  ///< an answer: the hello, and the whole face after batch `seq`
    Since,  ///< an answer: the packets of the batches after `after`, up to `seq`
  };
  Kind kind = Kind::Batch;
  std::string origin;  ///< the origin's ID
  std::uint64_t seq = 0;
  std::uint64_t place_ms = 0;  ///< on the publisher's clock: where the first keyframe begins
  std::uint64_t after = 0;     ///< only for Since: the last batch that the edge has
  std::string packets;         ///< whole packets; may be empty
  friend bool operator==(const EngineMessage&, const EngineMessage&) = default;
};

/// What an edge sends: a request for the state, or for the batches that it missed.
struct EngineJoin {
  std::string origin;                  ///< the ID of the publisher that is to answer; empty: any
  std::optional<std::uint64_t> after;  ///< the last batch that the edge has; nullopt: it has none
  friend bool operator==(const EngineJoin&, const EngineJoin&) = default;
};

/// `origin` must be an ID.
[[nodiscard]] std::string encode(const EngineMessage& message);
[[nodiscard]] std::string encode(const EngineJoin& join);

/// Reads what encode() makes. Fails for anything else, with BadData and a clause that says what is
/// wrong. Of `packets` only the first and the last byte are checked.
[[nodiscard]] Result<EngineMessage> parse_engine_message(std::string_view bytes);
[[nodiscard]] Result<EngineJoin> parse_engine_join(std::string_view bytes);

/// The packets with `by_ms` subtracted from the places of voice and captions, for an edge whose
/// clock began at `by_ms`. Voice that begins before `by_ms`, or has no place, is left out. Captions
/// that begin before `by_ms` get the place 0.
[[nodiscard]] std::string with_places_earlier(std::string_view packets, std::uint64_t by_ms);

/// The first of these packets, with its braces; the whole text if it has no closing brace.
[[nodiscard]] std::string_view first_packet(std::string_view packets);

}  // namespace aucast::protocol

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "common/result.h"

namespace aucast::protocol {

// What goes through NATS, as ENGINE.md has it: a line that says what it is, then packets of
// level 2.

inline constexpr std::uint16_t kEnginePort = 4222;  ///< of NATS
/// Longer messages are not ours.
inline constexpr std::size_t kEngineBytesMax = 65536;
inline constexpr std::size_t kEngineLineBytesMax = 256;

/// What the origin sends: what is new, or an answer.
struct EngineMessage {
  enum class Kind : std::uint8_t {
    Batch,  ///< what is new, to everybody
    State,  ///< an answer: the hello and the whole face as of batch `seq`
    Since,  ///< an answer: what the batches after `after` held, up to `seq`
  };
  Kind kind = Kind::Batch;
  std::string origin;  ///< the origin's ID
  std::uint64_t seq = 0;
  std::uint64_t place_ms = 0;  ///< on the origin's clock: where the first keyframe begins
  std::uint64_t after = 0;     ///< of Since only
  std::string packets;         ///< whole ones; may be empty
  friend bool operator==(const EngineMessage&, const EngineMessage&) = default;
};

/// What a watcher sends: it asks for the state, or for what it missed.
struct EngineJoin {
  std::string origin;                  ///< who is to answer; empty: any
  std::optional<std::uint64_t> after;  ///< the last batch it has; nothing: it has none
  friend bool operator==(const EngineJoin&, const EngineJoin&) = default;
};

[[nodiscard]] std::string encode(const EngineMessage& message);
[[nodiscard]] std::string encode(const EngineJoin& join);

/// BadData, with a clause that says what is wrong, for anything else. Of the packets only the first
/// and the last byte are looked at.
[[nodiscard]] Result<EngineMessage> parse_engine_message(std::string_view bytes);
[[nodiscard]] Result<EngineJoin> parse_engine_join(std::string_view bytes);

/// The packets with the places of voice and captions `by_ms` earlier, for a watcher whose clock
/// began there. Voice from before that, or without a place, is left out; a caption from before is
/// shown from the beginning.
[[nodiscard]] std::string with_places_earlier(std::string_view packets, std::uint64_t by_ms);

/// The first of these packets, with its braces; all of them if there is no brace. For taking them
/// one by one.
[[nodiscard]] std::string_view first_packet(std::string_view packets);

}  // namespace aucast::protocol

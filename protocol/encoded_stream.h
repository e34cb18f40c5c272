#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "common/stopped.h"
#include "common/time.h"
#include "protocol/codec.h"
#include "protocol/packet.h"
#include "protocol/packet_list.h"

namespace aucast::protocol {

/// The time of one keyframe; kDurationMsMax fits, and four bytes are enough.
using KeyframeTime = std::chrono::duration<std::uint32_t, std::milli>;

/// How much of a recorded stream we have.
enum class Extent : std::uint8_t {
  Whole,
  Growing,    ///< a relay is still receiving it: clients that have all of it wait for more
  BrokenOff,  ///< no more will come for now: they are cut off, so that they look elsewhere
};

/// A recorded stream, encoded once in every form it is sent in. Shared by all clients; immutable
/// when it is whole, and until then only appended to.
struct EncodedStream {
  PacketList classic;     ///< one packet per keyframe
  PacketList negotiated;  ///< the same keyframes, level 2
  PacketList changes;     ///< for clients that ask for the changes-only form; empty: not granted
  std::vector<KeyframeTime> times;  ///< of each keyframe, untimed ones with their default
  std::optional<std::uint64_t> duration_ms{};  ///< their sum at the end, if a hello is to say it
  Extent extent = Extent::Whole;
  friend bool operator==(const EncodedStream&, const EncodedStream&) = default;
};

/// The keyframe of which a packet of `negotiated` was made.
[[nodiscard]] Keyframe keyframe_of(std::string_view packet);

/// The sum of the times of all keyframes so far.
[[nodiscard]] Milliseconds length_of(const EncodedStream& stream);

/// Memory that its packets and times take.
[[nodiscard]] std::size_t held_bytes(const EncodedStream& stream);

/// Where a client begins in a stream.
struct Entry {
  std::size_t keyframe = 0;  ///< the index of its first one; the number of all if that is not there
  std::uint64_t begin_ms = 0;
};

/// Where a client that asks for `from_ms` begins: at the first keyframe that ends after it, or lies
/// there and takes no time. `loop`: `from_ms` keeps growing from turn to turn.
[[nodiscard]] Entry entry_at(const EncodedStream& stream, std::uint64_t from_ms, bool loop);

/// Encodes a recorded stream keyframe by keyframe and holds nothing but packets and times. Untimed
/// keyframes last `keyframe_ms`; `classic_min` as in encode_classic(). A stream of plain numbers
/// has no changes-only form: every packet of it stays what the thesis measured.
class StreamEncoder {
 public:
  StreamEncoder(std::uint32_t keyframe_ms, int classic_min)
      : encoder_(keyframe_ms, classic_min), keyframe_ms_(keyframe_ms) {}

  /// The next keyframe, a full one.
  void add(const Keyframe& keyframe);
  [[nodiscard]] std::size_t keyframes() const { return stream_.times.size(); }
  /// Memory that the stream takes so far.
  [[nodiscard]] std::size_t bytes() const { return held_bytes(stream_); }
  /// The stream; nothing may be added after it.
  [[nodiscard]] EncodedStream finish();

 private:
  KeyframeEncoder encoder_;
  std::uint32_t keyframe_ms_;
  EncodedStream stream_;
  std::uint64_t duration_ms_ = 0;
  bool plain_ = true;
};

/// The same for a stream that is held as keyframes. Asked to stop, the result breaks off.
[[nodiscard]] EncodedStream encode_stream(std::span<const Keyframe> keyframes,
                                          std::uint32_t keyframe_ms, int classic_min,
                                          const StopToken& stop = {});

/// How long a classic client takes to play the stream: its packets carry no times, so it gives
/// every keyframe the default time. nullopt when that is the stream's own length, or not known yet.
[[nodiscard]] std::optional<Milliseconds> classic_length(const EncodedStream& stream);

}  // namespace aucast::protocol

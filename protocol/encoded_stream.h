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

/// The time of one keyframe. Four bytes are enough for kKeyframeTimeMsMax.
using KeyframeTime = std::chrono::duration<std::uint32_t, std::milli>;

/// How much of a recorded stream we have.
enum class Extent : std::uint8_t {
  Whole,
  Growing,    ///< a relay still receives it: clients that were sent all so far wait for more
  BrokenOff,  ///< no more comes for now: clients that were sent all so far are cut off, and may
              ///< try another server
};

/// A recorded stream, encoded once in every form it is sent in. Shared by all clients; immutable
/// when it is whole, and until then only appended to.
struct EncodedStream {
  PacketList classic;     ///< one packet per keyframe
  PacketList negotiated;  ///< the same keyframes, level 2
  PacketList changes;     ///< for clients that ask for the changes-only form; empty: there is none
  std::vector<KeyframeTime> times;             ///< of each keyframe; the default for an untimed one
  std::optional<std::uint64_t> duration_ms{};  ///< the final sum of times, if a hello is to tell it
  Extent extent = Extent::Whole;
  friend bool operator==(const EncodedStream&, const EncodedStream&) = default;
};

/// The keyframe from which a packet of `negotiated` was made.
[[nodiscard]] Keyframe keyframe_of(std::string_view packet);

/// The sum of the times of all keyframes so far.
[[nodiscard]] Milliseconds length_of(const EncodedStream& stream);

/// The memory, in bytes, that the stream's packets and times take.
[[nodiscard]] std::size_t held_bytes(const EncodedStream& stream);

/// Where a client begins in a stream.
struct Entry {
  /// The index of the client's first keyframe; if we do not have that yet, how many we have.
  std::size_t keyframe = 0;
  std::uint64_t begin_ms = 0;
};

/// Where a client that asks for `from_ms` begins: at the first keyframe that ends after `from_ms`,
/// or that takes no time and lies at `from_ms`. `loop`: `from_ms` counts on from turn to turn, so
/// it may be beyond the first turn.
[[nodiscard]] Entry entry_at(const EncodedStream& stream, std::uint64_t from_ms, bool loop);

/// Encodes a recorded stream keyframe by keyframe and keeps only packets and times. An untimed
/// keyframe takes `keyframe_ms`; `classic_min` is the `percent_min` of encode_classic(). A stream
/// of plain numbers gets no changes-only form, so that its packets are the ones that the thesis
/// measured.
class StreamEncoder {
 public:
  StreamEncoder(std::uint32_t keyframe_ms, int classic_min)
      : encoder_(keyframe_ms, classic_min), keyframe_ms_(keyframe_ms) {}

  /// Adds the next keyframe, which must not be changes-only.
  void add(const Keyframe& keyframe);
  [[nodiscard]] std::size_t keyframes() const { return stream_.times.size(); }
  /// The memory, in bytes, that the stream takes so far.
  [[nodiscard]] std::size_t bytes() const { return held_bytes(stream_); }
  /// Returns the stream. Nothing may be added afterwards.
  [[nodiscard]] EncodedStream finish();

 private:
  KeyframeEncoder encoder_;
  std::uint32_t keyframe_ms_;
  EncodedStream stream_;
  std::uint64_t duration_ms_ = 0;
  bool plain_ = true;
};

/// Encodes keyframes that are in memory. When asked to stop, returns what it has encoded so far.
[[nodiscard]] EncodedStream encode_stream(std::span<const Keyframe> keyframes,
                                          std::uint32_t keyframe_ms, int classic_min,
                                          const StopToken& stop = {});

/// How long a classic client takes to play the stream. Classic packets carry no times, so the
/// client gives every keyframe the default time. Returns nullopt if that is the stream's own
/// length, or is not known.
[[nodiscard]] std::optional<Milliseconds> classic_length(const EncodedStream& stream);

}  // namespace aucast::protocol

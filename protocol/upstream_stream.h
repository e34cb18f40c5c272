#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <variant>

#include "common/time.h"
#include "protocol/encoded_stream.h"
#include "protocol/encoded_track.h"
#include "protocol/limits.h"
#include "protocol/live_channel.h"

namespace aucast::protocol {

/// A recorded stream in the forms in which it is sent.
struct RecordedStream {
  std::shared_ptr<const EncodedStream> encoded;  ///< never null
  /// The voice and captions, for clients that ask for them. Null: none.
  std::shared_ptr<const SpokenTrack> spoken{};
  /// What these clients are sent if `encoded` does not suit the voice (voiced_stream()). Null: they
  /// are sent `encoded`.
  std::shared_ptr<const EncodedStream> voiced{};

  /// What clients that ask for voice or captions are sent. Never null.
  [[nodiscard]] const std::shared_ptr<const EncodedStream>& for_listeners() const {
    return voiced ? voiced : encoded;
  }

  /// Whether the packets, the voice and the captions are the same.
  friend bool operator==(const RecordedStream& one, const RecordedStream& other) {
    return one.encoded == other.encoded && same_spoken(one.spoken, other.spoken) &&
           one.voiced == other.voiced;
  }
};

/// A stream that another server sends, as far as it is known; at first not even whether it is
/// recorded or live. Shared by all its sessions. Its receiver writes it; what has become known does
/// not change, but a recorded stream grows.
/// Thread: that of the sessions.
struct UpstreamStream {
  std::string name;  ///< empty: not known yet
  /// monostate: it is not known yet.
  std::variant<std::monostate, RecordedStream, std::shared_ptr<const LiveChannel>> content;
  bool loop = false;  ///< if recorded: it starts again at its end
  std::string title;  ///< to show to people; empty: none
  std::uint32_t keyframe_ms = kDefaultKeyframeTime.count();  ///< time of an untimed keyframe
  std::string servers;  ///< the chain through which it comes (server_chain.h), without this server
  Milliseconds patience{0};  ///< how long a client waits for a stream that is not known yet

  /// The recorded stream; null: it is not recorded, or not known yet.
  [[nodiscard]] const RecordedStream* recorded() const {
    return std::get_if<RecordedStream>(&content);
  }
  /// The live stream; null: it is not live, or not known yet.
  [[nodiscard]] const std::shared_ptr<const LiveChannel>& live() const;
  [[nodiscard]] bool known() const { return !std::holds_alternative<std::monostate>(content); }
};

}  // namespace aucast::protocol

#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "common/time.h"
#include "protocol/packet.h"
#include "protocol/voice_packet.h"

namespace aucast::protocol {

/// A voice packet as it is sent to every client, but without its place. Whether a place is sent,
/// and which, depends on what the client was sent before (PacketWriter).
struct EncodedVoice {
  Milliseconds begin{0};  ///< of its sound, on the clock of the stream
  Milliseconds end{0};
  std::string continued;  ///< {a DATA}, the form without a place

  explicit EncodedVoice(const VoicePacket& packet);
};

/// The voice of a recorded stream, encoded once and shared by all clients. It grows while the sound
/// is still being encoded. Places count from the stream's beginning.
/// Thread: that of the sessions.
class EncodedTrack {
 public:
  /// Adds the next packet, which begins at the end of the previous one or later.
  void add(const VoicePacket& packet);
  /// Called by the encoder when all packets that begin before `place` have been added. A smaller
  /// place than before has no effect.
  void encoded_to(Milliseconds place) { encoded_to_ = std::max(encoded_to_, place); }
  /// Called by the encoder when all packets have been added.
  void finish() { encoded_to_ = Milliseconds::max(); }

  [[nodiscard]] std::span<const EncodedVoice> packets() const { return packets_; }
  /// See encoded_to(); Milliseconds::max() after finish().
  [[nodiscard]] Milliseconds encoded_until() const { return encoded_to_; }
  [[nodiscard]] bool complete() const { return encoded_to_ == Milliseconds::max(); }
  /// The memory, in bytes, that it takes.
  [[nodiscard]] std::size_t bytes() const {
    return bytes_ + packets_.size() * sizeof(EncodedVoice);
  }

 private:
  std::vector<EncodedVoice> packets_;
  std::size_t bytes_ = 0;  ///< of the packets' text
  Milliseconds encoded_to_{0};
};

/// What is spoken while a recorded stream plays, for clients that ask for it.
struct SpokenTrack {
  std::shared_ptr<const EncodedTrack> voice{};  ///< null: there is none
  std::vector<CaptionData> captions{};          ///< their places never decrease
  bool captions_come = false;                   ///< a relay may still receive some

  [[nodiscard]] bool has_captions() const { return captions_come || !captions.empty(); }
};

/// Whether clients hear and read the same with either of them.
[[nodiscard]] bool same_spoken(const std::shared_ptr<const SpokenTrack>& one,
                               const std::shared_ptr<const SpokenTrack>& other);

}  // namespace aucast::protocol

#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "common/time.h"
#include "protocol/voice_packet.h"

namespace aucast::voice {

/// Opus packets to the bytes of an Ogg Opus file (RFC 7845): the packets as they are, gaps filled
/// with packets of silence. A page is complete every second, so that what has been written plays
/// wherever it is cut. Makes bytes only; writing them is the owner's.
/// Thread: none of its own.
class OggOpusWriter {
 public:
  /// The file's clock begins at `begin` on the stream's. Equal packets and `serial` give equal
  /// bytes.
  OggOpusWriter(Milliseconds begin, std::uint32_t serial);
  ~OggOpusWriter();
  OggOpusWriter(OggOpusWriter&&) noexcept;
  OggOpusWriter& operator=(OggOpusWriter&&) noexcept;

  /// The headers, first, then all pages that are complete.
  [[nodiscard]] std::string take();
  /// Adds the next packet. False: it begins before the end of the last one, and is left out.
  bool add(const protocol::VoicePacket& packet);
  /// Whether any packet was added.
  [[nodiscard]] bool any() const;
  /// Silence up to `end`, on the stream's clock; then the last page. The sound ends there to the
  /// sample, or with the last packet that was added if that ends later.
  [[nodiscard]] std::string finish(Milliseconds end);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace aucast::voice

#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "common/time.h"
#include "protocol/voice_packet.h"

namespace aucast::voice {

/// Turns Opus packets into the bytes of an Ogg Opus file (RFC 7845), without encoding them again;
/// gaps are filled with packets of silence. A page is complete every second, so that a file that is
/// cut off still plays. Makes only the bytes; the owner writes them.
/// Thread: none of its own.
class OggOpusWriter {
 public:
  /// `begin`: the place on the stream's clock at which the file's clock is 0. The same packets and
  /// `serial` give the same bytes.
  OggOpusWriter(Milliseconds begin, std::uint32_t serial);
  ~OggOpusWriter();
  OggOpusWriter(OggOpusWriter&&) noexcept;
  OggOpusWriter& operator=(OggOpusWriter&&) noexcept;

  /// The pages that became complete since the last call; the first call also gives the headers.
  [[nodiscard]] std::string take();
  /// Adds the next packet. Returns false if the packet was left out, since it is no Opus packet or
  /// begins before the end of the last one.
  bool add(const protocol::VoicePacket& packet);
  /// Whether any packet was added.
  [[nodiscard]] bool any() const;
  /// Fills up with silence to `end`, on the stream's clock, and returns the remaining pages. The
  /// sound ends exactly at `end`, or with the last packet that was added if that packet ends later.
  [[nodiscard]] std::string finish(Milliseconds end);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace aucast::voice

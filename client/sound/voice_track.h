#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "client/sound/sound_track.h"
#include "common/time.h"

namespace aucast::sound {

/// The voice of a stream, made from Opus packets. They must come in the order of their places, and
/// in time: a stretch that is read before its packet has come is silent. Where no packet follows,
/// the voice fades out, and it fades in where it begins again. It can be read forwards, and up to
/// kKept backwards. At most playback::kVoiceBytesMax and kVoicePacketsMax wait to be read; further
/// packets are left out.
/// Thread: none of its own.
class VoiceTrack final : public SoundTrack {
 public:
  /// How far read() can go back.
  static constexpr Milliseconds kKept{1000};

  struct Counts {
    std::uint64_t packets = 0;
    std::uint64_t bytes = 0;  ///< of Opus data
    std::uint64_t gaps = 0;   ///< times that the voice faded out, also in the speaker's pauses
    // Packets that were not heard, by cause.
    std::uint64_t too_late = 0;      ///< their time had passed
    std::uint64_t left_out = 0;      ///< there was no room for them, or the stream had ended
    std::uint64_t out_of_order = 0;  ///< they began before the end of another packet that waits
    std::uint64_t unreadable = 0;    ///< they are not valid Opus

    Counts& operator+=(const Counts& more);
  };

  /// One Opus packet whose sound begins at `place`.
  void add(Milliseconds place, std::string opus);

  /// Says that read() will not go back before sample `begin`, except by a few samples: earlier
  /// packets may be dropped.
  void skip(std::int64_t begin);
  /// Says that the last keyframe ends at sample `end`. The voice may go on for
  /// protocol::kVoiceAheadMax; packets that end later are left out.
  void end_at(std::int64_t end);
  void read(std::int64_t begin, std::span<float> samples) override;
  [[nodiscard]] std::int64_t end() const override { return last_end_; }
  [[nodiscard]] const Counts& counts() const { return counts_; }

 private:
  struct Packet {
    std::int64_t begin = 0;
    std::int64_t end = 0;
    std::string opus;
  };

  [[nodiscard]] std::int64_t decoded_end() const;
  void decode_until(std::int64_t end);
  void append(const Packet& packet);
  void fade_out(std::int64_t until);
  void forget_before(std::int64_t begin);
  void drop_front();

  voice::VoiceDecoder decoder_;
  std::deque<Packet> waiting_;
  std::size_t waiting_bytes_ = 0;
  std::int64_t last_end_ = 0;  ///< the end of the last packet that is not left out
  std::int64_t begin_ = 0;     ///< the number of decoded_'s first sample
  std::vector<float> decoded_;
  bool silent_ = true;  ///< decoded_ ends in silence
  Counts counts_;
};

}  // namespace aucast::sound

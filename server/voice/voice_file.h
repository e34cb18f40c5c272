#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "common/result.h"
#include "common/time.h"
#include "common/voice/sound_file.h"
#include "common/voice/voice_encoder.h"
#include "protocol/voice_packet.h"

namespace aucast::server {

/// A sound file as it was when it was checked. If two are equal, their sound is the same.
struct VoiceFile {
  std::filesystem::path path;
  Milliseconds begin{0};     ///< place of its first sample on the stream's clock; may be negative
  Milliseconds duration{0};  ///< as the file's header says
  std::uint64_t device = 0;
  std::uint64_t inode = 0;
  std::int64_t bytes = 0;
  std::int64_t changed_ns = 0;  ///< since 1970
  friend bool operator==(const VoiceFile&, const VoiceFile&) = default;
};

/// Checks a sound file without reading its sound. Fails with Unreadable or BadData, and a message
/// with the remedy, if it is not a sound file or has less than a millisecond of sound.
[[nodiscard]] Result<VoiceFile> find_voice_file(const std::filesystem::path& path,
                                                Milliseconds begin);

/// Reads a sound file and encodes it, piece by piece. Sound before the stream's beginning is left
/// out. Thread: none of its own.
class VoiceReader {
 public:
  [[nodiscard]] static Result<VoiceReader> open(const VoiceFile& file,
                                                const voice::VoiceSettings& settings);

  /// Appends the packets of the next second or two; returns false if these were the last.
  [[nodiscard]] bool read(std::vector<protocol::VoicePacket>& packets);
  /// How far the sound has been read, on the stream's clock.
  [[nodiscard]] Milliseconds end() const { return end_; }
  /// As SoundFile::complaint().
  [[nodiscard]] std::string complaint() const { return sound_.complaint(); }

 private:
  VoiceReader(voice::SoundFile sound, const voice::VoiceSettings& settings, Milliseconds begin);

  voice::SoundFile sound_;
  voice::VoiceEncoder encoder_;
  std::vector<float> samples_;
  std::size_t skipped_;  ///< samples that are still to be left out
  Milliseconds end_{0};
};

/// How many kilobits a second the voice takes on the wire at its rate, including base64 and the
/// characters around it, without the headers of TCP and IP.
[[nodiscard]] std::uint32_t voice_kbits(const voice::VoiceSettings& settings);

/// How many of `max_kbits` are left for a face beside its voice; 0 (no limit) if `max_kbits` is 0.
/// Fails with a Usage error and the remedy if too little is left. The message names `source`, the
/// source that the face belongs to.
[[nodiscard]] Result<std::uint32_t> face_kbits(std::uint32_t max_kbits,
                                               const voice::VoiceSettings& settings,
                                               const std::filesystem::path& source);

}  // namespace aucast::server

#pragma once

#include <cstdint>
#include <span>

namespace aucast::sound {

/// A device that plays samples: mono, kRate a second, in [-1,1].
/// Thread: the player's.
class SoundOut {
 public:
  SoundOut() = default;
  virtual ~SoundOut() = default;
  SoundOut(const SoundOut&) = delete;
  SoundOut& operator=(const SoundOut&) = delete;

  /// Plays these samples after those that were written before. Never blocks.
  virtual void write(std::span<const float> samples) = 0;
  /// How many of the written samples have been heard by now, as far as the device knows.
  [[nodiscard]] virtual std::int64_t heard() = 0;
  /// Whether the device is gone.
  [[nodiscard]] virtual bool lost() = 0;
};

}  // namespace aucast::sound

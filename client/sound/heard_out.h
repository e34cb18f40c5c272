#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "client/sound/heard_line.h"
#include "client/sound/sound_out.h"
#include "common/time.h"

namespace aucast::sound {

/// A sound device as a clock. It reports how much of what was written has been heard, in leaps; a
/// HeardLine through the reports goes evenly. When all has been heard, the clock stands until more
/// is written. Thread: the player's.
class HeardOut {
 public:
  static constexpr Milliseconds kLeadMin{100};
  static constexpr Milliseconds kLeadStep{50};
  static constexpr Milliseconds kLeadMax{400};
  static constexpr Milliseconds kDeafMax{5000};

  explicit HeardOut(std::unique_ptr<SoundOut> out) : out_(std::move(out)) {}

  /// Call it when sound begins, for the first time or again.
  void begin(Instant steady);
  void write(std::span<const float> samples);
  /// How many samples have been written.
  [[nodiscard]] std::int64_t written() const { return written_; }
  /// Looks at the device. Returns false once it is lost, or has played nothing for kDeafMax.
  [[nodiscard]] bool look(Instant steady);
  /// How much has been heard at `steady`, the time of the last look() or a later one.
  [[nodiscard]] Duration heard(Instant steady);
  /// How much has been heard by the device's own report of now; nullopt while nothing is.
  [[nodiscard]] std::optional<Duration> reported() const;
  /// How far ahead of what is heard sound is to be written: kLeadMin at first, and kLeadStep more
  /// each time that the device ran out of it, up to kLeadMax.
  [[nodiscard]] Duration lead() const;
  /// How often the device ran out of sound.
  [[nodiscard]] std::uint64_t underruns() const { return underruns_; }
  /// HeardLine::drift_ppm().
  [[nodiscard]] std::optional<double> drift_ppm() const { return line_.drift_ppm(); }
  /// Gives the device back; open() is false then.
  void close() { out_.reset(); }
  [[nodiscard]] bool open() const { return out_ != nullptr; }

 private:
  [[nodiscard]] std::int64_t report() const;

  std::unique_ptr<SoundOut> out_;
  HeardLine line_;
  std::int64_t written_ = 0;  ///< samples
  std::int64_t heard_ = 0;    ///< as of the last look()
  Instant heard_at_{};        ///< when heard_ last grew
  bool starved_ = false;      ///< the device has run out of sound and has not been given more yet
  std::uint64_t underruns_ = 0;
};

}  // namespace aucast::sound

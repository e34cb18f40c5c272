#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "client/sound/sound_out.h"
#include "client/sound/sound_track.h"
#include "common/time.h"

namespace aucast::sound::test {

/// The state of a CrankedOut, a sound device that plays only while the test turns its crank. The
/// state lives outside the device, since the player owns the device.
struct Crank {
  std::vector<float> written;
  std::int64_t heard = 0;
  std::int64_t misread = 0;  ///< by how much the device's heard() is wrong
  double part = 0;           ///< how much of the next sample was heard
  bool lost = false;

  /// Lets so much time pass for the device.
  void turn(Duration time) {
    const double samples = seconds(time) * kRate + part;
    heard = std::min(heard + static_cast<std::int64_t>(samples),
                     static_cast<std::int64_t>(written.size()));
    part = samples - std::floor(samples);
  }
};

class CrankedOut final : public SoundOut {
 public:
  explicit CrankedOut(Crank& crank) : crank_(crank) {}

  void write(std::span<const float> samples) override {
    crank_.written.insert(crank_.written.end(), samples.begin(), samples.end());
  }
  [[nodiscard]] std::int64_t heard() override { return crank_.heard + crank_.misread; }
  [[nodiscard]] bool lost() override { return crank_.lost; }

 private:
  Crank& crank_;
};

/// A track whose sample i is i / kWhole, so that a sample shows where in the track it is from.
class CountingTrack final : public SoundTrack {
 public:
  static constexpr float kWhole = 10'000'000;

  void read(std::int64_t begin, std::span<float> samples) override {
    for (float& sample : samples) sample = static_cast<float>(begin++) / kWhole;
  }
  [[nodiscard]] std::int64_t end() const override { return std::int64_t{10'000'000}; }
};

/// A tone of 200 Hz, without end: 240 samples a period.
class ToneTrack final : public SoundTrack {
 public:
  void read(std::int64_t begin, std::span<float> samples) override;
  [[nodiscard]] std::int64_t end() const override { return std::int64_t{1} << 40U; }
};

inline void ToneTrack::read(std::int64_t begin, std::span<float> samples) {
  for (float& sample : samples) {
    sample =
        0.5F * static_cast<float>(std::sin(static_cast<double>(begin++) * 2 * 3.14159265 / 240));
  }
}

/// The largest step from a sample to the next.
inline float largest_step(const std::vector<float>& samples) {
  float largest = 0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    largest = std::max(largest, std::abs(samples[i] - samples[i - 1]));
  }
  return largest;
}

}  // namespace aucast::sound::test

#include "client/face/muscle_mixer.h"

#include <algorithm>

#include "common/check.h"

namespace aucast::face {
namespace {

/// What the channel's side gets of an AU.
float intensity_for(const AuFrame& frame, std::size_t number, Side side) {
  const float left = frame.left[number];
  const float right = frame.right[number];
  const bool right_only = shows_on_one_side(static_cast<int>(number)) && left == right;
  switch (side) {
    case Side::Left:
      return right_only ? 0 : left;
    case Side::Right:
      return right;
    case Side::Both:
      break;
  }
  return std::max(left, right);
}

/// The demands of all AUs on one channel, gathered one after the other.
struct Demand {
  float largest = 0;            ///< max of i a
  float weighted = 0;           ///< sum of i a
  float intensities = 0;        ///< sum of i
  float intensity_largest = 0;  ///< max of i

  void add(float intensity, float activation) {
    largest = std::max(largest, intensity * activation);
    weighted += intensity * activation;
    intensities += intensity;
    intensity_largest = std::max(intensity_largest, intensity);
  }
  [[nodiscard]] float average() const {
    return intensities > 0 ? weighted / intensities * intensity_largest : 0;
  }
};

}  // namespace

bool shows_on_one_side(int number) {
  constexpr int kJawSideways = 30;
  constexpr int kTongueBulge = 36;
  constexpr int kWink = 46;
  return number == kJawSideways || number == kTongueBulge || number == kWink;
}

void mix(const Face& face, const AuFrame& frame, Mixer mixer, std::span<float> activations) {
  AUCAST_CHECK(activations.size() == face.channels.size());
  for (std::size_t i = 0; i < activations.size(); ++i) {
    const Channel& channel = face.channels[i];
    Demand demand;
    for (const auto& [number, recording] : face.recordings) {
      const float activation = recording.activation[i];
      const float intensity = intensity_for(frame, static_cast<std::size_t>(number), channel.side);
      if (activation != 0 && intensity > 0) demand.add(intensity, activation);
    }
    const bool largest = mixer == Mixer::Maximum || channel.takes_largest;
    activations[i] = std::min(largest ? demand.largest : demand.average(), channel.activation_max);
  }
}

}  // namespace aucast::face

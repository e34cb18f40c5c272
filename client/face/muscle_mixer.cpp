#include "client/face/muscle_mixer.h"

#include <algorithm>

#include "common/check.h"

namespace aucast::face {
namespace {

/// The intensity of an AU for a channel of that side.
float intensity_for(const AuFrame& frame, std::size_t number, Side side) {
  switch (side) {
    case Side::Left:
      return frame.left[number];
    case Side::Right:
      return frame.right[number];
    case Side::Both:
      break;
  }
  return std::max(frame.left[number], frame.right[number]);
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

std::string not_shown(const Face& face, const AuFrame& frame) {
  std::string text;
  for (std::size_t number = 1; number < kAuCount; ++number) {
    const int id = static_cast<int>(number);
    if (std::max(frame.left[number], frame.right[number]) <= 0) continue;
    if (face.recordings.contains(id)) continue;
    text += (text.empty() ? "" : ", ") + std::to_string(id);
    if (const auto name = facs_name(id)) text += " " + std::string(*name);
  }
  return text;
}

void mix(std::span<const Channel> channels, const AuRecordings& recordings, const AuFrame& frame,
         Mixer mixer, std::span<float> activations) {
  AUCAST_CHECK(activations.size() == channels.size());
  for (std::size_t i = 0; i < activations.size(); ++i) {
    const Channel& channel = channels[i];
    Demand demand;
    for (const auto& [number, recording] : recordings) {
      const float activation = recording.activation[i];
      const float intensity = intensity_for(frame, static_cast<std::size_t>(number), channel.side);
      if (activation != 0 && intensity > 0) demand.add(intensity, activation);
    }
    const bool largest = mixer == Mixer::Maximum || channel.takes_largest;
    activations[i] = std::min(largest ? demand.largest : demand.average(), channel.activation_max);
  }
}

}  // namespace aucast::face

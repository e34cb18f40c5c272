#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "client/face/muscle_mixer.h"
#include "client/playback/blinking.h"
#include "client/playback/interpolator.h"
#include "client/view/style.h"

namespace aucast::gui {

/// How AUs become a face; may change while it plays.
struct AnimationSettings {
  face::Mixer mixer = face::Mixer::Maximum;
  std::string rules = "facs";  ///< as in --rules
  playback::Interpolation interpolation = playback::Interpolation::Linear;
  friend bool operator==(const AnimationSettings&, const AnimationSettings&) = default;
};

/// The background. None: transparent in pictures, a chequer in the window.
enum class Ground : std::uint8_t { Studio, Black, Grey, White, None };

/// How far the light can be turned to either side, and up and down.
inline constexpr int kLightYawMaxDeg = 180;
inline constexpr int kLightPitchMaxDeg = 80;
inline constexpr int kLightPercentMax = 200;
/// The largest seed that is shown; a random seed may be larger.
inline constexpr int kSeedShownMax = 999'999;
[[nodiscard]] constexpr int shown_seed(std::uint64_t seed) {
  return seed < kSeedShownMax ? static_cast<int>(seed) : kSeedShownMax;
}

struct RenderingSettings {
  view::Layers layers;
  Ground ground = Ground::Studio;
  int light_yaw_deg = -38;   ///< of the key light, to the subject's left; up to kLightYawMaxDeg
  int light_pitch_deg = 34;  ///< up; up to kLightPitchMaxDeg
  int light_percent = 100;   ///< 0 to kLightPercentMax
  bool blinking = false;
  playback::BlinkOptions blink;
  friend bool operator==(const RenderingSettings&, const RenderingSettings&) = default;
};

/// A measure of how fast pictures are drawn, such as "pictures a second", "24".
struct PaceRow {
  std::string name;
  std::string value;
  friend bool operator==(const PaceRow&, const PaceRow&) = default;
};

struct RenderingView {
  RenderingSettings settings;
  std::vector<PaceRow> pace;  ///< empty until something moves
  friend bool operator==(const RenderingView&, const RenderingView&) = default;
};

}  // namespace aucast::gui

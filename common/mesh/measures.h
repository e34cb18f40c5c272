#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "common/mesh/head_fit.h"

namespace aucast::mesh {

/// What is measured on each side of a face, in units of the distance between the outer corners of
/// the eyes. Values grow in the direction that the name says: up, out (away from the middle),
/// front.
enum class SideMeasure : std::uint8_t {
  BrowInnerUp,
  BrowMiddleUp,
  BrowOuterUp,
  BrowInnerOut,
  Aperture,  ///< between the lids, in widths of the eye
  UpperLidUp,
  LowerLidUp,
  CornerUp,  ///< of the mouth
  CornerOut,
  CornerFront,
  NoseWingUp,
  NoseWingOut,
  CheekUp,
  CheekOut,
  CheekFront,
  NasolabialUp,
  GazeLeft,  ///< of the iris, in units of half the eye's width; to the subject's left for both eyes
  GazeUp,
};
inline constexpr std::size_t kSideMeasures = 18;

/// What is measured once per face, in the same units.
enum class MiddleMeasure : std::uint8_t {
  BrowGap,
  MouthWidth,
  LipGap,
  UpperLipHeight,
  LowerLipHeight,
  LipsHeight,
  UpperLipUp,
  LowerLipUp,
  ChinUp,
  ChinBossUp,
  LipsFront,
  NoseTipUp,
  MouthLeft,
  // From here on: heights of places that no expression moves, at the eyes, down the bridge of the
  // nose and at the sides of the head. When a head nods, the net not only turns these places but
  // also bends them.
  StillOuterEyeUp,
  StillInnerEyeUp,
  StillBridgeTopUp,
  StillBridgeHighUp,
  StillBridgeMiddleUp,
  StillBridgeLowUp,
  StillRidgeUp,
  StillTipUp,
  StillTipLowUp,
  StillTipUnderUp,
  StillSeptumUp,
  StillNoseBaseUp,
  StillTempleHighUp,
  StillTempleUp,
  StillEarUp,
  StillJawHingeUp,
};
inline constexpr std::size_t kMiddleMeasures = 29;
inline constexpr auto kFirstStill = static_cast<std::size_t>(MiddleMeasure::StillOuterEyeUp);

struct Measures {
  std::array<double, kSideMeasures> left{};
  std::array<double, kSideMeasures> right{};
  std::array<double, kMiddleMeasures> middle{};
  HeadTurn turn;
  double scale = 1;
};

/// Measures a face that was fitted to a head whose outer corners of the eyes are 1 apart.
[[nodiscard]] Measures measure(const FittedHead& head);

/// The names of the measures, for files: "brow-inner-up".
[[nodiscard]] const std::array<std::string_view, kSideMeasures>& side_measure_names();
[[nodiscard]] const std::array<std::string_view, kMiddleMeasures>& middle_measure_names();

}  // namespace aucast::mesh

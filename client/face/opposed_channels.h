#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include "client/face/face.h"

namespace aucast::face {

/// The names of two channels that pull opposite ways.
struct OpposedNames {
  std::string_view plus;
  std::string_view minus;
};

inline constexpr OpposedNames kHeadTurn{"head_turn_left", "head_turn_right"};
inline constexpr OpposedNames kHeadPitch{"head_up", "head_down"};
inline constexpr OpposedNames kHeadTilt{"head_tilt_left", "head_tilt_right"};
inline constexpr OpposedNames kHeadShift{"head_forward", "head_back"};
/// Each eye has these two; "left_" or "right_" goes in front of the names.
inline constexpr OpposedNames kGazeYaw{"gaze_left", "gaze_right"};
inline constexpr OpposedNames kGazePitch{"gaze_up", "gaze_down"};

inline constexpr std::array kOpposedNames{kGazeYaw,   kGazePitch, kHeadTurn,
                                          kHeadPitch, kHeadTilt,  kHeadShift};

/// Two channels of a face that pull opposite ways; a channel is nullopt if the face does not have
/// it.
struct OpposedChannels {
  std::optional<std::size_t> plus;
  std::optional<std::size_t> minus;

  /// The activation of `plus` minus that of `minus`; a missing channel counts as 0.
  [[nodiscard]] float of(std::span<const float> activations) const {
    return (plus ? activations[*plus] : 0.0F) - (minus ? activations[*minus] : 0.0F);
  }
};

[[nodiscard]] inline OpposedChannels opposed(const Face& face, const OpposedNames& names,
                                             Side side = Side::Both) {
  return {face.channel_index(sided_name(side, names.plus)),
          face.channel_index(sided_name(side, names.minus))};
}

}  // namespace aucast::face

#include "client/pipeline/expression_muscles.h"

#include <algorithm>
#include <string_view>

namespace aucast::pipeline {
namespace {

/// The name without the side at its beginning, in any of the spellings.
std::string_view without_side(std::string_view name) {
  for (const std::string_view side : {"left_", "right_", "Left_", "Right_", "L_", "R_"}) {
    if (name.starts_with(side)) return name.substr(side.size());
  }
  return name;
}

bool is_muscle(const face::Channel& channel, const ExpressionMuscle& muscle) {
  const std::string_view name = without_side(channel.name);
  return name == muscle.name || std::find(muscle.spellings.begin(), muscle.spellings.end(), name) !=
                                    muscle.spellings.end();
}

}  // namespace

Result<void> apply_muscles(const face::Face& face, const Expression& expression,
                           std::span<float> activations) {
  for (const ExpressionMuscle& muscle : expression.muscles) {
    bool found = false;
    for (std::size_t i = 0; i < face.channels.size(); ++i) {
      const face::Channel& channel = face.channels[i];
      if (!is_muscle(channel, muscle)) continue;
      found = true;
      const float value = channel.side == Side::Left    ? muscle.left
                          : channel.side == Side::Right ? muscle.right
                                                        : std::max(muscle.left, muscle.right);
      activations[i] = std::max(activations[i], std::min(value, channel.activation_max));
    }
    if (!found) {
      return Error{ErrorKind::BadData, "expression '" + expression.name + "': face " + face.name +
                                           " has no muscle '" + muscle.name + "'"};
    }
  }
  return {};
}

}  // namespace aucast::pipeline

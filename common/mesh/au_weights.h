#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "common/mesh/measures.h"
#include "common/result.h"

namespace aucast::mesh {

/// What one side of a face sees of it, against the quiet face: its own side's measures, the other
/// side's, those of the middle, and the head's turn. What goes to the left or right goes towards
/// its own side here, so that both sides have the same weights. The aperture of the lids is in
/// shares of what it is at rest: -1 is shut, also of narrow eyes.
inline constexpr std::size_t kInputs = 2 * kSideMeasures + kMiddleMeasures + 3;
using Inputs = std::array<double, kInputs>;
[[nodiscard]] Inputs inputs_of(const Measures& seen, const Measures& quiet, bool left);

/// How Action Units follow from measures: weights of linear regressions, in a file of ours
/// (data/camera/action_units.txt, which scripts/train_camera writes).
struct AuWeights {
  /// A number that is weighed: an input, its part above 0, or the product of two.
  struct Feature {
    std::size_t input = 0;
    bool above = false;
    std::optional<std::size_t> times;
  };
  enum class Kind : std::uint8_t {
    Sided,    ///< each side has its own intensity
    Whole,    ///< both have the mean of what they see
    Turning,  ///< towards the left; its opposite is the next number
    Signed,   ///< upwards; its opposite is the next number
  };
  struct Unit {
    std::uint8_t number = 0;
    Kind kind = Kind::Whole;
    double threshold = 0;  ///< what is below is noise
    double bias = 0;
    std::vector<double> weights;  ///< one for each feature
  };

  Measures typical;  ///< a quiet face of nobody in particular
  /// What only seems to move with each radian by which the head is raised: landmarks are flatter
  /// than a face, so that what lies before or behind the eyes does not turn back quite.
  std::array<double, kSideMeasures> raised_side{};
  std::array<double, kMiddleMeasures> raised_middle{};
  std::vector<Feature> features;
  std::vector<Unit> units;
};

/// What is seen, without what only seems to move since the head is raised or lowered.
[[nodiscard]] Measures levelled(const AuWeights& weights, const Measures& seen,
                                const Measures& quiet);

/// BadData with file:line when the text is no file of weights.
[[nodiscard]] Result<AuWeights> parse_au_weights(std::string_view text, std::string_view file);

}  // namespace aucast::mesh

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

/// The inputs of the regressions for one side of a face: the differences from the neutral face in
/// the side's own measures, the other side's, those of the middle, and the head's turn. For the
/// right side, directions are mirrored, so that both sides have the same weights. The aperture of
/// the lids is relative to the neutral one: -1 is shut, even for narrow eyes.
inline constexpr std::size_t kInputs = 2 * kSideMeasures + kMiddleMeasures + 3;
using Inputs = std::array<double, kInputs>;
[[nodiscard]] Inputs inputs_of(const Measures& seen, const Measures& neutral, bool left);

/// How Action Units are computed from measures: the weights of linear regressions, from a file of
/// ours (data/camera/action_units.txt, which scripts/train_camera writes).
struct AuWeights {
  /// A number that has a weight: an input, max(0, input), or the product of two inputs.
  struct Feature {
    std::size_t input = 0;
    bool above = false;
    std::optional<std::size_t> times;
  };
  enum class Kind : std::uint8_t {
    Sided,    ///< each side has its own intensity
    Whole,    ///< both sides have the mean of their intensities
    Turning,  ///< to the left; the AU with the next number is its opposite
    Signed,   ///< upwards; the AU with the next number is its opposite
  };
  struct Unit {
    std::uint8_t number = 0;
    Kind kind = Kind::Whole;
    double threshold = 0;  ///< intensities up to this are noise, and become 0
    double bias = 0;
    std::vector<double> weights;  ///< one for each feature
  };

  /// A number for each measure.
  struct PerMeasure {
    std::array<double, kSideMeasures> side{};
    std::array<double, kMiddleMeasures> middle{};
  };

  Measures typical;  ///< the neutral face of an average person
  /// How much each measure seems to change for each radian that the head is raised. The landmarks
  /// are flatter than a real face, so undoing the turn misplaces those that lie in front of or
  /// behind the eyes.
  PerMeasure raised;
  /// How much this differs from person to person, for each radian that the head is raised or
  /// lowered, and for each that it is turned to a side: two standard deviations.
  PerMeasure raised_doubt;
  PerMeasure turned_doubt;
  std::vector<Feature> features;
  std::vector<Unit> units;
};

/// The measures without the error that comes from raising or lowering the head (`raised`). Then
/// each is moved towards the neutral face by its doubt (`raised_doubt` and `turned_doubt` times the
/// angles), but not past it.
[[nodiscard]] Measures levelled(const AuWeights& weights, const Measures& seen,
                                const Measures& neutral);

/// Fails with BadData and file:line if the text is no file of weights.
[[nodiscard]] Result<AuWeights> parse_au_weights(std::string_view text, std::string_view file);

}  // namespace aucast::mesh

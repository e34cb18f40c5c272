#include "common/mesh/au_weights.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>

#include "common/number_of.h"
#include "common/problems.h"
#include "common/text.h"

namespace aucast::mesh {
namespace {

constexpr std::size_t kFeaturesMax = 1000;
constexpr int kUnitMax = 99;
/// The smallest aperture of a neutral face's eye, as in scripts/train_camera/fit.py; an eye that
/// was always shut gives no measure.
constexpr double kLeastAperture = 0.15;
constexpr std::array<std::string_view, 3> kTurnNames{"turn-left", "turn-up", "tilt-left"};

using Words = std::vector<std::string_view>;

std::vector<std::string> input_names() {
  std::vector<std::string> names;
  for (const char* side : {"own-", "other-"}) {
    for (const auto name : side_measure_names()) names.push_back(side + std::string(name));
  }
  for (const auto name : middle_measure_names()) names.emplace_back(name);
  for (const auto name : kTurnNames) names.emplace_back(name);
  return names;
}

bool read_numbers(std::span<const std::string_view> words, std::span<double> numbers) {
  if (words.size() != numbers.size()) return false;
  for (std::size_t index = 0; index < words.size(); ++index) {
    const auto number = number_of<double>(words[index]);
    if (!number || !std::isfinite(*number)) return false;
    numbers[index] = *number;
  }
  return true;
}

/// Reads the file line by line. A line begins with "neutral", "raised", "raised-doubt" or
/// "turned-doubt", each with "-side" or "-middle", or with "feature" or "au".
class WeightsReader {
 public:
  /// What is wrong with the line; nullopt if it is right.
  std::optional<std::string> read(const Words& words) {
    const std::span<const std::string_view> rest = std::span(words).subspan(1);
    if (words[0] == "feature") return read_feature(rest);
    if (words[0] == "au") return read_unit(rest);
    struct Line {
      std::string_view name;
      std::span<double> numbers;
    };
    AuWeights& to = weights_;
    const std::array<Line, 8> lines{{{"neutral-side", to.typical.left},
                                     {"neutral-middle", to.typical.middle},
                                     {"raised-side", to.raised.side},
                                     {"raised-middle", to.raised.middle},
                                     {"raised-doubt-side", to.raised_doubt.side},
                                     {"raised-doubt-middle", to.raised_doubt.middle},
                                     {"turned-doubt-side", to.turned_doubt.side},
                                     {"turned-doubt-middle", to.turned_doubt.middle}}};
    for (const auto& [name, numbers] : lines) {
      if (words[0] != name) continue;
      if (read_numbers(rest, numbers)) return std::nullopt;
      return std::to_string(numbers.size()) + " numbers are expected";
    }
    return "'" + escaped(words[0]) + "' is not known";
  }

  [[nodiscard]] bool complete() const { return !weights_.units.empty(); }
  [[nodiscard]] AuWeights take() {
    weights_.typical.right = weights_.typical.left;
    return std::move(weights_);
  }

 private:
  [[nodiscard]] std::optional<std::size_t> input_named(std::string_view name) const {
    const auto found = std::find(names_.begin(), names_.end(), name);
    if (found == names_.end()) return std::nullopt;
    return static_cast<std::size_t>(found - names_.begin());
  }

  std::optional<std::string> read_feature(std::span<const std::string_view> words) {
    if (!weights_.units.empty()) return "features come before AUs";
    const auto input = words.empty() ? std::nullopt : input_named(words[0]);
    AuWeights::Feature feature;
    feature.above = words.size() == 2 && words[1] == "above";
    if (words.size() == 3 && words[1] == "times") feature.times = input_named(words[2]);
    const bool known = words.size() == 1 || feature.above || feature.times;
    if (!input || !known || weights_.features.size() == kFeaturesMax) {
      return "a feature is a measure, or 'MEASURE above', or 'MEASURE times MEASURE'";
    }
    feature.input = *input;
    weights_.features.push_back(feature);
    return std::nullopt;
  }

  std::optional<std::string> read_unit(std::span<const std::string_view> words) {
    using Kind = AuWeights::Kind;
    constexpr std::array<std::string_view, 4> kKinds{"sided", "whole", "turning", "signed"};
    const auto number = words.size() < 2 ? std::nullopt : number_of<int>(words[0]);
    if (!number || *number < 1 || *number > kUnitMax) return "an AU from 1 to 99 is expected";
    const auto kind = std::find(kKinds.begin(), kKinds.end(), words[1]);
    if (kind == kKinds.end()) return "sided, whole, turning or signed is expected";
    std::vector<double> numbers(weights_.features.size() + 2);
    if (!read_numbers(words.subspan(2), numbers) || numbers[0] < 0 || numbers[0] >= 1) {
      return "a threshold from 0 to 1, a bias and a weight for each feature are expected";
    }
    AuWeights::Unit unit;
    unit.number = static_cast<std::uint8_t>(*number);
    unit.kind = static_cast<Kind>(kind - kKinds.begin());
    if (unit.kind == Kind::Turning || unit.kind == Kind::Signed) {
      if (*number == kUnitMax) return "its opposite would be no AU";
    }
    unit.threshold = numbers[0];
    unit.bias = numbers[1];
    unit.weights.assign(numbers.begin() + 2, numbers.end());
    weights_.units.push_back(std::move(unit));
    return std::nullopt;
  }

  const std::vector<std::string> names_ = input_names();
  AuWeights weights_;
};

}  // namespace

Inputs inputs_of(const Measures& seen, const Measures& neutral, bool left) {
  Inputs inputs{};
  std::size_t at = 0;
  const double own = left ? 1 : -1;
  const auto add_side = [&](const auto& side, const auto& neutral_side) {
    for (std::size_t index = 0; index < kSideMeasures; ++index) {
      const auto what = static_cast<SideMeasure>(index);
      const double change = side[index] - neutral_side[index];
      inputs[at++] = what == SideMeasure::Aperture
                         ? change / std::max(neutral_side[index], kLeastAperture)
                     : what == SideMeasure::GazeLeft ? own * change
                                                     : change;
    }
  };
  add_side(left ? seen.left : seen.right, left ? neutral.left : neutral.right);
  add_side(left ? seen.right : seen.left, left ? neutral.right : neutral.left);
  for (std::size_t index = 0; index < kMiddleMeasures; ++index) {
    const bool sideways = index == static_cast<std::size_t>(MiddleMeasure::MouthLeft);
    inputs[at++] = (sideways ? own : 1) * (seen.middle[index] - neutral.middle[index]);
  }
  inputs[at++] = own * (seen.turn.left_rad - neutral.turn.left_rad);
  inputs[at++] = seen.turn.up_rad - neutral.turn.up_rad;
  inputs[at++] = own * (seen.turn.tilt_left_rad - neutral.turn.tilt_left_rad);
  return inputs;
}

Measures levelled(const AuWeights& weights, const Measures& seen, const Measures& neutral) {
  const double raised = seen.turn.up_rad - neutral.turn.up_rad;
  const double turned = seen.turn.left_rad - neutral.turn.left_rad;
  Measures level = seen;
  const auto level_part = [&](auto& part, const auto& neutral_part, const auto& seeming,
                              const auto& by_raising, const auto& by_turning) {
    for (std::size_t index = 0; index < part.size(); ++index) {
      const double doubt =
          by_raising[index] * std::abs(raised) + by_turning[index] * std::abs(turned);
      const double change = part[index] - neutral_part[index] - seeming[index] * raised;
      part[index] = neutral_part[index] + change - std::clamp(change, -doubt, doubt);
    }
  };
  const AuWeights::PerMeasure& slope = weights.raised;
  const AuWeights::PerMeasure& raised_doubt = weights.raised_doubt;
  const AuWeights::PerMeasure& turned_doubt = weights.turned_doubt;
  level_part(level.left, neutral.left, slope.side, raised_doubt.side, turned_doubt.side);
  level_part(level.right, neutral.right, slope.side, raised_doubt.side, turned_doubt.side);
  level_part(level.middle, neutral.middle, slope.middle, raised_doubt.middle, turned_doubt.middle);
  return level;
}

Result<AuWeights> parse_au_weights(std::string_view text, std::string_view file) {
  WeightsReader reader;
  Problems problems{std::string(file)};
  std::size_t number = 0;
  for (const std::string_view line : split(text, '\n')) {
    ++number;
    const Words words = split_words(line);
    if (words.empty() || words[0].starts_with('#')) continue;
    if (const auto wrong = reader.read(words)) problems.add({number, 1}, *wrong);
  }
  if (auto read = problems.result(); !read) return read.error();
  if (!reader.complete()) {
    return Error{ErrorKind::BadData, at_place(file, "it has no weights of any AU")};
  }
  return reader.take();
}

}  // namespace aucast::mesh

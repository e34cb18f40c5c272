#include "common/mesh/read_aus.h"

#include <algorithm>
#include <vector>

namespace aucast::mesh {
namespace {

std::vector<double> features_of(const AuWeights& weights, const Inputs& inputs) {
  std::vector<double> features;
  features.reserve(weights.features.size());
  for (const AuWeights::Feature& feature : weights.features) {
    double value = inputs[feature.input];
    if (feature.above) value = std::max(value, 0.0);
    if (feature.times) value *= inputs[*feature.times];
    features.push_back(value);
  }
  return features;
}

double weighed(const AuWeights::Unit& unit, const std::vector<double>& features) {
  double sum = unit.bias;
  for (std::size_t index = 0; index < features.size(); ++index) {
    sum += unit.weights[index] * features[index];
  }
  return sum;
}

/// The part above the threshold, scaled so that 1 stays 1.
float above_noise(double value, double threshold) {
  return static_cast<float>(std::clamp((value - threshold) / (1 - threshold), 0.0, 1.0));
}

}  // namespace

AuFrame read_aus(const AuWeights& weights, const Measures& seen, const Measures& neutral) {
  using Kind = AuWeights::Kind;
  const Measures level = levelled(weights, seen, neutral);
  const auto left_features = features_of(weights, inputs_of(level, neutral, true));
  const auto right_features = features_of(weights, inputs_of(level, neutral, false));
  AuFrame frame;
  for (const AuWeights::Unit& unit : weights.units) {
    const double left = weighed(unit, left_features);
    const double right = weighed(unit, right_features);
    const std::size_t number = unit.number;
    if (unit.kind == Kind::Turning || unit.kind == Kind::Signed) {
      const double value = (left + (unit.kind == Kind::Turning ? -right : right)) / 2;
      const auto size = static_cast<float>(value);
      frame.left[number] = frame.right[number] = std::max(size, 0.0F);
      frame.left[number + 1] = frame.right[number + 1] = std::max(-size, 0.0F);
      continue;
    }
    const bool sided = unit.kind == Kind::Sided;
    const double mean = (left + right) / 2;
    frame.left[number] = above_noise(sided ? left : mean, unit.threshold);
    frame.right[number] = above_noise(sided ? right : mean, unit.threshold);
  }
  return frame;
}

}  // namespace aucast::mesh

#include "client/pipeline/hair_swing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>

namespace aucast::pipeline {
namespace {

/// Every 20 ms of the memory, finer than a frame of a film.
constexpr std::size_t kSteps = 30;
constexpr Duration kStep = Duration(HairSwing::kMemory) / static_cast<Duration::rep>(kSteps);

/// How much the head's pose counts by its age. Hair follows 0.12 s late on average, and swings past
/// where the head stops by a tenth of its way, as the weights are below 0 at last. Polynomials give
/// every machine the same bits.
constexpr std::array<double, kSteps> weights_by_age() {
  constexpr double kPastBegin = 0.6;  // share of the memory
  std::array<double, kSteps> weights{};
  double sum = 0;
  for (std::size_t i = 0; i < kSteps; ++i) {
    const double age = (static_cast<double>(i) + 0.5) / kSteps;
    weights[i] = age * (1 - age) * (1 - age) * (kPastBegin - age);
    sum += weights[i];
  }
  for (double& weight : weights) weight /= sum;
  return weights;
}

constexpr std::array<double, kSteps> kWeights = weights_by_age();

/// In (-1, 1): proportional while little, and never more than `most`.
float share(double deg, double most) {
  const double part = deg / most;
  return static_cast<float>(part / std::sqrt(1 + part * part));
}

}  // namespace

HairSwing::HairSwing(const face::Face& face)
    : turn_(face::opposed(face, face::kHeadTurn)),
      pitch_(face::opposed(face, face::kHeadPitch)),
      tilt_(face::opposed(face, face::kHeadTilt)) {
  if (!face.hair || face.hair->swing_deg <= 0) return;
  head_ = face.head;
  most_deg_ = static_cast<double>(face.hair->swing_deg);
}

HairSwing::Degrees HairSwing::head_of(std::span<const float> activations) const {
  return {static_cast<double>(head_->turn_deg * turn_.of(activations)),
          static_cast<double>(head_->pitch_deg * pitch_.of(activations)),
          static_cast<double>(head_->tilt_deg * tilt_.of(activations))};
}

void HairSwing::move(Instant at, std::span<const float> activations) {
  if (!head_) return;
  const Pose pose{at, head_of(activations)};
  const bool same = !poses_.empty() && poses_.back().at == at && poses_.back().head == pose.head;
  if (!same) poses_.push_back(pose);
}

void HairSwing::put(Instant at, std::span<const float> activations) {
  if (!head_) return;
  const Degrees head = head_of(activations);
  if (!poses_.empty() && poses_.back().head == head) return;
  poses_.assign(1, {at, head});
}

HairSwing::Degrees HairSwing::head_at(Instant at) const {
  const auto after = std::upper_bound(poses_.begin(), poses_.end(), at,
                                      [](Instant a, const Pose& pose) { return a < pose.at; });
  if (after == poses_.begin()) return poses_.front().head;
  const Pose& before = *std::prev(after);
  if (after == poses_.end() || before.head == after->head) return before.head;
  const double part = seconds(at - before.at) / seconds(after->at - before.at);
  const auto between = [part](double from, double to) { return from + part * (to - from); };
  return {between(before.head.turn, after->head.turn),
          between(before.head.pitch, after->head.pitch),
          between(before.head.tilt, after->head.tilt)};
}

face::HairSway HairSwing::at(Instant at) const {
  if (!swings(at)) return {};
  const Degrees now = head_at(at);
  Degrees behind;
  Instant past = at - kStep / 2;
  for (const double weight : kWeights) {
    const Degrees was = head_at(past);
    behind.turn += weight * (was.turn - now.turn);
    behind.pitch += weight * (was.pitch - now.pitch);
    behind.tilt += weight * (was.tilt - now.tilt);
    past -= kStep;
  }
  return {share(behind.turn, most_deg_), share(behind.pitch, most_deg_),
          share(behind.tilt, most_deg_)};
}

void HairSwing::forget_before(Instant at) {
  while (poses_.size() > 1 && poses_[1].at <= at - kMemory) poses_.pop_front();
}

bool HairSwing::swings(Instant at) const {
  if (!head_ || poses_.size() < 2) return false;
  // The pose that was there before the memory, and all that came in it.
  const auto in_memory = std::upper_bound(poses_.begin(), poses_.end(), at - kMemory,
                                          [](Instant a, const Pose& pose) { return a < pose.at; });
  const auto first = in_memory == poses_.begin() ? in_memory : std::prev(in_memory);
  return std::any_of(first, poses_.end(),
                     [&](const Pose& pose) { return pose.head != first->head; });
}

}  // namespace aucast::pipeline

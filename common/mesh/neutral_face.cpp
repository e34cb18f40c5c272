#include "common/mesh/neutral_face.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "common/mesh/read_aus.h"

namespace aucast::mesh {
namespace {

constexpr std::size_t kNeutralPart = 5;  ///< one picture in this many counts as neutral
/// The same for brows: they may stay raised for seconds while nothing else moves.
constexpr std::size_t kNeutralBrowPart = 2;
constexpr double kLoweredPart = 0.6;     ///< of the typical aperture; less open eyes look down
constexpr std::size_t kMostSeen = 3000;  ///< more pictures would not change the medians
constexpr double kKeptEach = 0.2;
constexpr double kEaseSeconds = 1;  ///< time constant of the changes of RunningNeutralFace

/// All measures as one array of numbers.
constexpr std::size_t kNeutralNumbers = 2 * kSideMeasures + kMiddleMeasures + 4;
using Numbers = std::array<double, kNeutralNumbers>;

Numbers numbers_of(const Measures& measures) {
  Numbers numbers{};
  auto to = std::copy(measures.left.begin(), measures.left.end(), numbers.begin());
  to = std::copy(measures.right.begin(), measures.right.end(), to);
  to = std::copy(measures.middle.begin(), measures.middle.end(), to);
  for (const double number : {measures.turn.left_rad, measures.turn.up_rad,
                              measures.turn.tilt_left_rad, measures.scale}) {
    *to++ = number;
  }
  return numbers;
}

Measures measures_of(const Numbers& numbers) {
  Measures measures;
  const auto side = [&](std::size_t begin) { return numbers.begin() + std::ptrdiff_t(begin); };
  std::copy_n(side(0), kSideMeasures, measures.left.begin());
  std::copy_n(side(kSideMeasures), kSideMeasures, measures.right.begin());
  std::copy_n(side(2 * kSideMeasures), kMiddleMeasures, measures.middle.begin());
  const std::size_t turn = 2 * kSideMeasures + kMiddleMeasures;
  measures.turn = {numbers[turn], numbers[turn + 1], numbers[turn + 2]};
  measures.scale = numbers[turn + 3];
  return measures;
}

/// Whether the number belongs to head or gaze: where somebody looks. What no expression moves goes
/// with the head.
bool is_direction(std::size_t number) {
  const auto gaze = static_cast<std::size_t>(SideMeasure::GazeLeft);
  const std::size_t of_side = number % kSideMeasures;
  return number >= 2 * kSideMeasures + kFirstStill ||
         (number < 2 * kSideMeasures && of_side >= gaze);
}

/// Whether the number belongs to the brows.
bool is_brow(std::size_t number) {
  const std::size_t middle = 2 * kSideMeasures;
  if (number < middle) {
    return number % kSideMeasures <= static_cast<std::size_t>(SideMeasure::BrowInnerOut);
  }
  return number == middle + static_cast<std::size_t>(MiddleMeasure::BrowGap);
}

double median_of(std::vector<double>& values) {
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// The sum of a face's AUs, without turns of head and eyes.
double expression_of(const AuWeights& weights, const Measures& seen, const Measures& neutral) {
  const AuFrame frame = read_aus(weights, seen, neutral);
  double sum = 0;
  for (const AuWeights::Unit& unit : weights.units) {
    if (unit.kind != AuWeights::Kind::Sided && unit.kind != AuWeights::Kind::Whole) continue;
    sum += double{frame.left[unit.number]} + double{frame.right[unit.number]};
  }
  return sum;
}

/// The median of each number; those with the weakest AUs come first in `seen`.
Measures medians(std::span<const Measures* const> seen, std::size_t neutral_part,
                 std::size_t brow_part) {
  std::vector<Numbers> all;
  for (const Measures* one : seen) all.push_back(numbers_of(*one));
  Numbers found{};
  std::vector<double> values;
  for (std::size_t number = 0; number < kNeutralNumbers; ++number) {
    const std::size_t part = is_direction(number) ? 1 : is_brow(number) ? brow_part : neutral_part;
    values.clear();
    for (std::size_t index = 0; index < (all.size() + part - 1) / part; ++index) {
      values.push_back(all[index][number]);
    }
    found[number] = median_of(values);
  }
  return measures_of(found);
}

/// Shuts the lips, in case they were always parted (AU 25): a neutral face has them shut, with the
/// same gap on everybody. The lower lip is the one that moves.
void shut_lips(Measures& neutral, const Measures& typical) {
  const auto of = [](Measures& face, MiddleMeasure what) -> double& {
    return face.middle[static_cast<std::size_t>(what)];
  };
  const double parted = of(neutral, MiddleMeasure::LipGap) -
                        typical.middle[static_cast<std::size_t>(MiddleMeasure::LipGap)];
  if (parted <= 0) return;
  of(neutral, MiddleMeasure::LipGap) -= parted;
  of(neutral, MiddleMeasure::LipsHeight) -= parted;
  of(neutral, MiddleMeasure::LowerLipUp) += parted;
}

/// Lids with a smaller aperture count as lowered.
double least_aperture(const Measures& typical) {
  return kLoweredPart * typical.left[static_cast<std::size_t>(SideMeasure::Aperture)];
}

/// Whether both eyes look down or are shut: that is no neutral face, however weak its other AUs
/// are.
bool lids_are_lowered(const Measures& seen, const Measures& typical) {
  const auto aperture = static_cast<std::size_t>(SideMeasure::Aperture);
  return std::max(seen.left[aperture], seen.right[aperture]) < least_aperture(typical);
}

/// Raises lowered lids: no neutral face has them, even if they were never seen otherwise, as at the
/// start of a film.
void raise_lids(Measures& neutral, const Measures& typical) {
  for (const auto side : {&Measures::left, &Measures::right}) {
    const auto of = [side](auto& face, SideMeasure what) -> auto& {
      return (face.*side)[static_cast<std::size_t>(what)];
    };
    const double usual = of(typical, SideMeasure::Aperture);
    const double missing = least_aperture(typical) - of(neutral, SideMeasure::Aperture);
    if (usual <= 0 || missing <= 0) continue;
    const double eye_width =
        (of(typical, SideMeasure::UpperLidUp) - of(typical, SideMeasure::LowerLidUp)) / usual;
    of(neutral, SideMeasure::Aperture) += missing;
    of(neutral, SideMeasure::UpperLidUp) += missing * eye_width;
  }
}

}  // namespace

Measures find_neutral_face(std::span<const Measures> seen, const AuWeights& weights) {
  if (seen.empty()) return weights.typical;
  const std::size_t step = (seen.size() + kMostSeen - 1) / kMostSeen;
  std::vector<const Measures*> all;
  for (std::size_t index = 0; index < seen.size(); index += step) all.push_back(&seen[index]);
  // The head is where it mostly is; the typical face knows nothing of that.
  Measures neutral = weights.typical;
  const Measures usual = medians(all, 1, 1);
  neutral.turn = usual.turn;
  // Twice: first against the typical face, then against the one that was found.
  for (int turn = 0; turn < 2; ++turn) {
    struct Ranked {
      bool lowered;
      double expression;
      const Measures* seen;
    };
    std::vector<Ranked> ranked;
    for (const Measures* one : all) {
      ranked.push_back(
          {lids_are_lowered(*one, weights.typical), expression_of(weights, *one, neutral), one});
    }
    std::stable_sort(ranked.begin(), ranked.end(), [](const Ranked& a, const Ranked& b) {
      return std::pair(a.lowered, a.expression) < std::pair(b.lowered, b.expression);
    });
    std::vector<const Measures*> weakest_first;
    for (const Ranked& one : ranked) weakest_first.push_back(one.seen);
    neutral = medians(weakest_first, kNeutralPart, kNeutralBrowPart);
    shut_lips(neutral, weights.typical);
    raise_lids(neutral, weights.typical);
  }
  return neutral;
}

Measures median_face(std::span<const Measures> seen, const AuWeights& weights) {
  if (seen.empty()) return weights.typical;
  std::vector<const Measures*> all;
  for (const Measures& one : seen) all.push_back(&one);
  return medians(all, 1, 1);
}

const Measures& RunningNeutralFace::watch(double seconds, const Measures& seen) {
  if (!kept_at_ || seconds - *kept_at_ >= kKeptEach) {
    kept_at_ = seconds;
    kept_.push_back(seen);
    if (static_cast<double>(kept_.size()) * kKeptEach > kWatchedSeconds) kept_.pop_front();
    const std::vector<Measures> watched(kept_.begin(), kept_.end());
    aim_ = find_neutral_face(watched, weights_);
    if (!eased_at_) neutral_ = *aim_;
  }
  ease(seconds);
  return neutral_;
}

void RunningNeutralFace::ease(double seconds) {
  const double past = eased_at_ ? std::max(seconds - *eased_at_, 0.0) : 0;
  eased_at_ = seconds;
  const double part = 1 - std::exp(-past / kEaseSeconds);
  Numbers now = numbers_of(neutral_);
  const Numbers aim = numbers_of(*aim_);
  for (std::size_t number = 0; number < kNeutralNumbers; ++number) {
    now[number] += part * (aim[number] - now[number]);
  }
  neutral_ = measures_of(now);
}

}  // namespace aucast::mesh

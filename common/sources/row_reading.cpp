#include "common/sources/row_reading.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/sources/signals.h"

namespace aucast::sources {
namespace {

/// No head turns further.
constexpr double kTurnMax = 10;

/// The most that a value of 100 may be after rounding.
constexpr double kValueMax = 101;

}  // namespace

bool fits_no_scale(const AuValue& au) {
  return au.native && au.value > kValueMax;
}

double scale_for(double native, double largest) {
  if (native == 100 || largest > 10) return 100;
  if (native == 5) return 5;
  if (native == 1) return largest > 1.5 ? 5 : 1;
  return largest > 1 ? 5 : 1;
}

bool is_sure(const Observation& row, double confidence_min) {
  return row.tracked && row.confidence >= confidence_min && !row.aus.empty();
}

AuFrame update_of(const Observation& row, double scale, bool sure) {
  AuFrame update = no_data();
  if (!sure) return update;
  for (const AuValue& au : row.aus) {
    if (fits_no_scale(au)) continue;
    const double intensity = au.native ? au.value / scale : au.value;
    const double most = opposite_of(au.number) != 0 ? kTurnMax : 1.0;
    const auto value = static_cast<float>(std::clamp(intensity, 0.0, most));
    set_intensity(update, au.number, au.side, value);
  }
  // A lost face has 0 millimetres.
  if (row.distance_mm && *row.distance_mm > 0) {
    const double units = std::min(*row.distance_mm, kDistanceMmMax) / kMillimetresPerUnit;
    update.left[kHeadForward] = update.right[kHeadForward] = 0;
    update.left[kHeadBack] = update.right[kHeadBack] = static_cast<float>(units);
  }
  return update;
}

std::int64_t FaceNames::of(const Observation& row) {
  if (row.face) return *row.face;
  ordinal_ = row.frame && row.frame == frame_ ? ordinal_ + 1 : 0;
  frame_ = row.frame;
  return ordinal_;
}

bool SourceClock::was_set_back(double seconds, FaceTimes& face) const {
  face.refusals = face.refused_seconds && seconds > *face.refused_seconds ? face.refusals + 1 : 1;
  face.refused_seconds = seconds;
  return refusals_max_ > 1 && face.refusals >= refusals_max_;
}

std::optional<double> SourceClock::seconds_of(const Observation& row, FaceTimes& face) {
  was_set_ = false;
  const double ordinal = face.rows++;
  std::optional<double> now = row.seconds;
  if (fps_) now = row.frame.value_or(ordinal) / *fps_;
  if (!now || std::abs(*now) > kClockSecondsMax) return std::nullopt;
  if (!begin_seconds_) begin_seconds_ = *now;
  double seconds = *now - *begin_seconds_;
  const bool again = std::exchange(restarted_, false);
  if (latest_seconds_ && again && seconds + shift_seconds_ <= *latest_seconds_)
    shift_seconds_ = *latest_seconds_ + step_seconds_ - seconds;
  if (face.last_seconds && seconds + shift_seconds_ <= *face.last_seconds) {
    const auto before = face.refused_seconds;
    if (!was_set_back(seconds, face)) return std::nullopt;
    shift_seconds_ = *latest_seconds_ - *before;
    was_set_ = true;
  }
  seconds += shift_seconds_;
  face.refused_seconds.reset();
  if (face.last_seconds) step_seconds_ = seconds - *face.last_seconds;
  face.last_seconds = seconds;
  latest_seconds_ = std::max(latest_seconds_.value_or(seconds), seconds);
  return seconds;
}

}  // namespace aucast::sources

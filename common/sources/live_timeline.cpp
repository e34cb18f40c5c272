#include "common/sources/live_timeline.h"

#include <algorithm>
#include <utility>

#include "common/time.h"

namespace aucast::sources {
namespace {

/// Time of a keyframe that eases. Short, so that the face reacts at once when data comes again.
constexpr double kEaseStepSeconds = 0.1;
constexpr std::size_t kEaseSteps = 10;

/// The rounding error that a time in seconds may have.
constexpr double kRounding = 1e-6;

/// The usual step is no longer than this: after a pause, a slow source's face need not move slowly.
constexpr double kUsualSecondsMax = 0.1;

/// A sample may come this share of a step before the time that `rate` wants, and is still taken.
constexpr double kEarlyShare = 0.3;

}  // namespace

double LiveTimeline::step_to(double seconds) {
  const bool again = std::exchange(restarted_, false);
  begins_ = begins_ || again;
  if (again) age_clock_seconds_ += kEaseStepSeconds * static_cast<double>(idle_steps_);
  if (!last_seconds_ || again) return usual_seconds_;
  const double step = seconds - *last_seconds_;
  if (step > kHoldSeconds) {
    // Data has grown old in the gap, which is not played.
    age_clock_seconds_ += step - usual_seconds_;
    begins_ = true;
    return usual_seconds_;
  }
  usual_seconds_ = std::min(step, kUsualSecondsMax);
  return step;
}

void LiveTimeline::add(double seconds, const AuFrame& update,
                       std::optional<std::uint32_t> time_ms) {
  const double step = time_ms ? *time_ms / 1000.0 : step_to(seconds);
  verbatim_ = time_ms.has_value();
  if (time_ms) begins_ = std::exchange(restarted_, false) || begins_;
  last_seconds_ = seconds;
  idle_steps_ = 0;
  said_anything_ = true;
  age_clock_seconds_ += step;
  place_seconds_ += step;
  channels_.take(age_clock_seconds_,
                 verbatim_ ? update : conditioning_.apply(age_clock_seconds_, update));
  const double since = place_seconds_ - static_cast<double>(emitted_ms_) / 1000;
  if (rate_ && since < 1 / *rate_ - step * kEarlyShare) return;
  emit(channels_.at(age_clock_seconds_), seconds);
}

void LiveTimeline::change(const ConditioningSettings& settings) {
  conditioning_.change(settings);
  dead_band_.change(settings.profile.dead_band);
}

void LiveTimeline::emit(const AuFrame& frame, double seconds) {
  const std::int64_t place = whole_milliseconds(place_seconds_);
  // A line of 0 ms is a jump.
  if (place < emitted_ms_ || (place == emitted_ms_ && !verbatim_)) return;
  protocol::Keyframe keyframe;
  keyframe.terms = canonical_terms(verbatim_ ? frame : dead_band_.settle(frame));
  keyframe.time_ms = static_cast<std::uint32_t>(place - emitted_ms_);
  emitted_ms_ = place;
  keyframes_.push_back({std::move(keyframe), seconds, std::exchange(begins_, false), clocked_});
}

void LiveTimeline::idle(double silence_seconds) {
  while (true) {
    const auto due = idle_due_seconds();
    if (!due || silence_seconds + kRounding < *due) return;
    ++idle_steps_;
    place_seconds_ += kEaseStepSeconds;
    const double age = *due + kEaseStepSeconds;
    emit(idle_steps_ == kEaseSteps ? AuFrame() : channels_.at(age_clock_seconds_ + age),
         *last_seconds_ + age);
  }
}

std::optional<double> LiveTimeline::idle_due_seconds() const {
  if (!said_anything_ || idle_steps_ == kEaseSteps) return std::nullopt;
  return kHoldSeconds + kEaseStepSeconds * static_cast<double>(idle_steps_);
}

std::vector<LiveKeyframe> LiveTimeline::take() {
  return std::exchange(keyframes_, {});
}

}  // namespace aucast::sources

#include "common/sources/conditioning.h"

#include <algorithm>
#include <utility>

namespace aucast::sources {
namespace {

/// The distance means nothing without one to compare it with.
constexpr double kDistanceSeconds = 1;

constexpr std::array<std::size_t, 2> kDistanceChannels{channel_of(kHeadForward, false),
                                                       channel_of(kHeadForward, true)};

/// Whether the channel is a turn of head or eyes; the distance is not.
bool is_turn(std::size_t channel) {
  const std::size_t number = channel % kAuCount;
  return (number >= kHeadLeft && number <= kHeadTiltRight) ||
         (number >= kEyesLeft && number <= kEyesDown);
}

/// Whether a channel of the neutral face that was asked for is subtracted.
bool is_taken_off(const ConditioningSettings& settings, std::size_t channel) {
  return !settings.neutral_turns_only || is_turn(channel);
}

bool knows_distance(const Signals& neutral) {
  return is_signal(neutral[kDistanceChannels[0]]);
}

/// Whether nothing is to be done except keeping within bounds, so that conditioning that is off
/// changes nothing.
bool is_off(const ConditioningSettings& settings) {
  const Profile& profile = settings.profile;
  return !settings.neutral_seconds && !settings.distance && !profile.filter &&
         profile.gain == PerAu(1) &&
         std::none_of(profile.neutral.begin(), profile.neutral.end(), is_signal);
}

AuFrame within_bounds(AuFrame update) {
  for (auto* side : {&update.left, &update.right}) {
    for (float& value : *side) value = std::min(value, 1.0F);
    (*side)[kHeadForward] = (*side)[kHeadBack] = -1;
  }
  return update;
}

/// Limited to what can be shown, so that the filter does not have to come back from beyond it.
void amplify(Signals& signals, const PerAu& gain) {
  for (const bool right : {false, true}) {
    for (std::size_t number = 1; number < kAuCount; ++number) {
      float& signal = signals[channel_of(number, right)];
      if (!is_signal(signal)) continue;
      const double factor = gain.of(shown_by(number, signal), right);
      signal = std::clamp(signal * static_cast<float>(factor), -1.0F, 1.0F);
    }
  }
}

}  // namespace

std::optional<double> seconds_to_measure(const ConditioningSettings& settings) {
  if (settings.neutral_seconds) return settings.neutral_seconds;
  if (settings.distance && !knows_distance(settings.profile.neutral)) return kDistanceSeconds;
  return std::nullopt;
}

Signals raw_signals(const AuFrame& update, const ConditioningSettings& settings) {
  Signals signals = signals_of(update);
  if (!settings.distance) {
    for (const std::size_t channel : kDistanceChannels) signals[channel] = kNoSignal;
  }
  return signals;
}

MeasuredNeutral taken_off(const ConditioningSettings& settings, MeasuredNeutral measured) {
  for (std::size_t channel = 0; channel < kChannels; ++channel) {
    if (!is_taken_off(settings, channel)) measured.signals[channel] = kNoSignal;
  }
  return measured;
}

Signals neutral_with(const ConditioningSettings& settings, const MeasuredNeutral& measured) {
  Signals neutral = settings.profile.neutral;
  const auto take = [&](std::size_t channel) {
    if (is_signal(measured.signals[channel])) neutral[channel] = measured.signals[channel];
  };
  if (settings.neutral_seconds) {
    for (std::size_t channel = 0; channel < kChannels; ++channel) {
      if (is_taken_off(settings, channel)) take(channel);
    }
  } else {
    for (const std::size_t channel : kDistanceChannels) take(channel);
  }
  return neutral;
}

Conditioning::Conditioning(const ConditioningSettings& settings)
    : settings_(settings), neutral_(settings.profile.neutral) {
  begin_to_measure();
}

void Conditioning::begin_to_measure() {
  if (const auto seconds = seconds_to_measure(settings_)) meter_.emplace(*seconds);
}

AuFrame Conditioning::apply(double seconds, const AuFrame& update) {
  if (is_off(settings_)) return within_bounds(update);
  Signals signals = raw_signals(update, settings_);
  measure(seconds, signals);
  take_off(signals, neutral_);
  amplify(signals, settings_.profile.gain);
  if (settings_.profile.filter) filters_.apply(seconds, signals, *settings_.profile.filter);
  return update_of(signals);
}

/// During the measurement, what was measured so far is used as the neutral face, so that there is
/// no jump at its end.
void Conditioning::measure(double seconds, const Signals& signals) {
  if (!meter_) return;
  if (meter_->add(seconds, signals)) {
    neutral_ = neutral_with(settings_, meter_->measured());
    return;
  }
  if (settings_.neutral_seconds) measured_ = taken_off(settings_, meter_->measured());
  meter_.reset();
}

void Conditioning::change(const ConditioningSettings& settings) {
  Signals neutral = settings.neutral_seconds ? neutral_ : settings.profile.neutral;
  if (!knows_distance(neutral)) {
    for (const std::size_t channel : kDistanceChannels) neutral[channel] = neutral_[channel];
  }
  neutral_ = neutral;
  settings_ = settings;
}

void Conditioning::forget_neutral() {
  measured_.reset();
  filters_ = {};
  begin_to_measure();
}

std::optional<MeasuredNeutral> Conditioning::take_neutral() {
  return std::exchange(measured_, std::nullopt);
}

}  // namespace aucast::sources

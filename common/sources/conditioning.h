#pragma once

#include <optional>
#include <vector>

#include "common/action_unit.h"
#include "common/sources/neutral.h"
#include "common/sources/one_euro.h"
#include "common/sources/per_au.h"
#include "common/sources/signals.h"

namespace aucast::sources {

/// What is known of one person before one camera, and how they are to be shown.
struct Profile {
  Signals neutral = no_signals();         ///< the neutral face; no data: not known
  PerAu gain{1};                          ///< [0, 10]
  PerAu dead_band{2};                     ///< whole percent, 0-50
  std::optional<OneEuroSettings> filter;  ///< nothing: off
};

/// As `neutral_seconds`: without an end; NeutralMeter stops counting after ten minutes.
inline constexpr double kWholeRecordingSeconds = 1e9;

/// What happens to a recogniser's signals; as it stands here, nothing but the dead band.
struct ConditioningSettings {
  Profile profile;
  /// The first seconds of a face, above 0, are its neutral one and go before the profile's.
  std::optional<double> neutral_seconds;
  /// Of the neutral face only where head and eyes turn.
  bool neutral_turns_only = false;
  bool distance = false;  ///< the head's distance is shown, as AUs 57 and 58
};

/// Makes of what a recogniser sees what is to be shown, sample by sample:
/// neutral face off -> gain -> One Euro filter -> intensities. What has no data goes through as
/// such; it is held and eased after this (Channels), and the dead band comes last of all.
///
/// Up to the end signals may be negative: noise around the neutral face is averaged out by the
/// filter, where cut off at 0 it would become a small expression. What is taken off for the
/// distance is needed before it means anything: the profile's, or the median of the first second.
class Conditioning {
 public:
  explicit Conditioning(const ConditioningSettings& settings = {});

  /// The sample at `seconds`, later than the last: intensities, negative where there is no data;
  /// those of turns may be above 1. What comes back is not.
  [[nodiscard]] AuFrame apply(double seconds, const AuFrame& update);

  /// Other settings from the next sample on; what was measured stays measured.
  void change(const ConditioningSettings& settings);
  /// What was measured is measured anew.
  void forget_neutral();
  /// The neutral face, once, when it was asked for and has been measured.
  [[nodiscard]] std::optional<MeasuredNeutral> take_neutral();

 private:
  void measure(double seconds, const Signals& signals);
  void begin_to_measure();

  ConditioningSettings settings_;
  Signals neutral_;
  std::optional<NeutralMeter> meter_;
  std::optional<MeasuredNeutral> measured_;  ///< and not taken yet
  OneEuroBank filters_;
};

/// How long is measured: the neutral face's seconds, or those of the distance; or nothing is.
[[nodiscard]] std::optional<double> seconds_to_measure(const ConditioningSettings& settings);

/// The sample before anything happens to it; without the distance, unless it is asked for.
[[nodiscard]] Signals raw_signals(const AuFrame& update, const ConditioningSettings& settings);

/// What is to be taken off when this was measured: without --neutral that is the distance alone.
[[nodiscard]] Signals neutral_with(const ConditioningSettings& settings,
                                   const MeasuredNeutral& measured);

}  // namespace aucast::sources

#pragma once

#include <optional>
#include <vector>

#include "common/action_unit.h"
#include "common/sources/neutral.h"
#include "common/sources/one_euro.h"
#include "common/sources/per_au.h"
#include "common/sources/signals.h"

namespace aucast::sources {

/// What is known of one person in front of one camera, and how their signals are to be conditioned.
struct Profile {
  Signals neutral = no_signals();         ///< the neutral face; no data: not known
  PerAu gain{1};                          ///< [0, 10]
  PerAu dead_band{2};                     ///< whole percent, 0-50
  std::optional<OneEuroSettings> filter;  ///< nothing: off
};

/// A value for `neutral_seconds`: no end; NeutralMeter stops counting after ten minutes.
inline constexpr double kWholeRecordingSeconds = 1e9;

/// What happens to a recogniser's signals; by default, nothing but the dead band.
struct ConditioningSettings {
  Profile profile;
  /// Above 0: the neutral face is measured in so many first seconds of a face, and replaces the
  /// profile's.
  std::optional<double> neutral_seconds;
  /// Of the neutral face, subtract only the turns of head and eyes.
  bool neutral_turns_only = false;
  bool distance = false;  ///< the head's distance is shown, as AUs 57 and 58
};

/// Turns what a recogniser sees into what is to be shown, sample by sample: neutral face off ->
/// gain -> One Euro filter -> intensities. A signal without data stays without; it is held and
/// eased after this (Channels), and the dead band comes last of all.
///
/// Up to the end signals may be negative: the filter averages out noise around the neutral face,
/// which would become a small expression if it were cut off at 0. The distance means nothing before
/// a neutral distance is subtracted: the profile's, or the median of the first second.
class Conditioning {
 public:
  explicit Conditioning(const ConditioningSettings& settings = {});

  /// The sample at `seconds`, later than the last: intensities, negative where there is no data;
  /// those of turns may be above 1. What comes back is not.
  [[nodiscard]] AuFrame apply(double seconds, const AuFrame& update);

  /// Other settings from the next sample on; what was measured stays measured.
  void change(const ConditioningSettings& settings);
  /// Measures anew what was measured.
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

/// What is to be subtracted after this was measured: without --neutral only the distance.
[[nodiscard]] Signals neutral_with(const ConditioningSettings& settings,
                                   const MeasuredNeutral& measured);

}  // namespace aucast::sources

#pragma once

#include <optional>
#include <vector>

#include "common/action_unit.h"
#include "common/sources/neutral.h"
#include "common/sources/one_euro.h"
#include "common/sources/per_au.h"
#include "common/sources/signals.h"

namespace aucast::sources {

/// What is known about one person in front of one camera, and how their signals are to be
/// conditioned.
struct Profile {
  Signals neutral = no_signals();         ///< the neutral face; a signal without data: unknown
  PerAu gain{1};                          ///< [0, 10]
  PerAu dead_band{2};                     ///< whole percent, 0-50
  std::optional<OneEuroSettings> filter;  ///< nullopt: off
};

/// A value for `neutral_seconds` that no recording reaches (NeutralMeter ignores what comes after
/// ten minutes).
inline constexpr double kWholeRecordingSeconds = 1e9;

/// What happens to a recogniser's signals; by default, nothing but the dead band.
struct ConditioningSettings {
  Profile profile;
  /// Above 0: the neutral face is measured over this many seconds after a face is first seen, and
  /// replaces the profile's. nullopt: it is not measured.
  std::optional<double> neutral_seconds;
  /// Of the measured neutral face, only the turns of head and eyes are used.
  bool neutral_turns_only = false;
  bool distance = false;  ///< whether the head's distance is shown, as AUs 57 and 58
};

/// Turns what a recogniser sees into what is to be shown, sample by sample: the neutral face is
/// subtracted, then come gain, One Euro filter, and conversion to intensities. A signal without
/// data stays so; the class Channels holds and eases it afterwards. The dead band comes last.
///
/// Signals may be negative until the conversion, so that the filter averages out noise around the
/// neutral face. Noise that is cut off at 0 would become a small expression. The distance means
/// nothing before a neutral distance is subtracted: the profile's, or the median of the first
/// second.
class Conditioning {
 public:
  explicit Conditioning(const ConditioningSettings& settings = {});

  /// Takes `update`, the sample at `seconds`, later than the last, and returns what is to be shown.
  /// Both frames have intensities, negative where there is no data. Turns may be above 1 in
  /// `update`, but not in the result.
  [[nodiscard]] AuFrame apply(double seconds, const AuFrame& update);

  /// Uses other settings from the next sample on; a neutral face that was measured is kept.
  void change(const ConditioningSettings& settings);
  /// Measures the neutral face again.
  void forget_neutral();
  /// Returns the neutral face once, after it has been measured; otherwise nullopt. It is measured
  /// only if `neutral_seconds` is set.
  [[nodiscard]] std::optional<MeasuredNeutral> take_neutral();

 private:
  void measure(double seconds, const Signals& signals);
  void begin_to_measure();

  ConditioningSettings settings_;
  Signals neutral_;
  std::optional<NeutralMeter> meter_;
  std::optional<MeasuredNeutral> measured_;  ///< set until it is taken
  OneEuroBank filters_;
};

/// For how many seconds the neutral face, or only the distance, is measured; nullopt: neither is.
[[nodiscard]] std::optional<double> seconds_to_measure(const ConditioningSettings& settings);

/// The sample as signals, before anything is done to it; without the distance, unless
/// settings.distance is set.
[[nodiscard]] Signals raw_signals(const AuFrame& update, const ConditioningSettings& settings);

/// The part of a measured neutral face that is subtracted: all of it, or only the turns of head and
/// eyes if neutral_turns_only is set.
[[nodiscard]] MeasuredNeutral taken_off(const ConditioningSettings& settings,
                                        MeasuredNeutral measured);

/// What is to be subtracted: each signal of `measured` that has data, else that of the profile.
/// Without `neutral_seconds` only the distance is taken from `measured`.
[[nodiscard]] Signals neutral_with(const ConditioningSettings& settings,
                                   const MeasuredNeutral& measured);

}  // namespace aucast::sources

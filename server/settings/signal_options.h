#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/options.h"
#include "common/result.h"
#include "common/sources/conditioning.h"

namespace aucast::server {

/// A number for one AU, or for all of them.
struct AuNumber {
  std::optional<sources::AuName> au;
  double value = 0;
  friend bool operator==(const AuNumber&, const AuNumber&) = default;
};

/// What is said of a recogniser's signals, beside what a profile says.
struct SignalOptions {
  std::filesystem::path profile;                   ///< empty: none
  std::filesystem::path save_profile;              ///< empty: none is written
  std::optional<double> neutral_seconds;           ///< 0: no neutral face, not the profile's either
  bool neutral_auto = false;                       ///< asked for; what films and cameras do anyway
  std::vector<AuNumber> gain;                      ///< in this order, on top of the profile's
  std::vector<AuNumber> dead_band;                 ///< the same
  std::optional<sources::OneEuroSettings> filter;  ///< a min_cutoff_hz of 0: none
  bool distance = false;
  friend bool operator==(const SignalOptions&, const SignalOptions&) = default;
};

/// Their options, bound to `options`: --distance to --save-profile.
[[nodiscard]] std::vector<OptionRow> signal_rows(SignalOptions& options);

/// What the options and their profile come to; the options win. Unreadable or BadData for a
/// profile.
[[nodiscard]] Result<sources::ConditioningSettings> conditioning_of(const SignalOptions& options);

/// Whether the first seconds of a face are to be measured.
[[nodiscard]] bool measures_neutral(const SignalOptions& options);

/// Writes what the options, their profile and the neutral face that was `measured` come to, to
/// options.save_profile, whole or not at all. BadData when nothing could be measured.
[[nodiscard]] Result<void> save_profile(const SignalOptions& options,
                                        const std::optional<sources::MeasuredNeutral>& measured);

}  // namespace aucast::server

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

/// A number for one AU or, with nullopt, for all of them.
struct AuNumber {
  std::optional<sources::AuName> au;
  double value = 0;
  friend bool operator==(const AuNumber&, const AuNumber&) = default;
};

/// The options about a recogniser's signals; a profile may set the same things.
struct SignalOptions {
  std::filesystem::path profile;          ///< empty: none
  std::filesystem::path save_profile;     ///< empty: none is written
  std::optional<double> neutral_seconds;  ///< 0: none, not even the profile's; nullopt: not given
  bool neutral_auto = false;              ///< `auto` was given, which films and cameras do anyway
  std::vector<AuNumber> gain;             ///< applied in this order, after the profile's
  std::vector<AuNumber> dead_band;        ///< likewise
  std::optional<sources::OneEuroSettings> filter;  ///< cutoff 0: off; nullopt: not given
  bool distance = false;
  friend bool operator==(const SignalOptions&, const SignalOptions&) = default;
};

/// The rows from --distance to --save-profile, bound to `options`.
[[nodiscard]] std::vector<OptionRow> signal_rows(SignalOptions& options);

/// The settings that result from the options and their profile; the options win. Fails with
/// Unreadable or BadData if the profile cannot be read or is wrong.
[[nodiscard]] Result<sources::ConditioningSettings> conditioning_of(const SignalOptions& options);

/// Whether the neutral face is to be measured, in the first seconds of a face.
[[nodiscard]] bool measures_neutral(const SignalOptions& options);

/// Writes a new profile, whole or not at all: that of the settings, with the `measured` neutral
/// face if there is one. Fails with BadData if no face was seen.
[[nodiscard]] Result<void> save_profile(const std::filesystem::path& file,
                                        const sources::ConditioningSettings& settings,
                                        const std::optional<sources::MeasuredNeutral>& measured);

}  // namespace aucast::server

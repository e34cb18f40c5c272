#include "server/settings/signal_options.h"

#include <array>
#include <cmath>
#include <string_view>

#include "common/files.h"
#include "common/sources/profile.h"
#include "common/text.h"

namespace aucast::server {
namespace {

/// Nobody keeps a face still for longer.
constexpr double kNeutralSecondsMax = 60;

/// "2,12=4,L45=0"; nothing when it is not of that form.
std::optional<std::vector<AuNumber>> read_au_numbers(std::string_view word, double most) {
  std::vector<AuNumber> numbers;
  for (std::string_view part : split(word, ',')) {
    AuNumber number;
    if (const std::size_t equals = part.find('='); equals != std::string_view::npos) {
      number.au = sources::parse_au_name(part.substr(0, equals));
      if (!number.au) return std::nullopt;
      part.remove_prefix(equals + 1);
    }
    const auto value = number_of<double>(part);
    if (!value || !(*value >= 0 && *value <= most)) return std::nullopt;
    number.value = *value;
    numbers.push_back(number);
  }
  return numbers;
}

void apply(const std::vector<AuNumber>& numbers, sources::PerAu& table) {
  for (const AuNumber& number : numbers) {
    if (number.au) {
      table.set(*number.au, number.value);
    } else {
      table.set_all(number.value);
    }
  }
}

}  // namespace

Complaint read_neutral(const std::string& word, SignalOptions& options) {
  const auto seconds = number_of<double>(word);
  if (!seconds || !(*seconds >= 0 && *seconds <= kNeutralSecondsMax)) {
    return "is not a number of seconds from 0 (no neutral face) to 60";
  }
  options.neutral_seconds = seconds;
  return std::nullopt;
}

Complaint read_gain(const std::string& word, SignalOptions& options) {
  auto numbers = read_au_numbers(word, sources::kGainMax);
  if (!numbers) return "is not a list of numbers from 0 to 10, such as 1.2 or 45=1.6,L12=1.2";
  options.gain = std::move(*numbers);
  return std::nullopt;
}

Complaint read_dead_band(const std::string& word, SignalOptions& options) {
  auto numbers = read_au_numbers(word, sources::kDeadBandMax);
  for (std::size_t index = 0; numbers && index < numbers->size(); ++index) {
    if (std::floor((*numbers)[index].value) != (*numbers)[index].value) numbers.reset();
  }
  if (!numbers) return "is not a list of whole percents from 0 to 50, such as 2 or 2,12=4,L45=0";
  options.dead_band = std::move(*numbers);
  return std::nullopt;
}

Complaint read_filter(const std::string& word, SignalOptions& options) {
  constexpr const char* kWrong =
      "is not CUTOFF[,BETA[,CUTOFF]], Hz to 100 and 0 to 100, such as 1,5; 0 is no filter";
  const auto parts = split(word, ',');
  std::array<double, 3> values{0, sources::OneEuroSettings().beta,
                               sources::OneEuroSettings().derivative_cutoff_hz};
  if (parts.size() > values.size()) return kWrong;
  constexpr std::array kMost{sources::kCutoffMax, sources::kBetaMax, sources::kCutoffMax};
  for (std::size_t index = 0; index < parts.size(); ++index) {
    const auto value = number_of<double>(parts[index]);
    if (!value || !(*value >= 0 && *value <= kMost[index])) return kWrong;
    values[index] = *value;
  }
  if (values[2] == 0) return kWrong;
  options.filter = {values[0], values[1], values[2]};
  return std::nullopt;
}

Complaint read_distance(const std::string& word, SignalOptions& options) {
  if (word != "true" && word != "false") return "is neither true nor false";
  options.distance = word == "true";
  return std::nullopt;
}

Complaint read_profile_name(const std::string& word, SignalOptions& options) {
  options.profile = word;
  return std::nullopt;
}

Complaint read_save_profile(const std::string& word, SignalOptions& options) {
  options.save_profile = word;
  return std::nullopt;
}

Result<sources::ConditioningSettings> conditioning_of(const SignalOptions& options) {
  sources::ConditioningSettings settings;
  if (!options.profile.empty()) {
    const auto text = read_file(options.profile);
    if (!text) return text.error();
    const auto profile = sources::parse_profile(*text, options.profile.string());
    if (!profile) return profile.error();
    settings.profile = *profile;
  }
  apply(options.gain, settings.profile.gain);
  apply(options.dead_band, settings.profile.dead_band);
  if (options.filter) settings.profile.filter = options.filter;
  if (settings.profile.filter && settings.profile.filter->min_cutoff_hz == 0) {
    settings.profile.filter.reset();
  }
  if (measures_neutral(options)) {
    settings.neutral_seconds = options.neutral_seconds;
  } else if (options.neutral_seconds) {
    settings.profile.neutral = sources::no_signals();
  }
  settings.distance = options.distance;
  return settings;
}

bool measures_neutral(const SignalOptions& options) {
  return options.neutral_seconds.value_or(0) > 0;
}

Result<void> save_profile(const SignalOptions& options,
                          const std::optional<sources::MeasuredNeutral>& measured) {
  if (measured && measured->rows == 0) {
    return Error{ErrorKind::BadData, options.save_profile.string() +
                                         ": not written, because no face was seen to measure"};
  }
  auto settings = conditioning_of(options);
  if (!settings) return settings.error();
  if (measured) settings->profile.neutral = sources::neutral_with(*settings, *measured);
  return write_file_atomically(options.save_profile, sources::format_profile(settings->profile));
}

}  // namespace aucast::server

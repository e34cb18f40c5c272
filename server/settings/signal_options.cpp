#include "server/settings/signal_options.h"

#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "common/files.h"
#include "common/sources/profile.h"
#include "common/text.h"

namespace aucast::server {
namespace {

/// The longest measurement; nobody keeps the face still for longer.
constexpr double kNeutralSecondsMax = 60;

/// Reads "2,12=4,L45=0"; nullopt when the text is not of that form.
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

Complaint read_neutral(const std::string& word, SignalOptions& options) {
  options.neutral_auto = word == "auto";
  options.neutral_seconds = number_of<double>(word);
  const double seconds = options.neutral_seconds.value_or(-1);
  if (options.neutral_auto || (seconds >= 0 && seconds <= kNeutralSecondsMax)) return std::nullopt;
  options.neutral_seconds.reset();
  return "is neither auto nor a number of seconds from 0 (no neutral face) to 60";
}

Complaint read_gain(const std::string& word, std::vector<AuNumber>& gain) {
  auto numbers = read_au_numbers(word, sources::kGainMax);
  if (!numbers) return "is not a list of numbers from 0 to 10, such as 1.2 or 45=1.6,L12=1.2";
  gain = std::move(*numbers);
  return std::nullopt;
}

Complaint read_dead_band(const std::string& word, std::vector<AuNumber>& dead_band) {
  auto numbers = read_au_numbers(word, sources::kDeadBandMax);
  for (std::size_t index = 0; numbers && index < numbers->size(); ++index) {
    if (std::floor((*numbers)[index].value) != (*numbers)[index].value) numbers.reset();
  }
  if (!numbers) return "is not a list of whole percents from 0 to 50, such as 2 or 2,12=4,L45=0";
  dead_band = std::move(*numbers);
  return std::nullopt;
}

Complaint read_filter(const std::string& word, std::optional<sources::OneEuroSettings>& filter) {
  constexpr const char* kWrong =
      "is not CUTOFF[,BETA[,CUTOFF]], Hz to 100 and 0 to 100, such as 1,5; 0 is no filter";
  const auto parts = split(word, ',');
  std::array<double, 3> values{0, sources::OneEuroSettings().beta,
                               sources::OneEuroSettings().derivative_cutoff_hz};
  if (parts.size() > values.size()) return kWrong;
  constexpr std::array kLargest{sources::kCutoffMax, sources::kBetaMax, sources::kCutoffMax};
  for (std::size_t index = 0; index < parts.size(); ++index) {
    const auto value = number_of<double>(parts[index]);
    if (!value || !(*value >= 0 && *value <= kLargest[index])) return kWrong;
    values[index] = *value;
  }
  if (values[2] == 0) return kWrong;
  filter = {values[0], values[1], values[2]};
  return std::nullopt;
}

}  // namespace

std::vector<OptionRow> signal_rows(SignalOptions& options) {
  return {
      {.option = {"distance"},
       .text = "the head's distance, too, becomes AUs 57, 58",
       .more =
           "OpenFace's distance between head and camera becomes AUs 57 (forward) and 58 (back), "
           "100 % for 14 mm, relative to the neutral face or, without one, to the first second. "
           "Heads move further than that: --gain 57=0.1,58=0.1 makes 100 % stand for 14 cm.",
       .value = flag(options.distance)},
      {.option = {"neutral", "SECONDS"},
       .text = "subtract the face of the first SECONDS, or auto",
       .more = "Up to 60 seconds, starting at the first row with a face. The median of each AU and "
               "of the rotations of head and eyes is the neutral face, which is subtracted from "
               "every row. While it measures, a live source subtracts the median so far. 0: no "
               "neutral face, whatever the profile has. auto, the default for films and cameras: "
               "head and eyes count as straight where they usually are, and the neutral face is "
               "that of the moments with the weakest AUs. In a table, auto straightens only head "
               "and eyes, and leaves the AUs as they are.",
       .value = parsed(OptionValue::Kind::Number, read_neutral, options)},
      {.option = {"gain", "LIST"},
       .text = "factors, such as 1.2 for all or 45=1.6 for AU 45 (1)",
       .more = "Numbers from 0 to 10, separated by commas: a number alone is for every AU, 45=1.6 "
               "for AU 45, L12=1.2 for the left side of AU 12; later ones win. Applied after the "
               "neutral face is subtracted; the result is limited to 100 %.",
       .value = parsed(OptionValue::Kind::Number, read_gain, options.gain)},
      {.option = {"filter", "CUTOFF[,BETA]"},
       .text = "One Euro filter, such as 1,5; fewer Hz: smoother",
       .more = "CUTOFF[,BETA[,CUTOFF]]: the cutoff in Hz for a signal at rest, above 0, up to 100; "
               "the Hz added to it at a speed of 100 % a second, 0 to 100 (5); the cutoff of the "
               "speed in Hz (1). A lower cutoff smooths more, a higher beta delays less. Casiez, "
               "Roussel and Vogel 2012. 0: no filter, whatever the profile has.",
       .value = parsed(OptionValue::Kind::Number, read_filter, options.filter)},
      {.option = {"dead-band", "LIST"},
       .text = "least change sent, in percent, such as 3 or 45=0 (2)",
       .more = "Whole percents from 0 to 50, for all AUs or for some, as with --gain; 2 for every "
               "AU that is not named. An intensity is sent when it has changed by this much since "
               "it was last sent, so its error stays below that; a change to 0 is always sent. 0 "
               "sends every change; because of jitter that takes about half as many bytes again. "
               "Stream files and convert are not affected.",
       .value = parsed(OptionValue::Kind::Number, read_dead_band, options.dead_band)},
      {.option = {"profile", "FILE"},
       .text = "load a person's neutral face, gain, dead band, filter",
       .more = "Neutral face, gain, dead band and filter of one person at one camera, as "
               "--save-profile writes them (TOML); the options above win. SIGHUP reads it again, "
               "for live sources too.",
       .value = word(options.profile)},
      {.option = {"save-profile", "FILE"},
       .text = "save neutral face, gain, dead band, filter to FILE",
       .more = "Writes the neutral face, gain, dead band and filter that profile and options "
               "together give, completely or not at all. With --neutral it is written once the "
               "neutral face is measured, which requires a single source of a recogniser; "
               "otherwise at the start. Load it with --profile FILE.",
       .value = word(options.save_profile)},
  };
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
  if (options.neutral_auto) {
    settings.neutral_seconds = sources::kWholeRecordingSeconds;
    settings.neutral_turns_only = true;
  } else if (measures_neutral(options)) {
    settings.neutral_seconds = options.neutral_seconds;
  } else if (options.neutral_seconds) {
    settings.profile.neutral = sources::no_signals();
  }
  settings.distance = options.distance;
  return settings;
}

bool measures_neutral(const SignalOptions& options) {
  return options.neutral_auto || options.neutral_seconds.value_or(0) > 0;
}

Result<void> save_profile(const std::filesystem::path& file,
                          const sources::ConditioningSettings& settings,
                          const std::optional<sources::MeasuredNeutral>& measured) {
  if (measured && measured->rows == 0) {
    return Error{ErrorKind::BadData,
                 at_place(file.string(), "not written, because no face was seen to measure")};
  }
  sources::Profile profile = settings.profile;
  if (measured) profile.neutral = sources::neutral_with(settings, *measured);
  return write_file_atomically(file, sources::format_profile(profile));
}

}  // namespace aucast::server

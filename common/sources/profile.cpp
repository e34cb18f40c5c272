#include "common/sources/profile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "common/sources/observation.h"
#include "common/text.h"
#include "common/toml_document.h"
#include "common/toml_writer.h"

namespace aucast::sources {
namespace {

constexpr std::string_view kDistanceKey = "distance-mm";

double rounded(double value, double parts) {
  return std::round(value * parts) / parts;
}

class ProfileReader {
 public:
  explicit ProfileReader(std::string_view file) : file_(file), problems_(file_) {}

  Result<Profile> read(std::string_view text) {
    const auto document = parse_toml(text, file_);
    if (!document) return document.error();
    for (const TomlValue::Entry& entry : document->entries) {
      read_table(entry);
    }
    if (auto good = problems_.result(); !good) return good.error();
    return profile_;
  }

 private:
  using Entry = TomlValue::Entry;

  void read_table(const Entry& entry) {
    struct Table {
      const char* name;
      void (ProfileReader::*read)(const Entry&);
    };
    constexpr std::array<Table, 4> kTables{{{"neutral", &ProfileReader::read_neutral},
                                            {"gain", &ProfileReader::read_gain},
                                            {"dead-band", &ProfileReader::read_dead_band},
                                            {"filter", &ProfileReader::read_filter}}};
    const auto table = std::find_if(kTables.begin(), kTables.end(),
                                    [&](const Table& other) { return entry.key == other.name; });
    if (table == kTables.end()) {
      return refuse_key(entry, "is none of a profile's tables",
                        {"neutral", "gain", "dead-band", "filter"});
    }
    if (entry.value.kind != TomlValue::Kind::Table) {
      return refuse(entry.value.place, entry.key + " is not a table");
    }
    // `all` is what the others are exceptions of, wherever it stands.
    for (const bool of_all : {true, false}) {
      for (const Entry& item : entry.value.entries) {
        if ((item.key == "all") == of_all) (this->*table->read)(item);
      }
    }
  }

  void read_neutral(const Entry& item) {
    if (item.key == kDistanceKey) {
      const auto distance = number(item, 0, kDistanceMmMax);
      if (!distance) return;
      set_neutral({kHeadForward, Side::Both}, static_cast<float>(-*distance / kMillimetresPerUnit));
      return;
    }
    const auto au = au_of(item, {std::string(kDistanceKey)});
    const auto percent = au ? number(item, 0, kNeutralMax) : std::nullopt;
    if (!percent) return;
    const bool second = is_second_direction(au->number);
    const AuName signal{static_cast<std::uint8_t>(second ? au->number - 1 : au->number), au->side};
    if (signal.number == kHeadForward) {
      return refuse(item.place, "the distance is said as " + std::string(kDistanceKey));
    }
    if (set_neutral(signal, static_cast<float>(*percent / (second ? -100 : 100)))) return;
    refuse(item.place, "AU " + std::to_string(signal.number) +
                           (opposite_of(signal.number) != 0 ? " or its opposite" : "") +
                           " is there already");
  }

  /// False when it is set already.
  bool set_neutral(const AuName& au, float signal) {
    for (const bool right : {false, true}) {
      if (au.side == (right ? Side::Left : Side::Right)) continue;
      float& place = profile_.neutral[channel_of(au.number, right)];
      if (is_signal(place)) return false;
      place = signal;
    }
    return true;
  }

  void read_gain(const Entry& item) {
    if (const auto gain = number(item, 0, kGainMax)) set(profile_.gain, item, *gain);
  }

  void read_dead_band(const Entry& item) {
    const auto percent = number(item, 0, kDeadBandMax);
    if (!percent) return;
    if (*percent != std::floor(*percent)) return refuse(item.value.place, "is not whole percent");
    set(profile_.dead_band, item, *percent);
  }

  void set(PerAu& table, const Entry& item, double value) {
    if (item.key == "all") return table.set_all(value);
    if (const auto au = au_of(item, {"all"})) table.set(*au, value);
  }

  void read_filter(const Entry& item) {
    if (!profile_.filter) profile_.filter.emplace();
    struct Parameter {
      const char* name;
      double OneEuroSettings::*member;
      double most;
      bool zero;
    };
    constexpr std::array<Parameter, 3> kParameters{
        {{"min-cutoff", &OneEuroSettings::min_cutoff_hz, kCutoffMax, false},
         {"beta", &OneEuroSettings::beta, kBetaMax, true},
         {"derivative-cutoff", &OneEuroSettings::derivative_cutoff_hz, kCutoffMax, false}}};
    for (const Parameter& parameter : kParameters) {
      if (item.key != parameter.name) continue;
      const auto value = number(item, 0, parameter.most);
      if (!value) return;
      if (*value == 0 && !parameter.zero) return refuse(item.value.place, item.key + " is 0");
      (*profile_.filter).*parameter.member = *value;
      return;
    }
    refuse_key(item, "is none of the filter's", {"min-cutoff", "beta", "derivative-cutoff"});
  }

  std::optional<AuName> au_of(const Entry& item, const std::vector<std::string>& others) {
    const auto au = parse_au_name(item.key);
    if (!au) refuse_key(item, "is no AU, such as 12 or L12", others);
    return au;
  }

  std::optional<double> number(const Entry& item, double low, double high) {
    const TomlValue& value = item.value;
    if (!value.is_number()) {
      refuse(value.place, item.key + " is not a number");
      return std::nullopt;
    }
    if (!(value.real >= low && value.real <= high)) {
      refuse(value.place,
             item.key + " is not from " + number_text(low) + " to " + number_text(high));
      return std::nullopt;
    }
    return value.real + 0.0;  // which makes 0 of -0
  }

  void refuse_key(const Entry& entry, const std::string& why,
                  const std::vector<std::string>& known) {
    std::string text = "'" + escaped(entry.key) + "' " + why;
    if (const auto near = nearest(entry.key, known)) text += "; did you mean '" + *near + "'?";
    refuse(entry.place, text);
  }

  void refuse(const LinePosition& place, const std::string& why) { problems_.add(place, why); }

  std::string file_;
  Problems problems_;
  Profile profile_;
};

/// The neutral face as a number for each AU; where two AUs are opposite directions, only one has
/// it.
PerAu neutral_percents(const Signals& neutral) {
  PerAu percents(0);
  for (const bool right : {false, true}) {
    for (std::size_t number = 1; number < kAuCount; ++number) {
      const float signal = neutral[channel_of(number, right)];
      if (!is_signal(signal) || number == kHeadForward) continue;
      const auto shown = static_cast<std::uint8_t>(shown_by(number, signal));
      percents.set({shown, right ? Side::Right : Side::Left}, rounded(std::abs(signal) * 100, 100));
    }
  }
  return percents;
}

std::string line(std::string_view key, double value) {
  return toml_line(key, number_text(value));
}

std::string table_text(const char* name, const PerAu& values) {
  std::string text = std::string("\n[") + name + "]\n" + line("all", values.all());
  for (const auto& [au, value] : values.exceptions()) {
    text += line(au_name_text(au), value);
  }
  return text;
}

}  // namespace

Result<Profile> parse_profile(std::string_view text, std::string_view file) {
  return ProfileReader(file).read(text);
}

std::string format_profile(const Profile& profile) {
  std::string text =
      "# Profile of one face for au-transmitter --profile; AUs as in packets: 12, L12, R12.\n"
      "\n# Percent that the neutral face shows; they are subtracted.\n[neutral]\n";
  for (const auto& [au, percent] : neutral_percents(profile.neutral).exceptions()) {
    text += line(au_name_text(au), percent);
  }
  if (const float distance = profile.neutral[channel_of(kHeadForward, false)];
      is_signal(distance)) {
    text += line(kDistanceKey, rounded(-distance * kMillimetresPerUnit, 10));
  }
  text += table_text("gain", profile.gain) + table_text("dead-band", profile.dead_band);
  if (!profile.filter) return text;
  return text + "\n[filter]\n" + line("min-cutoff", profile.filter->min_cutoff_hz) +
         line("beta", profile.filter->beta) +
         line("derivative-cutoff", profile.filter->derivative_cutoff_hz);
}

std::string measured_text(const MeasuredNeutral& neutral) {
  if (neutral.rows == 0) return "not measured: there is no data";
  std::string text;
  for (const auto& [au, percent] : neutral_percents(neutral.signals).exceptions()) {
    if (percent < 1) continue;
    text += text.empty() ? "" : ", ";
    text += au_name_text(au) + " " + std::to_string(std::lround(percent)) + " %";
  }
  return "measured in " + counted(neutral.rows, "row") + " of " + number_text(neutral.seconds) +
         " s: " + (text.empty() ? "nothing over 1 %" : text);
}

}  // namespace aucast::sources

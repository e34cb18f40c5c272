#include "server/settings/source_options.h"

#include <cmath>
#include <string_view>

#include "common/sources/resample.h"
#include "common/text.h"

namespace aucast::server {
namespace {

/// A camera that is faster has no face before it.
constexpr double kFpsMax = 1000;

/// Who waits for a day waits for ever.
constexpr double kSourceTimeoutMax = 86'400;

template <Complaint (*read)(const std::string&, SignalOptions&)>
Complaint of_signal(const std::string& word, SourceOptions& options) {
  return read(word, options.signal);
}

}  // namespace

Complaint read_fps(const std::string& word, SourceOptions& options) {
  const auto fps = number_of<double>(word);
  if (!fps || !(*fps > 0 && *fps <= kFpsMax)) {
    return "is not a number of pictures a second above 0, at most 1000";
  }
  options.recording.fps = fps;
  return std::nullopt;
}

Complaint read_au_scale(const std::string& word, SourceOptions& options) {
  options.recording.au_scale.reset();
  if (word == "auto") return std::nullopt;
  const double scale = number_of<double>(word).value_or(0);
  if (scale != 1 && scale != 5 && scale != 100) return "is not one of 1, 5, 100 and auto";
  options.recording.au_scale = scale;
  return std::nullopt;
}

Complaint read_face_id(const std::string& word, SourceOptions& options) {
  options.recording.all_faces = word == "all";
  options.recording.face = number_of<std::int64_t>(word);
  if (!options.recording.face && !options.recording.all_faces) {
    return "is neither a whole number nor all";
  }
  return std::nullopt;
}

Complaint read_min_confidence(const std::string& word, SourceOptions& options) {
  const auto confidence = number_of<double>(word);
  if (!confidence || !(*confidence >= 0 && *confidence <= 1)) return "is not a number from 0 to 1";
  options.recording.confidence_min = *confidence;
  return std::nullopt;
}

Complaint read_rate(const std::string& word, SourceOptions& options) {
  const auto rate = number_of<double>(word);
  if (!rate || !(*rate >= kRateMin && *rate <= sources::kRateMax)) {
    return "is not a number of keyframes a second from 0.1 to 1000";
  }
  options.rate = rate;
  return std::nullopt;
}

void describe_source_options(CLI::App& app, SourceWords& words) {
  app.add_option("--fps", words.fps);
  app.add_option("--au-scale", words.au_scale);
  app.add_option("--face-id", words.face);
  app.add_option("--min-confidence", words.confidence);
  app.add_option("--rate", words.rate);
  app.add_option("--neutral", words.neutral);
  app.add_option("--gain", words.gain);
  app.add_option("--filter", words.filter);
  app.add_option("--profile", words.profile);
  app.add_option("--save-profile", words.save_profile);
  app.add_flag("--distance", words.distance);
}

Result<SourceOptions> read_source_options(const SourceWords& words) {
  struct Item {
    const char* option;
    const std::string& word;
    Complaint (*read)(const std::string&, SourceOptions&);
  };
  const Item items[] = {{"--fps", words.fps, read_fps},
                        {"--au-scale", words.au_scale, read_au_scale},
                        {"--face-id", words.face, read_face_id},
                        {"--min-confidence", words.confidence, read_min_confidence},
                        {"--rate", words.rate, read_rate},
                        {"--neutral", words.neutral, of_signal<read_neutral>},
                        {"--gain", words.gain, of_signal<read_gain>},
                        {"--filter", words.filter, of_signal<read_filter>},
                        {"--profile", words.profile, of_signal<read_profile_name>},
                        {"--save-profile", words.save_profile, of_signal<read_save_profile>}};
  SourceOptions options;
  options.signal.distance = words.distance;
  for (const Item& item : items) {
    if (item.word.empty()) continue;
    if (const Complaint wrong = item.read(item.word, options)) {
      return Error{ErrorKind::Usage, std::string(item.option) + " '" + escaped(item.word) + "' " +
                                         *wrong + " (try --help)"};
    }
  }
  return options;
}

Complaint read_follow(const std::string& word, LiveSourceSettings& settings) {
  if (word != "true" && word != "false") return "is neither true nor false";
  settings.follow = word == "true";
  return std::nullopt;
}

Complaint read_source_timeout(const std::string& word, LiveSourceSettings& settings) {
  const auto seconds = number_of<double>(word);
  if (!seconds || !(*seconds >= 0 && *seconds <= kSourceTimeoutMax)) {
    return "is not a number of seconds from 0 (never) to 86400";
  }
  settings.timeout = Milliseconds(std::llround(std::ceil(*seconds * 1000)));
  return std::nullopt;
}

}  // namespace aucast::server

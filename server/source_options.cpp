#include "server/source_options.h"

#include <charconv>
#include <string_view>

#include "common/text.h"
#include "server/sources/resample.h"

namespace aucast::server {
namespace {

/// A camera that is faster has no face before it.
constexpr double kFpsMax = 1000;

template <typename T>
std::optional<T> number_of(std::string_view text) {
  T value{};
  const char* end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stopped != end) return std::nullopt;
  return value;
}

Error wrong(std::string_view option, const std::string& word, std::string_view expected) {
  return {ErrorKind::Usage, std::string(option) + " '" + escaped(word) + "' is not " +
                                std::string(expected) + " (try --help)"};
}

}  // namespace

void describe_source_options(CLI::App& app, SourceWords& words) {
  app.add_option("--fps", words.fps);
  app.add_option("--au-scale", words.au_scale);
  app.add_option("--face-id", words.face);
  app.add_option("--min-confidence", words.confidence);
  app.add_option("--rate", words.rate);
}

Result<SourceOptions> read_source_options(const SourceWords& words) {
  SourceOptions options;
  sources::RecordingOptions& recording = options.recording;
  if (!words.fps.empty()) {
    recording.fps = number_of<double>(words.fps);
    if (!recording.fps || !(*recording.fps > 0 && *recording.fps <= kFpsMax)) {
      return wrong("--fps", words.fps, "a number of pictures a second above 0, at most 1000");
    }
  }
  if (!words.au_scale.empty() && words.au_scale != "auto") {
    recording.au_scale = number_of<double>(words.au_scale);
    const double scale = recording.au_scale.value_or(0);
    if (scale != 1 && scale != 5 && scale != 100) {
      return wrong("--au-scale", words.au_scale, "one of 1, 5, 100 and auto");
    }
  }
  if (!words.face.empty()) {
    recording.face = number_of<std::int64_t>(words.face);
    if (!recording.face) return wrong("--face-id", words.face, "a whole number");
  }
  if (!words.confidence.empty()) {
    const auto confidence = number_of<double>(words.confidence);
    if (!confidence || !(*confidence >= 0 && *confidence <= 1)) {
      return wrong("--min-confidence", words.confidence, "a number from 0 to 1");
    }
    recording.confidence_min = *confidence;
  }
  if (!words.rate.empty()) {
    options.rate = number_of<double>(words.rate);
    if (!options.rate || !(*options.rate >= kRateMin && *options.rate <= sources::kRateMax)) {
      return wrong("--rate", words.rate, "a number of keyframes a second from 0.1 to 1000");
    }
  }
  return options;
}

}  // namespace aucast::server

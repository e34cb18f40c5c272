#pragma once

#include <optional>
#include <string>

#include "common/command_line.h"
#include "common/result.h"
#include "common/sources/recording.h"
#include "common/time.h"
#include "server/settings/option_word.h"
#include "server/settings/signal_options.h"

namespace aucast::server {

/// How sources are read, whatever is done with them then.
struct SourceOptions {
  sources::RecordingOptions recording;
  std::optional<double>
      rate;  ///< keyframes a second, kRateMin to sources::kRateMax; else as they are
  SignalOptions signal;
  friend bool operator==(const SourceOptions&, const SourceOptions&) = default;
};

/// Slower streams than one keyframe in ten seconds are no faces.
inline constexpr double kRateMin = 0.1;

/// One option each, from its word.
[[nodiscard]] Complaint read_fps(const std::string& word, SourceOptions& options);
[[nodiscard]] Complaint read_au_scale(const std::string& word, SourceOptions& options);
[[nodiscard]] Complaint read_face_id(const std::string& word, SourceOptions& options);
[[nodiscard]] Complaint read_min_confidence(const std::string& word, SourceOptions& options);
[[nodiscard]] Complaint read_rate(const std::string& word, SourceOptions& options);

/// The words of these options as they were typed.
struct SourceWords {
  std::string fps;
  std::string au_scale;
  std::string face;
  std::string confidence;
  std::string rate;
  std::string neutral = {};
  std::string gain = {};
  std::string filter = {};
  std::string profile = {};
  std::string save_profile = {};
  bool distance = false;
};

/// Binds the options of source and signal to `words`: --fps, --au-scale, ...
void describe_source_options(CLI::App& app, SourceWords& words);

/// Usage error, one line, for a word that is none of what its option takes.
[[nodiscard]] Result<SourceOptions> read_source_options(const SourceWords& words);

/// How sources that are still being written are served.
struct LiveSourceSettings {
  bool follow = false;           ///< files too
  Milliseconds timeout{10'000};  ///< a silent one ends for its clients; 0: never
  friend bool operator==(const LiveSourceSettings&, const LiveSourceSettings&) = default;
};

[[nodiscard]] Complaint read_follow(const std::string& word, LiveSourceSettings& settings);
[[nodiscard]] Complaint read_source_timeout(const std::string& word, LiveSourceSettings& settings);

}  // namespace aucast::server

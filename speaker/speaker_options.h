#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "common/options.h"
#include "speaker/espeak_voice.h"
#include "speaker/gestures.h"

namespace aucast::speaker {

/// What the arguments ask for. Empty paths: not given.
struct Options {
  std::filesystem::path text;
  std::filesystem::path output;
  std::string name;  ///< of the files; empty: that of `text`
  std::filesystem::path narration;
  std::filesystem::path data;
  VoiceOptions voice;
  GestureOptions gestures;
  int gesture_percent = 100;
  std::filesystem::path labels;
  bool list_voices = false;
};

[[nodiscard]] std::vector<OptionRow> option_rows(Options& options);

/// The text that the arguments ask for instead of speech: help, manual page or completion.
[[nodiscard]] std::optional<std::string> asked_text(const std::vector<std::string>& arguments);

/// What --version prints, with its line end.
[[nodiscard]] std::string version_text();

}  // namespace aucast::speaker

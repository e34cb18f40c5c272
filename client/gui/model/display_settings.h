#pragma once

#include <string>
#include <vector>

namespace aucast::gui {

/// The language and the size of the panels' texts.
struct DisplaySettings {
  std::string language;    ///< a code such as "fr"; empty: the locale's language
  int text_percent = 100;  ///< size of letters and everything around them, 75-200
  friend bool operator==(const DisplaySettings&, const DisplaySettings&) = default;
};
inline constexpr int kTextPercentMin = 75;
inline constexpr int kTextPercentMax = 200;

struct LanguageEntry {
  std::string code;  ///< "fr"
  std::string name;  ///< "Français"
  friend bool operator==(const LanguageEntry&, const LanguageEntry&) = default;
};

struct DisplayView {
  DisplaySettings settings;
  std::string language;  ///< the code of the language in use
  std::vector<LanguageEntry> languages;
  friend bool operator==(const DisplayView&, const DisplayView&) = default;
};

}  // namespace aucast::gui

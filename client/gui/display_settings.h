#pragma once

#include <string>

namespace aucast::gui {

/// How the panels say things.
struct DisplaySettings {
  std::string language;    ///< its code, "fr"; empty: that of the locale
  int text_percent = 100;  ///< size of letters, and of all that is made for them, 75-200
  friend bool operator==(const DisplaySettings&, const DisplaySettings&) = default;
};
inline constexpr int kTextPercentMin = 75;
inline constexpr int kTextPercentMax = 200;

}  // namespace aucast::gui

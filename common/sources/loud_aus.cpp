#include "common/sources/loud_aus.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace aucast::sources {
namespace {

bool is_eyelid(std::size_t number) {
  return number == 5 || number == 43 || number == 45;
}

/// Those above kNeutralPercentMax, the largest first.
std::vector<LoudAu> largest(const Signals& signals, bool moves) {
  PerAu percents(0);
  for (const bool right : {false, true}) {
    for (std::size_t number = 1; number < kAuCount; ++number) {
      const float signal = signals[channel_of(number, right)];
      if (!is_signal(signal) || opposite_of(number) != 0) continue;
      if (moves && is_eyelid(number)) continue;
      const double percent = std::round(signal * 100);
      if (percent <= kNeutralPercentMax) continue;
      percents.set({static_cast<std::uint8_t>(number), right ? Side::Right : Side::Left}, percent);
    }
  }
  std::vector<LoudAu> loud;
  for (const auto& [au, percent] : percents.exceptions()) {
    loud.push_back({au, static_cast<int>(percent), moves});
  }
  std::stable_sort(loud.begin(), loud.end(),
                   [](const LoudAu& a, const LoudAu& b) { return a.percent > b.percent; });
  return loud;
}

}  // namespace

std::vector<LoudAu> loud_aus(const MeasuredNeutral& neutral) {
  auto loud = largest(neutral.signals, false);
  return loud.empty() ? largest(neutral.movement, true) : loud;
}

std::string not_neutral_text(const std::vector<LoudAu>& loud) {
  return loud_text(loud) + ": no neutral face was subtracted";
}

std::string loud_text(const std::vector<LoudAu>& loud) {
  constexpr std::size_t kShownMax = 3;
  std::string text = !loud.empty() && loud.front().moves ? "movement of " : "";
  for (std::size_t i = 0; i < std::min(loud.size(), kShownMax); ++i) {
    text += (i == 0 ? "AU" : ", AU") + au_name_text(loud[i].au) + " " +
            std::to_string(loud[i].percent) + " %";
  }
  if (loud.size() > kShownMax) text += " and " + std::to_string(loud.size() - kShownMax) + " more";
  return text;
}

}  // namespace aucast::sources

#pragma once

#include <algorithm>
#include <array>
#include <tuple>

#include "client/gui/texts/english_errors.h"
#include "client/gui/texts/english_files.h"
#include "client/gui/texts/english_making.h"
#include "client/gui/texts/english_playing.h"
#include "client/gui/texts/english_text.h"
#include "client/gui/texts/english_tips.h"
#include "client/gui/texts/english_window.h"

namespace aucast::gui {

/// Joins these tables into one.
template <typename... Tables>
consteval auto one_table(const Tables&... tables) {
  std::array<EnglishText, (std::tuple_size_v<Tables> + ...)> all{};
  auto* end = all.begin();
  ((end = std::copy(tables.begin(), tables.end(), end)), ...);
  return all;
}

/// All texts of the window, in English. {name} is a place that is filled in.
inline constexpr auto kEnglish = one_table(kEnglishWindow, kEnglishPlaying, kEnglishMaking,
                                           kEnglishFiles, kEnglishTips, kEnglishErrors);

}  // namespace aucast::gui

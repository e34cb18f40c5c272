#include "client/app/program_rows.h"

namespace aucast::app {

std::vector<OptionRow> window_rows(PlayerOptions& options) {
  return {
      {.option = {"headless"},
       .text = "no window; ends with the stream",
       .value = flag(options.headless),
       .heading = "Program"},
      {.option = {"language", "CODE"},
       .text = "language of the window, such as fr",
       .more = "The language of the window: en, or one of data/languages, such as fr. Without this "
               "option: the one last chosen in the window, or that of the locale.",
       .value = word(options.display.language)},
      {.option = {"text-size", "N"},
       .text = "size of the window's texts, 75 to 200 percent (100)",
       .more = "The size of all that is written in the window, in percent: 75 to 200 (100).",
       .value = whole(options.display.text_percent, gui::kTextPercentMin, gui::kTextPercentMax)},
      {.option = {"exit-at-end"},
       .text = "close the window when the stream ends",
       .more = "Closes the window when the stream ends.",
       .value = flag(options.exit_at_end)},
      {.option = {"no-config"},
       .text = "ignore the window's saved settings",
       .more = "The window neither reads nor writes ~/.config/aucast/face-player.toml.",
       .value = flag(options.config, false)},
  };
}

std::vector<OptionRow> program_rows(PlayerOptions& options) {
  return {
      {.option = {"log-level", "LEVEL", "warning"},
       .text = "trace, debug, info, warning, error, off (warning)",
       .value = log_level(options.log_level)},
      {.option = {"verbose"},
       .text = "the same as --log-level info; -vv: debug",
       .more = "The same as --log-level info; twice, as --log-level debug. --log-level wins.",
       .value = flag(),
       .letter = 'v'},
      {.option = {"quiet"},
       .text = "errors only, no progress line",
       .more = "The same as --log-level error, and no progress line. --log-level wins. Not with "
               "-v.",
       .value = flag(options.quiet),
       .letter = 'q'},
  };
}

}  // namespace aucast::app

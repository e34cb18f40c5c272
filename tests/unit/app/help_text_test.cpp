#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "client/app/command_pages.h"
#include "client/app/option_rows.h"
#include "client/gallery/section_names.h"
#include "client/playback/source_playback.h"
#include "client/view/style.h"
#include "client/view/video_encoder.h"

namespace aucast::app {
namespace {

constexpr Command kCommands[] = {Command::Watch, Command::Play,    Command::Pose,
                                 Command::Rules, Command::Gallery, Command::Export};

TEST(HelpText, FitsTheWidthOfATerminal) {
  for (const Command command : kCommands) {
    std::istringstream lines(help_text(command_page(command)));
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80U) << line;
  }
}

TEST(HelpText, HasNoHeadingWithoutOptions) {
  for (const Command command : kCommands) {
    const std::string text = help_text(command_page(command));
    EXPECT_EQ(text.find(":\n\n"), std::string::npos) << text;
  }
}

TEST(HelpText, HasTheOptionsAndTheExamplesOfItsCommand) {
  for (const Command command : kCommands) {
    const CommandPage page = command_page(command);
    const std::string text = help_text(page);
    for (const OptionRow& row : page.rows) {
      if (row.text.empty()) continue;
      EXPECT_NE(text.find(typed_name(row) + " "), std::string::npos) << row.option.name;
      EXPECT_NE(text.find(row.text), std::string::npos) << row.option.name;
    }
    EXPECT_FALSE(page.examples.empty());
    for (const std::string_view line : page.examples) {
      EXPECT_NE(text.find(line), std::string::npos) << line;
    }
  }
}

TEST(OptionRows, AllAreExplainedInTheManualPage) {
  for (const Command command : kCommands) {
    for (const OptionRow& row : command_page(command).rows) {
      EXPECT_FALSE(row.text.empty() && row.more.empty()) << typed_name(row);
    }
  }
}

TEST(HelpText, NamesAllLayersAndSections) {
  const auto words = [](std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
  };
  for (const Command command : {Command::Watch, Command::Play, Command::Pose, Command::Gallery}) {
    EXPECT_NE(words(help_text(command_page(command))).find("Layers: " + view::layer_names() + "."),
              std::string::npos);
  }
  const std::string gallery = words(help_text(command_page(Command::Gallery)));
  const std::string sections = gallery.substr(gallery.find(" Sections: "));
  for (const std::string_view name : gallery::kSectionNames) {
    EXPECT_NE(sections.find(" " + std::string(name)), std::string::npos) << name;
  }
}

TEST(HelpText, PlayTellsExitCodesAndKeysToo) {
  const std::string text = help_text(command_page(Command::Play));
  EXPECT_NE(text.find("Exit codes: "), std::string::npos);
  EXPECT_NE(text.find("? lists keys"), std::string::npos);
}

TEST(OptionRows, OnlyTheManualPageNamesWhatPlayIgnoresAndWhatUsageShows) {
  std::set<std::string> hidden;
  for (const OptionRow& row : command_page(Command::Play).rows) {
    if (row.text.empty()) hidden.insert(typed_name(row));
  }
  EXPECT_TRUE(hidden.contains("--buffer") && hidden.contains("--token-file"));
  for (const OptionRow& row : command_page(Command::Watch).rows) {
    const bool in_usage =
        row.option.name == "host" || row.option.name == "list" || row.option.name == "mirror";
    EXPECT_EQ(row.text.empty(), in_usage) << row.option.name;
  }
}

TEST(OptionRows, DefaultsThatTheyNameAreThoseOfTheProgram) {
  for (const Command command : kCommands) {
    PlayerOptions options;
    const PlayerOptions untouched;
    for (const OptionRow& row : option_rows(command, options)) {
      if (!row.option.fallback.empty()) {
        EXPECT_EQ(read_word(row, std::string(row.option.fallback)), std::nullopt)
            << row.option.name;
      }
    }
    EXPECT_EQ(options.playback.buffers.receiver_capacity,
              untouched.playback.buffers.receiver_capacity);
    EXPECT_EQ(options.playback.buffers.playout_capacity,
              untouched.playback.buffers.playout_capacity);
    EXPECT_EQ(options.playback.buffers.threshold_percent,
              untouched.playback.buffers.threshold_percent);
    EXPECT_EQ(options.playback.hold, untouched.playback.hold);
    EXPECT_EQ(options.playback.classic, untouched.playback.classic);
    EXPECT_EQ(options.playback.connect_timeout, untouched.playback.connect_timeout);
    EXPECT_EQ(options.playback.interpolation, untouched.playback.interpolation);
    EXPECT_EQ(options.face.face, untouched.face.face);
    EXPECT_EQ(options.face.mixer, untouched.face.mixer);
    EXPECT_EQ(options.face.rules, untouched.face.rules);
    EXPECT_EQ(options.pose.viewpoint, untouched.pose.viewpoint);
    EXPECT_EQ(options.log_level, untouched.log_level);
  }
}

TEST(OptionRows, NameTheLimitsThatAreChecked) {
  const std::map<std::string_view, std::int64_t> limits{
      {"buffer", playback::BufferOptions::kSetsMax},
      {"live-delay", playback::BufferOptions::kDelayMax.count()},
      {"speed", playback::SourcePlayback::kSpeedMax.count()},
      {"size", view::kVideoSideMax},
      {"fps", view::kVideoFpsMax}};
  PlayerOptions options;
  std::size_t seen = 0;
  for (const OptionRow& row : option_rows(Command::Play, options)) {
    const auto limit = limits.find(row.option.name);
    if (limit == limits.end()) continue;
    ++seen;
    EXPECT_NE(row.more.find(std::to_string(limit->second)), std::string::npos) << row.more;
  }
  EXPECT_EQ(seen, limits.size());
}

TEST(HelpText, VersionNamesProtocolAndLicence) {
  EXPECT_NE(version_text().find("protocol 2"), std::string::npos);
  EXPECT_NE(version_text().find("MIT"), std::string::npos);
}

}  // namespace
}  // namespace aucast::app

#include "client/gui/storage/kept_settings.h"

#include <sys/stat.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "common/files.h"
#include "tests/support/temp_folder.h"

namespace aucast::gui {
namespace {

KeptSettings unusual() {
  KeptSettings settings;
  settings.remote = {"lecture.example.org", 4777, 200, 60, 55, 500, true};
  settings.remote.behind = Behind::Time;
  settings.remote.behind_ms = 150;
  settings.remote.authorities_file = "/home/anna/ca.pem";
  settings.remote.others = {{"other.example.org", 4650}, {"::1", 9}};
  settings.recent = {"lecture.example.org:4777", "[::1]", "od\"d\\name"};
  settings.animation = {face::Mixer::Average, "kumar2010", playback::Interpolation::Cosine};
  settings.transition = {80, 10, true};
  settings.rendering.layers.muscles = true;
  settings.rendering.layers.textured = false;
  settings.rendering.ground = Ground::White;
  settings.rendering.light_yaw_deg = -90;
  settings.rendering.light_pitch_deg = 10;
  settings.rendering.light_percent = 150;
  settings.rendering.blinking = true;
  settings.tables = {{"/tables/a \"b\".csv", {25, 10, 150, 2}}, {"/tables/c.csv", {0, 30, 0, 0}}};
  settings.volume = 96;
  settings.pictures = {"/pictures", "{face}-{number}", 1920, 1080};
  settings.rendering.blink = {77, 2500, 75, playback::Interpolation::Cosine};
  return settings;
}

TEST(KeptSettings, AreReadAsTheyAreWritten) {
  for (const KeptSettings& settings : {KeptSettings{}, unusual()}) {
    const auto read = parse_settings(format_settings(settings), "s.toml");
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->settings, settings);
    EXPECT_TRUE(read->left_out.empty());
  }
}

TEST(KeptSettings, NoLayerIsAChoiceToo) {
  KeptSettings settings;
  settings.rendering.layers.textured = false;
  EXPECT_EQ(parse_settings(format_settings(settings), "s.toml").value().settings, settings);
}

TEST(KeptSettings, WhatIsNotSaidIsAsUsual) {
  EXPECT_EQ(parse_settings("", "s.toml").value().settings, KeptSettings{});
  const auto some = parse_settings("[remote]\nport = 4651\n", "s.toml");
  ASSERT_TRUE(some) << some.error().message;
  KeptSettings wanted;
  wanted.remote.port = 4651;
  EXPECT_EQ(some->settings, wanted);
}

TEST(KeptSettings, WhatIsWrongIsLeftOutAndSaidAndTheRestIsRead) {
  for (const auto& [text, where] : std::vector<std::pair<std::string, std::string>>{
           {"[remote]\nport = 70000\n", "s.toml:2:"},
           {"[remote]\nport = \"x\"\n", "s.toml:2:"},
           {"[pictures]\nname = \"{x}\"\n", "stands for nothing"},
           {"[remote]\nothers = [\"a:b\"]\n", "s.toml:2:"},
           {"[remote]\nprot = 1\n", "s.toml:2:1: "},
           {"[animation]\nmixer = \"middle\"\n", "maximum, average"},
           {"[rendering]\nshow = \"bones\"\n", "jaw-tags"},
           {"[rendering]\nshow = 1\nblinking = 1\n", "show must be a text"},
           {"[remote]\naddress = \"a b\"\n", "s.toml:2:"},
           {"[remote]\nbuffer = 10\nplayout = 20\n", "playout"},
           {"[remote]\nrecent = [1]\n", "must hold texts"},
           {"[[table]]\nfps = -1\n[later]\na = 1\n", "s.toml:2:"},
           {"face = 1\n", "face must be a table"},
           {"table = 1\n", "must be written [[table]]"}}) {
    const auto read = parse_settings(text + "[sound]\nvolume = 40\n", "s.toml");
    ASSERT_TRUE(read) << text << read.error().message;
    KeptSettings wanted;
    wanted.volume = 40;
    wanted.tables = read->settings.tables;
    EXPECT_EQ(read->settings, wanted) << text;
    ASSERT_FALSE(read->left_out.empty()) << text;
    EXPECT_NE(read->left_out[0].find(where), std::string::npos) << read->left_out[0];
  }
}

TEST(KeptSettings, EachThatIsWrongIsSaid) {
  const auto read =
      parse_settings("[remote]\nport = 0\nbuffer = \"\"\nplayout = 7\nx = 1\n[y]\n", "s.toml");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->settings.remote.playout, 7);
  EXPECT_EQ(read->left_out.size(), 4U);
}

TEST(KeptSettings, EachThatIsWrongIsSaidWithItsOwnReason) {
  const auto read =
      parse_settings("[remote]\naddress = \"a b\"\nbuffer = 10\nplayout = 20\n", "s.toml");
  ASSERT_TRUE(read) << read.error().message;
  ASSERT_EQ(read->left_out.size(), 2U);
  EXPECT_NE(read->left_out[0].find("must not be larger"), std::string::npos) << read->left_out[0];
  EXPECT_NE(read->left_out[1].find("address"), std::string::npos) << read->left_out[1];
}

TEST(KeptSettings, WhatIsNotTomlIsNotRead) {
  const auto read = parse_settings("[remote\n", "s.toml");
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().kind, ErrorKind::BadData);
  EXPECT_NE(read.error().message.find("s.toml:1:"), std::string::npos) << read.error().message;
}

TEST(KeptSettings, LiveWhereTheUsersSettingsLive) {
  EXPECT_EQ(settings_file("/c", "/h").value(), "/c/aucast/face-player.toml");
  EXPECT_EQ(settings_file("relative", "/h").value(), "/h/.config/aucast/face-player.toml");
  EXPECT_EQ(settings_file(nullptr, "/h").value(), "/h/.config/aucast/face-player.toml");
  EXPECT_FALSE(settings_file(nullptr, nullptr));
}

TEST(KeptSettings, AreSavedInAFolderThatIsMadeForThem) {
  const test::TempFolder folder;
  const auto file = folder.path() / "deep" / "aucast" / "face-player.toml";
  EXPECT_EQ(load_settings(file).settings, KeptSettings{});
  EXPECT_TRUE(load_settings(file).complaint.empty());
  ASSERT_TRUE(save_settings(unusual(), file));
  EXPECT_EQ(load_settings(file).settings, unusual());
}

TEST(KeptSettings, WhereTheyCannotBeKeptAnotherPlaceIsNamed) {
  const test::TempFolder folder;
  const auto in_the_way = folder.write("aucast", "");
  const auto saved = save_settings({}, in_the_way / "face-player.toml");
  ASSERT_FALSE(saved);
  EXPECT_NE(saved.error().message.find("XDG_CONFIG_HOME"), std::string::npos)
      << saved.error().message;
}

TEST(KeptSettings, ABrokenFileIsPutAsideAndSaid) {
  const test::TempFolder folder;
  const auto file = folder.path() / "face-player.toml";
  const std::string text = "[remote]\nport = many\n";
  ASSERT_TRUE(write_file_atomically(file, text));
  const LoadedSettings loaded = load_settings(file);
  EXPECT_EQ(loaded.settings, KeptSettings{});
  EXPECT_TRUE(loaded.may_write);
  EXPECT_NE(loaded.complaint.find("face-player.toml:2:"), std::string::npos) << loaded.complaint;
  EXPECT_NE(loaded.complaint.find(".broken; correct it"), std::string::npos) << loaded.complaint;
  EXPECT_FALSE(std::filesystem::exists(file));
  EXPECT_EQ(read_file(folder.path() / "face-player.toml.broken").value(), text);
}

TEST(KeptSettings, FiveBrokenFilesAreKeptAndTheNextIsNotWrittenTo) {
  const test::TempFolder folder;
  const auto file = folder.path() / "face-player.toml";
  const auto text = [](int number) { return "broken " + std::to_string(number) + "\n"; };
  for (int number = 1; number <= 6; ++number) {
    folder.write("face-player.toml", text(number));
    const LoadedSettings loaded = load_settings(file);
    EXPECT_EQ(loaded.may_write, number <= 5) << number;
    EXPECT_FALSE(loaded.complaint.empty());
  }
  EXPECT_EQ(read_file(file).value(), text(6));
  EXPECT_EQ(read_file(file.string() + ".broken").value(), text(1));
  for (int number = 2; number <= 5; ++number) {
    EXPECT_EQ(read_file(file.string() + ".broken." + std::to_string(number)).value(), text(number));
  }
}

TEST(KeptSettings, WithOneThatIsWrongTheFileStaysWhereItIs) {
  const test::TempFolder folder;
  const auto file = folder.write("face-player.toml", "[remote]\nport = 0\n[sound]\nvolume = 40\n");
  const LoadedSettings loaded = load_settings(file);
  EXPECT_EQ(loaded.settings.volume, 40);
  EXPECT_EQ(loaded.left_out.size(), 1U);
  EXPECT_TRUE(loaded.complaint.empty());
  EXPECT_TRUE(loaded.may_write);
  EXPECT_TRUE(std::filesystem::exists(file));
}

TEST(KeptSettings, WhatCannotBeReadStaysWhereItIs) {
  const test::TempFolder folder;
  const auto fifo = folder.path() / "fifo.toml";
  ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
  const auto large = folder.write("large.toml", std::string((std::size_t{1} << 20U) + 1, '\n'));
  for (const auto& file : {fifo, large}) {
    const LoadedSettings loaded = load_settings(file);
    EXPECT_FALSE(loaded.may_write) << file;
    EXPECT_NE(loaded.complaint.find("nothing will be written there; move that file away"),
              std::string::npos)
        << loaded.complaint;
    EXPECT_TRUE(std::filesystem::exists(file)) << file;
    EXPECT_FALSE(std::filesystem::exists(file.string() + ".broken")) << file;
  }
}

TEST(KeptSettings, FilesAndTheFaceAreRememberedToo) {
  KeptSettings settings;
  settings.face = "/home/anna/faces/default";
  settings.own_folder = "/home/anna/made";
  for (int i = 0; i < 20; ++i) {
    remember_file(settings.recent_files, "/streams/" + std::to_string(i % 10) + ".txt");
  }
  EXPECT_EQ(settings.recent_files.size(), kRecentMax);
  EXPECT_EQ(settings.recent_files.front(), "/streams/9.txt");
  const auto again = parse_settings(format_settings(settings), "f");
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(again->settings, settings);
}

TEST(KnownTables, EachIsReadAsItWasLastAndNoneAsAnother) {
  TablesView tables;
  EXPECT_EQ(settings_for(tables, "/a.csv"), TableSettings{});
  remember_table(tables, {"/a.csv", {0, 30, 0, 0}});
  remember_table(tables, {"/b.csv", {25, 0, 0, 0}});
  remember_table(tables, {"/a.csv", {0, 0, 150, 0}});
  EXPECT_EQ(tables.known->size(), 2U);
  EXPECT_EQ(settings_for(tables, "/a.csv"), (TableSettings{0, 0, 150, 0}));
  EXPECT_EQ(settings_for(tables, "/c.csv"), TableSettings{});
  tables.asked = TableSettings{0, 5, 0, 0};
  EXPECT_EQ(settings_for(tables, "/a.csv"), (TableSettings{0, 5, 0, 0}));
  remember_table(tables, {"/a.csv", {}});
  ASSERT_EQ(tables.known->size(), 1U) << "what is read as it is need not be remembered";
  EXPECT_EQ(tables.known->front().file, "/b.csv");
}

TEST(RecentAddresses, TheLastIsFirstAndNoneIsThereTwice) {
  std::vector<std::string> recent;
  RemoteSettings settings;
  for (int i = 0; i < 20; ++i) {
    settings.port = 5000 + i % 10;
    remember_address(recent, settings);
    EXPECT_EQ(recent.front(), address_text(settings));
    EXPECT_LE(recent.size(), kRecentMax);
  }
  EXPECT_EQ(recent.size(), kRecentMax);
  settings.port = 5005;
  remember_address(recent, settings);
  EXPECT_EQ(std::count(recent.begin(), recent.end(), "127.0.0.1:5005"), 1);
}

}  // namespace
}  // namespace aucast::gui

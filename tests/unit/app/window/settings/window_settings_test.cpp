#include "client/app/window/settings/window_settings.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "common/files.h"
#include "tests/support/temp_folder.h"

namespace aucast::app {
namespace {

PlayerOptions parsed(std::vector<std::string> arguments) {
  auto options = parse_player_options(std::move(arguments));
  EXPECT_TRUE(options) << options.error().message;
  return options ? *options : PlayerOptions();
}

class WindowSettingsTest : public testing::Test {
 protected:
  void write(const std::string& text) { ASSERT_TRUE(write_file_atomically(file_, text)); }
  [[nodiscard]] gui::KeptSettings on_disk() const { return gui::load_settings(file_).settings; }

  test::TempFolder folder_;
  std::filesystem::path file_ = folder_.path() / "face-player.toml";
};

TEST_F(WindowSettingsTest, TheFileIsInForceWhereTheCommandLineIsSilent) {
  write("[remote]\nbuffer = 200\nplayout = 50\n[animation]\nmixer = \"average\"\n");
  const PlayerOptions given = parsed({"host.example", "--playout", "20"});
  const WindowSettings settings(given, file_);
  const PlayerOptions options = settings.applied(given);
  EXPECT_EQ(options.playback.buffers.receiver_capacity, 200U);
  EXPECT_EQ(options.playback.buffers.playout_capacity, 20U);
  EXPECT_EQ(options.face.mixer, face::Mixer::Average);
  EXPECT_EQ(settings.in_force().remote.address, "host.example");
  EXPECT_TRUE(settings.in_force().recent.empty()) << "it has not answered yet";
}

TEST_F(WindowSettingsTest, TheFaceThatWasSavedIsTheNextStarts) {
  write("[face]\nfolder = \"/home/anna/faces/default\"\n");
  const PlayerOptions silent = parsed({});
  EXPECT_EQ(WindowSettings(silent, file_).applied(silent).face.face, "/home/anna/faces/default");
  const PlayerOptions named = parsed({"--face", "marek"});
  EXPECT_EQ(WindowSettings(named, file_).applied(named).face.face, "marek");
  const PlayerOptions headless = parsed({"--headless", "host"});
  EXPECT_EQ(WindowSettings(headless, file_).applied(headless).face.face, "default");
}

TEST_F(WindowSettingsTest, AnotherServerOfTheCommandLineHasNoStreamOfTheLastOne) {
  write("[remote]\naddress = \"old.example\"\nstream = \"lecture\"\ntls = true\n");
  EXPECT_EQ(WindowSettings(parsed({}), file_).in_force().remote.stream, "lecture");
  const WindowSettings settings(parsed({"new.example"}), file_);
  EXPECT_EQ(settings.in_force().remote.stream, "");
  EXPECT_FALSE(settings.in_force().remote.tls);
  const WindowSettings several(parsed({"aucast://new.example,other.example:7/talk"}), file_);
  EXPECT_EQ(gui::address_text(several.in_force().remote),
            "aucast://new.example,other.example:7/talk");
}

TEST_F(WindowSettingsTest, ATokenOfTheLastServerGoesToNoOther) {
  write("[remote]\naddress = \"old.example\"\ntoken_file = \"/home/anna/token\"\n");
  EXPECT_EQ(WindowSettings(parsed({}), file_).in_force().remote.token_file, "/home/anna/token");
  EXPECT_EQ(WindowSettings(parsed({"new.example"}), file_).in_force().remote.token_file, "");
}

TEST_F(WindowSettingsTest, FilesOfTheCommandLineComeBeforeKeptOnes) {
  write("[remote]\ntls = true\ntls_ca = \"/old/ca.pem\"\ntoken_file = \"/old/token\"\n");
  WindowSettings settings(parsed({"--tls", "--tls-ca", "ca.pem", "--token-file", "token"}), file_);
  EXPECT_EQ(settings.in_force().remote.authorities_file, "") << "as the command line says";
  EXPECT_EQ(settings.in_force().remote.token_file, "");
  gui::KeptSettings now = settings.in_force();
  now.transition.frames = 60;
  ASSERT_TRUE(settings.keep(now));
  EXPECT_EQ(on_disk().remote.authorities_file, "/old/ca.pem");
}

TEST_F(WindowSettingsTest, TheSecondOfSeveralHostsIsTriedWithoutBeingKept) {
  const PlayerOptions given = parsed({"aucast://one.example,other.example/talk"});
  WindowSettings settings(given, file_);
  EXPECT_TRUE(settings.applied(given).playback.reconnect) << "else the second is never tried";
  EXPECT_FALSE(settings.in_force().remote.reconnect) << "the form's box is the user's";
  gui::KeptSettings now = settings.in_force();
  now.transition.frames = 60;
  ASSERT_TRUE(settings.keep(now));
  EXPECT_FALSE(on_disk().remote.reconnect);
}

TEST_F(WindowSettingsTest, TheVolumeOfTheCommandLineComesBeforeTheKeptOne) {
  write("[sound]\nvolume = 96\n");
  EXPECT_EQ(WindowSettings(parsed({}), file_).in_force().volume, 96);
  WindowSettings settings(parsed({"--volume", "40"}), file_);
  EXPECT_EQ(settings.in_force().volume, 40);
  gui::KeptSettings now = settings.in_force();
  now.transition.frames = 60;
  ASSERT_TRUE(settings.keep(now));
  EXPECT_EQ(on_disk().volume, 96);
}

TEST_F(WindowSettingsTest, HowFarBehindIsKeptAndSaidByTheCommandLine) {
  write("[remote]\nbehind = \"time\"\nbehind_ms = 150\n");
  const auto buffers = [](const WindowSettings& settings, const PlayerOptions& given) {
    return settings.applied(given).playback.buffers;
  };
  const PlayerOptions plain = parsed({"host.example"});
  WindowSettings settings(plain, file_);
  EXPECT_TRUE(buffers(settings, plain).by_time);
  EXPECT_FALSE(buffers(settings, plain).adapt);
  EXPECT_EQ(buffers(settings, plain).live_delay, Milliseconds(150));
  const PlayerOptions live = parsed({"--live", "host.example"});
  WindowSettings low(live, file_);
  EXPECT_EQ(low.in_force().remote.behind, gui::Behind::Live);
  EXPECT_TRUE(buffers(low, live).low_delay);
  EXPECT_FALSE(buffers(low, live).by_time);
  gui::KeptSettings now = low.in_force();
  now.transition.frames = 60;
  ASSERT_TRUE(low.keep(now));
  EXPECT_EQ(on_disk().remote.behind, gui::Behind::Time);
  const PlayerOptions automatic = parsed({"--buffer", "auto", "host.example"});
  WindowSettings needed(automatic, file_);
  EXPECT_EQ(needed.in_force().remote.behind, gui::Behind::Auto);
  EXPECT_TRUE(buffers(needed, automatic).by_time);
  EXPECT_TRUE(buffers(needed, automatic).adapt);
  const PlayerOptions fixed = parsed({"--live-delay", "80", "host.example"});
  EXPECT_FALSE(buffers(WindowSettings(fixed, file_), fixed).by_time) << "the option comes first";
  EXPECT_EQ(buffers(WindowSettings(fixed, file_), fixed).live_delay, Milliseconds(80));
  const PlayerOptions sets = parsed({"--buffer", "80", "host.example"});
  EXPECT_FALSE(buffers(WindowSettings(sets, file_), sets).by_time);
}

TEST_F(WindowSettingsTest, HeadlessKnowsNothingOfThem) {
  write("[remote]\nbuffer = 200\n");
  const PlayerOptions given = parsed({"--headless", "host.example"});
  EXPECT_EQ(WindowSettings(given, file_).applied(given).playback.buffers.receiver_capacity, 100U);
}

TEST_F(WindowSettingsTest, WhatOnlyTheCommandLineAskedForIsNotKept) {
  write("[remote]\nbuffer = 200\n");
  WindowSettings settings(parsed({"--buffer", "300", "--mixer", "average"}), file_);
  gui::KeptSettings now = settings.in_force();
  EXPECT_EQ(now.remote.buffer, 300);
  now.transition.frames = 60;
  ASSERT_TRUE(settings.keep(now));
  EXPECT_EQ(on_disk().remote.buffer, 200);
  EXPECT_EQ(on_disk().animation.mixer, face::Mixer::Maximum);
  EXPECT_EQ(on_disk().transition.frames, 60);
  // Changed in the window, it is the user's wish for the next time too.
  now.remote.buffer = 400;
  ASSERT_TRUE(settings.keep(now));
  EXPECT_EQ(on_disk().remote.buffer, 400);
}

TEST_F(WindowSettingsTest, TheServerOfTheCommandLineIsKeptOnceItHasAnswered) {
  write("[remote]\naddress = \"old.example\"\nstream = \"lecture\"\ntoken_file = \"secret\"\n");
  const gui::KeptSettings before = on_disk();
  WindowSettings settings(parsed({"mistyped.example"}), file_);
  gui::KeptSettings now = settings.in_force();
  now.transition.frames = 60;
  ASSERT_TRUE(settings.keep(now));
  EXPECT_EQ(on_disk().transition.frames, 60);
  EXPECT_EQ(on_disk().remote, before.remote);
  now.recent = {"mistyped.example"};
  ASSERT_TRUE(settings.keep(now));
  EXPECT_EQ(on_disk().remote.address, "mistyped.example");
  EXPECT_EQ(on_disk().remote.token_file, "");
}

TEST_F(WindowSettingsTest, NothingIsWrittenWhenNothingChanged) {
  WindowSettings settings(parsed({}), file_);
  ASSERT_TRUE(settings.keep(settings.in_force()));
  EXPECT_FALSE(std::filesystem::exists(file_));
}

TEST_F(WindowSettingsTest, ABrokenFileIsSaidAndKeptAside) {
  write("[remote]\nbuffer = many\n");
  WindowSettings settings(parsed({}), file_);
  EXPECT_NE(settings.complaint().find("face-player.toml:2:"), std::string::npos);
  gui::KeptSettings now = settings.in_force();
  now.transition.frames = 60;
  ASSERT_TRUE(settings.keep(now));
  EXPECT_EQ(on_disk().transition.frames, 60);
  EXPECT_TRUE(std::filesystem::exists(folder_.path() / "face-player.toml.broken"));
}

TEST_F(WindowSettingsTest, ASettingThatIsWrongIsSaidAndTheOthersAreUsed) {
  write("[remote]\nbuffer = 0\nprot = 1\n[sound]\nvolume = 40\n");
  const WindowSettings settings(parsed({}), file_);
  EXPECT_EQ(settings.in_force().volume, 40);
  EXPECT_NE(settings.complaint().find("face-player.toml:2:"), std::string::npos);
  EXPECT_NE(settings.complaint().find("(and 1 more); the usual settings are used"),
            std::string::npos)
      << settings.complaint();
  EXPECT_TRUE(std::filesystem::exists(file_));
}

TEST_F(WindowSettingsTest, AFullOrReadOnlyPlaceIsSaid) {
  WindowSettings settings(parsed({}), "/proc/nowhere/face-player.toml");
  gui::KeptSettings now = settings.in_force();
  now.transition.frames = 60;
  const auto kept = settings.keep(now);
  ASSERT_FALSE(kept);
  EXPECT_NE(kept.error().message.find("/proc/nowhere"), std::string::npos);
}

TEST_F(WindowSettingsTest, NoConfigReadsAndWritesNothing) {
  EXPECT_TRUE(parsed({}).config);
  const PlayerOptions options = parsed({"--no-config"});
  EXPECT_FALSE(options.config);
  ASSERT_EQ(::setenv("XDG_CONFIG_HOME", folder_.path().c_str(), 1), 0);
  std::filesystem::create_directories(folder_.path() / "aucast");
  file_ = folder_.path() / "aucast" / "face-player.toml";
  write("[remote]\nbuffer = 200\n");
  EXPECT_EQ(WindowSettings::load(parsed({})).in_force().remote.buffer, 200);
  WindowSettings settings = WindowSettings::load(options);
  EXPECT_EQ(settings.in_force(), gui::KeptSettings{});
  gui::KeptSettings now;
  now.remote.buffer = 7;
  now.remote.playout = 7;
  ASSERT_TRUE(settings.keep(now));
  EXPECT_EQ(on_disk().remote.buffer, 200);
  ASSERT_EQ(::unsetenv("XDG_CONFIG_HOME"), 0);
}

}  // namespace
}  // namespace aucast::app

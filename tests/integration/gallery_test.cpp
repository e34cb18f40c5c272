// face-player gallery as a program; needs OpenGL (in software will do).

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>

#include <gtest/gtest.h>

#include "client/view/image.h"
#include "tests/integration/player_run.h"
#include "tests/support/eventually.h"
#include "tests/support/fake_ffmpeg.h"

namespace aucast::test {
namespace {

/// All files below a folder, with '/'.
std::vector<std::string> files_below(const std::filesystem::path& folder) {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) {
      files.push_back(std::filesystem::relative(entry.path(), folder).generic_string());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// The first field of each line but the names'.
std::vector<std::string> files_in_manifest(const std::string& manifest) {
  std::vector<std::string> files;
  for (std::size_t at = manifest.find("\r\n"); at + 2 < manifest.size();
       at = manifest.find("\r\n", at + 2)) {
    files.push_back(manifest.substr(at + 2, manifest.find(',', at) - at - 2));
  }
  std::sort(files.begin(), files.end());
  return files;
}

TEST(Gallery, TwoRunsAreByteIdenticalAndTheManifestNamesEveryPicture) {
  const TempFolder folder;
  for (const char* name : {"one", "two"}) {
    const PlayerRun run = run_player({"gallery", (folder.path() / name).string(), "--only",
                                      "appendix-b,sweeps", "--sweep", "12", "--size", "48x60"});
    ASSERT_EQ(run.finished.exit_code, 0) << run.finished.err;
    EXPECT_NE(run.finished.out.find("pictures"), std::string::npos);
  }
  const auto files = files_below(folder.path() / "one");
  ASSERT_EQ(files, files_below(folder.path() / "two"));
  for (const std::string& file : files) {
    EXPECT_TRUE(folder.read("one/" + file) == folder.read("two/" + file)) << file;
  }
  auto listed = files_in_manifest(folder.read("one/manifest.csv"));
  EXPECT_TRUE(std::find(listed.begin(), listed.end(), "prototypes/waters-fear.png") !=
              listed.end());
  EXPECT_TRUE(std::find(listed.begin(), listed.end(), "sweeps/au12/frame_000041.png") !=
              listed.end());
  listed.insert(listed.end(), {"index.html", "manifest.csv"});
  std::sort(listed.begin(), listed.end());
  EXPECT_EQ(listed, files);
  EXPECT_TRUE(folder.read("one/appendix_b/fear_average_none.png") !=
              folder.read("one/appendix_b/anger_average_none.png"));
}

TEST(Gallery, WithoutFfmpegTheFramesAreEnough) {
  const TempFolder folder;
  const PlayerRun run = run_player({"gallery", (folder.path() / "g").string(), "--only", "sweeps",
                                    "--sweep", "12", "--size", "16x20"},
                                   {"PATH=" + folder.path().string()});
  EXPECT_EQ(run.finished.exit_code, 0) << run.finished.err;
  EXPECT_NE(run.finished.err.find("install ffmpeg"), std::string::npos);
  EXPECT_EQ(run.finished.out.find("install ffmpeg"), std::string::npos);
  EXPECT_EQ(files_below(folder.path() / "g").size(), 41U + 2U);
}

TEST(Gallery, AFrameOfASweepSaysHowFarItIs) {
  const TempFolder folder;
  const PlayerRun run = run_player({"gallery", (folder.path() / "g").string(), "--only", "sweeps",
                                    "--sweep", "12", "--size", "16x20"},
                                   {"PATH=" + folder.path().string()});
  ASSERT_EQ(run.finished.exit_code, 0) << run.finished.err;
  const std::string frame = folder.read("g/sweeps/au12/frame_000008.png");
  for (const std::string& text :
       {std::string("AUs\00012", 6), std::string("Strength\00044.8 %", 15),
        std::string("Time\000280 ms", 11)}) {
    EXPECT_NE(frame.find(text), std::string::npos) << text;
  }
}

TEST(Gallery, MadeQuietlyTheSentenceAtItsEndSaysThatVideosAreMissing) {
  const TempFolder folder;
  const PlayerRun run = run_player({"gallery", (folder.path() / "g").string(), "--only", "sweeps",
                                    "--sweep", "12", "--size", "16x20", "--quiet"},
                                   {"PATH=" + folder.path().string()});
  EXPECT_EQ(run.finished.exit_code, 0) << run.finished.err;
  EXPECT_EQ(run.finished.err.find("ffmpeg"), std::string::npos) << run.finished.err;
  EXPECT_NE(run.finished.out.find("; no videos of the sweeps: install ffmpeg for them\n"),
            std::string::npos)
      << run.finished.out;
}

TEST(Gallery, StoppedInTheMiddleItSaysSoAndLeavesNothingHalfWritten) {
  const TempFolder folder;
  const auto gallery = folder.path() / "g";
  for (const int signal : {SIGINT, SIGTERM}) {
    Process player({program("face-player"), "gallery", gallery.string(), "--only", "sweeps",
                    "--sweep", "all", "--size", "48x60"});
    const auto some = gallery / "sweeps" / "au01" / "frame_000005.png";
    EXPECT_TRUE(eventually([&] { return std::filesystem::exists(some); }));
    player.signal(signal);
    EXPECT_EQ(player.wait(std::chrono::seconds(30)), 1);
    EXPECT_NE(player.err().find("stopped after "), std::string::npos) << player.err();
    EXPECT_FALSE(files_below(gallery).empty());
    for (const std::string& file : files_below(gallery)) {
      EXPECT_TRUE(file.ends_with(".mp4") || view::read_png(gallery / file).has_value()) << file;
    }
    std::filesystem::remove_all(gallery);
  }
}

TEST(Gallery, AStuckFfmpegDoesNotKeepTheUserWaiting) {
  const TempFolder folder;
  const auto gallery = folder.path() / "g";
  // It takes all pictures, and does not end.
  const FakeFfmpeg fake("cat > /dev/null; exec sleep 1000");
  Process player({program("face-player"), "gallery", gallery.string(), "--only", "sweeps",
                  "--sweep", "12", "--size", "48x60"});
  const auto last = gallery / "sweeps" / "au12" / "frame_000041.png";
  EXPECT_TRUE(eventually([&] { return std::filesystem::exists(last); }));
  player.signal(SIGINT);
  EXPECT_EQ(player.wait(std::chrono::seconds(60)), 1);
  EXPECT_NE(player.err().find("stopped after 4"), std::string::npos) << player.err();
  for (const std::string& file : files_below(gallery)) {
    EXPECT_TRUE(file.ends_with(".png")) << file;
  }
}

TEST(Gallery, NeverWritesOverItsRules) {
  const TempFolder folder;
  const auto rules = folder.write("rules.toml", folder.read(program("data/rules/facs.toml")));
  std::filesystem::create_directory(folder.path() / "g");
  std::filesystem::create_hard_link(rules, folder.path() / "g" / "index.html");
  const PlayerRun run = run_player({"gallery", (folder.path() / "g").string(), "--only", "coverage",
                                    "--size", "16x20", "--rules", rules.string()});
  EXPECT_EQ(run.finished.exit_code, 2) << run.finished.err;
  EXPECT_NE(run.finished.err.find(" would be written over "), std::string::npos)
      << run.finished.err;
}

TEST(Gallery, TheBackgroundIsTheOneThatWasAskedFor) {
  const TempFolder folder;
  const auto file = folder.path() / "pose.png";
  const PlayerRun run = run_player(
      {"pose", "0", "--png", file.string(), "--size", "48x60", "--background", "D08040"});
  ASSERT_EQ(run.finished.exit_code, 0) << run.finished.err;
  const auto picture = view::read_png(file);
  ASSERT_TRUE(picture.has_value());
  EXPECT_NEAR(picture->rgba[0], 0xD0, 1);
  EXPECT_NEAR(picture->rgba[1], 0x80, 1);
  EXPECT_NEAR(picture->rgba[2], 0x40, 1);
}

TEST(Gallery, WithoutABackgroundThePictureIsTransparentThere) {
  const TempFolder folder;
  const auto file = folder.path() / "pose.png";
  const PlayerRun run =
      run_player({"pose", "12", "--png", file.string(), "--size", "48x60", "--background", "none"});
  ASSERT_EQ(run.finished.exit_code, 0) << run.finished.err;
  const auto picture = view::read_png(file);
  ASSERT_TRUE(picture.has_value());
  EXPECT_EQ(picture->rgba[3], 0) << "a corner";
  const std::size_t nose = 4 * (30 * 48 + 24);
  EXPECT_EQ(picture->rgba[nose + 3], 255);
  EXPECT_GT(picture->rgba[nose], picture->rgba[nose + 2]) << "skin is red rather than blue";
}

TEST(Gallery, AFolderThatCannotBeMadeFails) {
  const TempFolder folder;
  const auto file = folder.write("file", "x");
  const PlayerRun run =
      run_player({"gallery", (file / "g").string(), "--only", "coverage", "--size", "16x20"});
  EXPECT_EQ(run.finished.exit_code, 1);
  EXPECT_NE(run.finished.err.find("cannot be written"), std::string::npos) << run.finished.err;
}

TEST(Gallery, UnknownSectionsSweepsAndFoldersAreUsageErrors) {
  const TempFolder folder;
  const std::string place = (folder.path() / "g").string();
  EXPECT_EQ(run_player({"gallery"}).finished.exit_code, 2);
  EXPECT_EQ(run_player({"gallery", place, "--only", "noses"}).finished.exit_code, 2);
  EXPECT_EQ(run_player({"gallery", place, "--sweep", "x"}).finished.exit_code, 2);
  EXPECT_EQ(run_player({"gallery", place, "--background", "red"}).finished.exit_code, 2);
  EXPECT_FALSE(std::filesystem::exists(place));
}

}  // namespace
}  // namespace aucast::test

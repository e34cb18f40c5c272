// Pictures and videos of the real face-player; needs OpenGL (in software will do).

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "client/view/image.h"
#include "tests/integration/player_run.h"
#include "tests/support/eventually.h"
#include "tests/support/served.h"

namespace aucast::test {
namespace {

std::vector<std::string> names_in(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

TEST(Pictures, TwoRunsAreByteIdenticalAndHaveFiftyAKeyframe) {
  const TempFolder folder;
  Served served({stream_file("six_expressions.txt")});
  for (const char* name : {"one", "two"}) {
    const PlayerRun run = run_player({"--headless", served.address(), "--fast", "--frames",
                                      (folder.path() / name).string(), "--size", "64x48"});
    ASSERT_EQ(run.finished.exit_code, 0) << run.finished.err;
    EXPECT_EQ(run.stats["frames_drawn"], 300);
  }
  const auto names = names_in(folder.path() / "one");
  ASSERT_EQ(names.size(), 300U);
  EXPECT_EQ(names.front(), "frame_000001.png");
  EXPECT_EQ(names.back(), "frame_000300.png");
  for (const std::string& name : names) {
    ASSERT_EQ(folder.read("one/" + name), folder.read("two/" + name)) << name;
  }
  EXPECT_NE(folder.read("one/frame_000001.png"), folder.read("one/frame_000050.png"));
}

TEST(Pictures, AtFpsTheyRunFromZeroToTheEnd) {
  const TempFolder folder;
  const PlayerRun run =
      run_player({"play", stream_file("six_expressions.txt"), "--headless", "--frames",
                  folder.path().string(), "--fps", "10", "--size", "32x32"});
  ASSERT_EQ(run.finished.exit_code, 0) << run.finished.err;
  EXPECT_EQ(names_in(folder.path()).size(), 16U);  // 0.0, 0.1 ... 1.5 s
}

TEST(Pictures, IdleLifeMovesAFaceThatIsStillWithoutItAndRepeatsItself) {
  const TempFolder folder;
  const std::string stream = folder.write("still.txt", "Beg_Stream\n0;3000\n0;3000\nEnd_Stream\n");
  const auto frames = [&](const std::string& name, std::vector<std::string> idle) {
    std::vector<std::string> arguments{"play",  stream, "--frames", (folder.path() / name).string(),
                                       "--fps", "2",    "--size",   "64x80"};
    arguments.insert(arguments.end(), idle.begin(), idle.end());
    const PlayerRun run = run_player(arguments);
    EXPECT_EQ(run.finished.exit_code, 0) << run.finished.err;
    std::vector<std::string> pictures;
    for (const std::string& file : names_in(folder.path() / name)) {
      pictures.push_back(folder.read(name + "/" + file));
    }
    return pictures;
  };
  const auto still = frames("still", {});
  ASSERT_EQ(still.size(), 13U);
  EXPECT_EQ(std::count(still.begin(), still.end(), still.front()),
            static_cast<std::ptrdiff_t>(still.size()));
  const auto alive = frames("alive", {"--idle", "3"});
  ASSERT_EQ(alive.size(), still.size());
  EXPECT_LT(std::count(alive.begin(), alive.end(), alive.front()), 3);
  EXPECT_EQ(frames("again", {"--idle", "3"}), alive);
}

TEST(Pictures, HairSwingsAfterTheHeadAtAnyRateAndComesToRest) {
  const TempFolder folder;
  const std::string stream = folder.write("turn.txt", "Beg_Stream\n51;400\n51;1000\nEnd_Stream\n");
  const auto frames = [&](const std::string& fps) {
    const PlayerRun run = run_player({"play", stream, "--frames", (folder.path() / fps).string(),
                                      "--fps", fps, "--size", "160x200"});
    EXPECT_EQ(run.finished.exit_code, 0) << run.finished.err;
    std::vector<std::string> pictures;
    for (const std::string& file : names_in(folder.path() / fps)) {
      pictures.push_back(folder.read(fps + "/" + file));
    }
    return pictures;
  };
  const auto seldom = frames("10");
  const auto often = frames("20");
  ASSERT_EQ(seldom.size(), 15U);  // 0.0, 0.1 ... 1.4 s
  ASSERT_EQ(often.size(), 29U);
  for (std::size_t i = 0; i < seldom.size(); ++i) EXPECT_EQ(seldom[i], often[2 * i]) << i;
  // The head stands from 0.4 s on, the hair from 1.0 s.
  EXPECT_NE(seldom[4], seldom[5]);
  EXPECT_NE(seldom[5], seldom[10]);
  EXPECT_EQ(seldom[10], seldom[14]);
}

TEST(Pictures, VideoAndSheetAreWritten) {
  const TempFolder folder;
  const auto video = folder.path() / "six.mp4";
  const PlayerRun run =
      run_player({"play", stream_file("six_expressions.txt"), "--record", video.string(), "--sheet",
                  (folder.path() / "six.png").string(), "--size", "64x64"});
  ASSERT_EQ(run.finished.exit_code, 0) << run.finished.err;
  EXPECT_EQ(run.stats["frames_drawn"], 46 + 6);
  EXPECT_EQ(names_in(folder.path()), (std::vector<std::string>{"six.mp4", "six.png"}));
  const Finished probe = test::run({"ffprobe", "-v", "error", "-count_frames", "-show_entries",
                                    "stream=nb_read_frames", "-of", "csv=p=0", video.string()});
  EXPECT_EQ(probe.out, "46\n") << probe.err;
}

TEST(Pictures, ASheetOfATalkIsAllThatIsDrawn) {
  const TempFolder folder;
  const PlayerRun run = run_player({"play", stream_file("talk.txt"), "--size", "40x30", "--sheet",
                                    (folder.path() / "talk.png").string()});
  ASSERT_EQ(run.finished.exit_code, 0) << run.finished.err;
  EXPECT_EQ(run.stats["frames_drawn"], 54);
}

TEST(Pictures, WithoutASizeASheetsPicturesAreSmall) {
  const TempFolder folder;
  const auto stream = folder.write("two.txt", "Beg_Stream\n12;40\n4;40\nEnd_Stream\n").string();
  const auto png = folder.path() / "two.png";
  for (const std::vector<std::string>& more :
       {std::vector<std::string>{}, {"--frames", folder.path().string(), "--fps", "1"}}) {
    std::vector<std::string> words{"play", stream, "--sheet", png.string()};
    words.insert(words.end(), more.begin(), more.end());
    const PlayerRun run = run_player(words);
    ASSERT_EQ(run.finished.exit_code, 0) << run.finished.err;
    const auto sheet = view::read_png(png);
    ASSERT_TRUE(sheet.has_value());
    EXPECT_EQ(sheet->width, 2 * 400 + 3 * 15) << "two pictures with gaps";
  }
}

TEST(Pictures, AnInterruptedVideoIsFinishedWithWhatThereIs) {
  for (const int number : {SIGINT, SIGHUP}) {
    const TempFolder folder;
    const TempFolder drawn;  // tells when there is something
    const auto video = folder.path() / "talk.mp4";
    Process player({program("face-player"), "play", stream_file("talk.txt"), "--record",
                    video.string(), "--frames", drawn.path().string(), "--fps", "25", "--size",
                    "64x64"});
    ASSERT_TRUE(test::eventually([&] { return names_in(drawn.path()).size() > 30; }))
        << player.err();
    player.signal(number);
    EXPECT_EQ(player.wait(std::chrono::seconds(60)), 0) << player.err();
    const Finished probe = test::run({"ffprobe", "-v", "error", "-show_entries", "format=duration",
                                      "-of", "csv=p=0", video.string()});
    EXPECT_EQ(probe.exit_code, 0) << probe.err;
    EXPECT_EQ(names_in(folder.path()), std::vector<std::string>{"talk.mp4"});
  }
}

TEST(Pictures, AVideoWithoutAPictureIsNotCalledWritten) {
  const TempFolder folder;
  const TempFolder drawn;
  const auto video = folder.path() / "talk.mp4";
  // All 50 pictures of a keyframe come before those of the video.
  Process player({program("face-player"), "play", stream_file("talk.txt"), "--record",
                  video.string(), "--frames", drawn.path().string(), "--size", "1024x1024"});
  ASSERT_TRUE(test::eventually([&] { return !names_in(drawn.path()).empty(); })) << player.err();
  player.signal(SIGINT);
  EXPECT_EQ(player.wait(std::chrono::seconds(60)), 0) << player.err();
  EXPECT_EQ(names_in(folder.path()), std::vector<std::string>{});
  EXPECT_EQ(player.err().find(video.string()), std::string::npos) << player.err();
}

TEST(Pictures, WithoutFfmpegTheMessageSaysWhatToInstall) {
  const TempFolder folder;
  const PlayerRun run = run_player({"play", stream_file("happiness.txt"), "--record",
                                    (folder.path() / "x.mp4").string(), "--size", "64x64"},
                                   {"PATH=" + folder.path().string()});
  EXPECT_EQ(run.finished.exit_code, 1);
  EXPECT_NE(run.finished.err.find("ffmpeg"), std::string::npos);
  EXPECT_NE(run.finished.err.find("install"), std::string::npos);
  EXPECT_TRUE(names_in(folder.path()).empty());
}

TEST(Pictures, AFolderThatCannotBeMade) {
  const TempFolder folder;
  const auto file = folder.write("file", "x");
  const PlayerRun run = run_player({"play", stream_file("happiness.txt"), "--frames",
                                    (file / "frames").string(), "--size", "64x64"});
  EXPECT_EQ(run.finished.exit_code, 1);
  EXPECT_NE(run.finished.err.find("cannot be written"), std::string::npos) << run.finished.err;
}

TEST(Pictures, APoseIsAPicture) {
  const TempFolder folder;
  const PlayerRun run = run_player(
      {"pose", "6,12", "--png", (folder.path() / "smile.png").string(), "--size", "64x64"});
  EXPECT_EQ(run.finished.exit_code, 0) << run.finished.err;
  EXPECT_TRUE(folder.read("smile.png").starts_with("\x89PNG"));
}

TEST(Pictures, APoseSaysInItsFileWhatItIs) {
  const TempFolder folder;
  const PlayerRun run = run_player({"pose", "12:40", "--mixer", "average", "--png",
                                    (folder.path() / "smile.png").string(), "--size", "64x64"});
  ASSERT_EQ(run.finished.exit_code, 0) << run.finished.err;
  const std::string png = folder.read("smile.png");
  for (const auto& [keyword, text] : std::vector<std::pair<std::string, std::string>>{
           {"AUs", "12:40"}, {"Rules", "facs"}, {"Mixer", "average"}, {"Camera", "front"}}) {
    EXPECT_NE(png.find(keyword + '\0' + text), std::string::npos) << keyword;
  }
  EXPECT_NE(png.find("left_zygomaticus_major=0."), std::string::npos);
}

}  // namespace
}  // namespace aucast::test

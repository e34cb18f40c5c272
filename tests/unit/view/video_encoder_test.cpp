#include "client/view/video_encoder.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/fake_ffmpeg.h"
#include "tests/support/image_difference.h"
#include "tests/support/process.h"
#include "tests/support/temp_folder.h"

namespace aucast::view {
namespace {

/// $PATH changed for as long as this lives.
class PathVariable {
 public:
  explicit PathVariable(const std::string& value) : before_(std::getenv("PATH")) {
    ::setenv("PATH", value.c_str(), 1);
  }
  ~PathVariable() { ::setenv("PATH", before_.c_str(), 1); }
  PathVariable(const PathVariable&) = delete;
  PathVariable& operator=(const PathVariable&) = delete;
  [[nodiscard]] const std::string& before() const { return before_; }

 private:
  std::string before_;
};

/// A picture with something that moves.
Image picture(int width, int height, int frame) {
  Image image = make_image(width, height, 0x305070);
  paste(image, make_image(width / 3, height / 3, 0xe0a040), frame * 2, frame);
  return image;
}

Result<void> write_video(const std::filesystem::path& path, int width, int height, int fps,
                         int frames) {
  auto encoder = VideoEncoder::open(path, width, height, fps);
  if (!encoder.has_value()) return encoder.error();
  for (int i = 0; i < frames; ++i) {
    const auto added = (*encoder)->add(picture(width, height, i));
    if (!added.has_value()) return added;
  }
  return (*encoder)->finish();
}

std::string probed(const std::filesystem::path& path, const std::string& entries) {
  const auto result = test::run({"ffprobe", "-v", "error", "-count_frames", "-show_entries",
                                 "stream=" + entries, "-of", "csv=p=0", path.string()});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  std::string line = result.out;
  while (!line.empty() && (line.back() == '\n' || line.back() == ',')) line.pop_back();
  return line;
}

std::size_t files_in(const test::TempFolder& folder) {
  return static_cast<std::size_t>(
      std::distance(std::filesystem::directory_iterator(folder.path()), {}));
}

/// A folder with a program called ffmpeg that does what the script says.
TEST(VideoEncoder, WritesEachKind) {
  const test::TempFolder folder;
  const struct {
    const char* name;
    const char* codec;
  } kinds[]{{"a.mp4", "h264"}, {"a.webm", "vp9"}, {"A.GIF", "gif"}};
  for (const auto& kind : kinds) {
    const auto file = folder.path() / kind.name;
    const auto done = write_video(file, 64, 48, 25, 10);
    ASSERT_TRUE(done.has_value()) << done.error().message;
    EXPECT_EQ(probed(file, "codec_name,width,height,r_frame_rate,nb_read_frames"),
              std::string(kind.codec) + ",64,48,25/1,10");
  }
  EXPECT_EQ(probed(folder.path() / "a.mp4", "pix_fmt"), "yuv420p");
  EXPECT_EQ(files_in(folder), 3U);
}

TEST(VideoEncoder, GivesTheSameBytesTwice) {
  const test::TempFolder folder;
  for (const std::string ending : {".mp4", ".webm", ".gif"}) {
    ASSERT_TRUE(write_video(folder.path() / ("a" + ending), 128, 96, 30, 40).has_value());
    ASSERT_TRUE(write_video(folder.path() / ("b" + ending), 128, 96, 30, 40).has_value());
    EXPECT_FALSE(folder.read("a" + ending).empty());
    EXPECT_TRUE(folder.read("a" + ending) == folder.read("b" + ending)) << ending;
  }
}

TEST(VideoEncoder, LetsAnOddSizeGrowByOne) {
  const test::TempFolder folder;
  ASSERT_TRUE(write_video(folder.path() / "a.mp4", 65, 49, 25, 3).has_value());
  EXPECT_EQ(probed(folder.path() / "a.mp4", "width,height"), "66,50");
  ASSERT_TRUE(write_video(folder.path() / "a.webm", 64, 49, 25, 3).has_value());
  EXPECT_EQ(probed(folder.path() / "a.webm", "width,height"), "64,50");
  ASSERT_TRUE(write_video(folder.path() / "a.gif", 65, 49, 25, 3).has_value());
  EXPECT_EQ(probed(folder.path() / "a.gif", "width,height"), "65,49");
}

TEST(VideoEncoder, SlowsAGifDownToFiftyASecond) {
  const test::TempFolder folder;
  ASSERT_TRUE(write_video(folder.path() / "a.gif", 32, 32, 200, 40).has_value());
  EXPECT_EQ(probed(folder.path() / "a.gif", "nb_read_frames"), "10");
}

TEST(VideoEncoder, KeepsColoursAsTheyWere) {
  const test::TempFolder folder;
  const auto file = folder.path() / "a.mp4";
  auto encoder = VideoEncoder::open(file, 64, 64, 25);
  ASSERT_TRUE(encoder.has_value());
  const Image skin = make_image(64, 64, 0xd8a890);
  for (int i = 0; i < 5; ++i) ASSERT_TRUE((*encoder)->add(skin).has_value());
  ASSERT_TRUE((*encoder)->finish().has_value());
  EXPECT_EQ(probed(file, "color_range,color_space,color_transfer,color_primaries"),
            "tv,bt709,bt709,bt709");
  const auto still = folder.path() / "still.png";
  ASSERT_EQ(
      test::run({"ffmpeg", "-v", "error", "-i", file.string(), "-frames:v", "1", still.string()})
          .exit_code,
      0);
  const auto back = read_png(still);
  ASSERT_TRUE(back.has_value());
  EXPECT_LE(test::compare(skin, *back, 255).largest, 4);
}

TEST(VideoEncoder, TakesNamesThatFfmpegWouldMisread) {
  const test::TempFolder folder;
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(folder.path());
  for (const char* name : {"-y.mp4", "tcp:1.mp4", "two words.gif", "100%d.webm"}) {
    const auto done = write_video(name, 32, 32, 25, 2);
    EXPECT_TRUE(done.has_value()) << done.error().message;
    EXPECT_TRUE(std::filesystem::exists(folder.path() / name)) << name;
  }
  std::filesystem::current_path(before);
  EXPECT_EQ(files_in(folder), 4U);
}

TEST(VideoEncoder, RefusesWhatCannotBeAVideo) {
  const test::TempFolder folder;
  const auto refused = [&folder](const char* name, int width, int height, int fps) {
    const auto encoder = VideoEncoder::open(folder.path() / name, width, height, fps);
    EXPECT_FALSE(encoder.has_value());
    if (encoder.has_value()) return std::string();
    EXPECT_EQ(encoder.error().kind, ErrorKind::Usage);
    return encoder.error().message;
  };
  for (const char* name : {"a.avi", "a", "mp4", "a.mp4.txt"}) {
    EXPECT_NE(refused(name, 64, 48, 25).find(".mp4, .webm or .gif"), std::string::npos) << name;
  }
  for (const int side : {0, -1, 8193}) {
    EXPECT_NE(refused("a.mp4", side, 48, 25).find("not possible"), std::string::npos);
    EXPECT_NE(refused("a.mp4", 64, side, 25).find("not possible"), std::string::npos);
  }
  for (const int fps : {0, -5, 241}) {
    EXPECT_NE(refused("a.mp4", 64, 48, fps).find("1 to 240"), std::string::npos);
  }
  EXPECT_EQ(files_in(folder), 0U);
}

TEST(VideoEncoder, SaysAtOnceThatThePlaceCannotBeWritten) {
  const test::TempFolder folder;
  const auto missing = VideoEncoder::open(folder.path() / "none" / "a.mp4", 64, 48, 25);
  ASSERT_FALSE(missing.has_value());
  EXPECT_EQ(missing.error().kind, ErrorKind::Failed);
  EXPECT_NE(missing.error().message.find("a.mp4: cannot be written: No such file"),
            std::string::npos)
      << missing.error().message;

  ASSERT_TRUE(std::filesystem::create_directory(folder.path() / "b.mp4"));
  const auto directory = VideoEncoder::open(folder.path() / "b.mp4", 64, 48, 25);
  ASSERT_FALSE(directory.has_value());
  EXPECT_NE(directory.error().message.find("it is a folder"), std::string::npos);
}

TEST(VideoEncoder, SaysWhatToInstallWhenThereIsNoFfmpeg) {
  const test::TempFolder folder;
  const test::TempFolder empty;
  const PathVariable path(empty.path().string());
  const auto encoder = VideoEncoder::open(folder.path() / "a.mp4", 64, 48, 25);
  ASSERT_FALSE(encoder.has_value());
  EXPECT_EQ(encoder.error().kind, ErrorKind::Failed);
  EXPECT_NE(encoder.error().message.find("apt install ffmpeg"), std::string::npos);
  EXPECT_EQ(files_in(folder), 0U);
}

TEST(VideoEncoder, ReportsTheLastWordsOfADyingFfmpeg) {
  const test::TempFolder folder;
  const test::FakeFfmpeg fake("echo 'no room\033[2J left' >&2; exit 9");
  auto encoder = VideoEncoder::open(folder.path() / "a.mp4", 640, 480, 25);
  ASSERT_TRUE(encoder.has_value());
  Result<void> result;
  for (int i = 0; i < 100 && result.has_value(); ++i) {
    result = (*encoder)->add(picture(640, 480, i));
  }
  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().kind, ErrorKind::Failed);
  EXPECT_NE(result.error().message.find("ffmpeg ended with code 9: no room\\x1b[2J left"),
            std::string::npos)
      << result.error().message;
  // It stays with what it said.
  EXPECT_EQ((*encoder)->add(picture(640, 480, 0)).error(), result.error());
  EXPECT_EQ((*encoder)->finish().error(), result.error());
  EXPECT_EQ(files_in(folder), 0U);
}

void expect_hung(const Result<void>& done, const test::TempFolder& folder) {
  ASSERT_FALSE(done.has_value());
  EXPECT_TRUE(
      done.error().message.ends_with("a.mp4: ffmpeg hung and was killed when the video was to end"))
      << done.error().message;
  EXPECT_EQ(files_in(folder), 0U);
}

TEST(VideoEncoder, IsNotKeptWaitingByAHungFfmpegWhenTheUserStops) {
  const test::TempFolder folder;
  const test::FakeFfmpeg fake("sleep 60");
  auto encoder = VideoEncoder::open(
      folder.path() / "a.mp4", 2048, 2048, 25, [] { return true; }, Milliseconds(200));
  ASSERT_TRUE(encoder.has_value());
  const auto begin = std::chrono::steady_clock::now();
  const auto added = (*encoder)->add(picture(2048, 2048, 0));
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(30));
  expect_hung(added, folder);
}

TEST(VideoEncoder, ReportsAnFfmpegThatFailsAtTheEnd) {
  const test::TempFolder folder;
  const test::FakeFfmpeg fake("cat > /dev/null; kill -9 $$");
  folder.write("a.mp4", "what was there before");
  const auto done = write_video(folder.path() / "a.mp4", 64, 48, 25, 2);
  ASSERT_FALSE(done.has_value());
  EXPECT_NE(done.error().message.find("killed by signal 9 and said nothing"), std::string::npos)
      << done.error().message;
  EXPECT_EQ(folder.read("a.mp4"), "what was there before");
  EXPECT_EQ(files_in(folder), 1U);
}

TEST(VideoEncoder, NamesTheLimitForTheSizeOfFilesThatEndedFfmpeg) {
  const test::TempFolder folder;
  const test::FakeFfmpeg fake("cat > /dev/null; kill -XFSZ $$");
  const auto done = write_video(folder.path() / "a.gif", 64, 48, 25, 2);
  ASSERT_FALSE(done.has_value());
  EXPECT_TRUE(done.error().message.ends_with(
      "a.gif: ffmpeg was killed: the video is larger than a file may be here (ulimit -f)"))
      << done.error().message;
  EXPECT_EQ(files_in(folder), 0U);
}

TEST(VideoEncoder, LeavesNothingBehindWhenTheSoundCannotBeAdded) {
  const test::TempFolder folder;
  const test::FakeFfmpeg fake(
      "case \"$*\" in *-map*) echo 'no room' >&2; exit 9;; esac; cat > /dev/null");
  auto encoder = VideoEncoder::open(folder.path() / "a.mp4", 64, 48, 25);
  ASSERT_TRUE(encoder.has_value());
  ASSERT_TRUE((*encoder)->add(picture(64, 48, 0)).has_value());
  const auto done = (*encoder)->finish(folder.path() / "sound.wav");
  ASSERT_FALSE(done.has_value());
  EXPECT_NE(done.error().message.find("no room"), std::string::npos) << done.error().message;
  EXPECT_EQ(files_in(folder), 0U);
  EXPECT_EQ((*encoder)->finish().error(), done.error());
}

/// Finishes a video with sound after the user has stopped, by an ffmpeg that does this.
Result<void> stopped_at_its_end(const test::TempFolder& folder, const std::string& script) {
  const test::FakeFfmpeg fake(script);
  auto encoder = VideoEncoder::open(
      folder.path() / "a.mp4", 64, 48, 25, [] { return true; }, Milliseconds(500));
  if (!encoder) return encoder.error();
  if (auto added = (*encoder)->add(picture(64, 48, 0)); !added) return added;
  return (*encoder)->finish(folder.path() / "sound.wav");
}

TEST(VideoEncoder, IsNotKeptWaitingByAnFfmpegThatHangsAtTheEnd) {
  for (const char* script : {"cat > /dev/null; exec sleep 1000",
                             "case \"$*\" in *-map*) exec sleep 1000;; esac; cat > /dev/null"}) {
    const test::TempFolder folder;
    const auto begin = std::chrono::steady_clock::now();
    const auto done = stopped_at_its_end(folder, script);
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(60));
    expect_hung(done, folder);
  }
}

TEST(VideoEncoder, WaitsForAnFfmpegThatWritesOnAfterTheUserHasStopped) {
  const test::TempFolder folder;
  // The name of the file to write is the last word; 25 times 100 ms are more than it may be idle.
  const auto done = stopped_at_its_end(
      folder,
      "cat > /dev/null; for file; do :; done; case \"$*\" in *-map*) n=25;; *) n=1;; esac; "
      "for i in $(seq $n); do echo x >> \"${file#file:}\"; sleep 0.1; done");
  EXPECT_TRUE(done.has_value()) << done.error().message;
  EXPECT_EQ(files_in(folder), 1U);
}

TEST(VideoEncoder, LeavesTheOldFileWhenAbandoned) {
  const test::TempFolder folder;
  folder.write("a.mp4", "what was there before");
  {
    auto encoder = VideoEncoder::open(folder.path() / "a.mp4", 64, 48, 25);
    ASSERT_TRUE(encoder.has_value());
    ASSERT_TRUE((*encoder)->add(picture(64, 48, 0)).has_value());
  }
  EXPECT_EQ(folder.read("a.mp4"), "what was there before");
  EXPECT_EQ(files_in(folder), 1U);
}

TEST(VideoEncoder, WritesNoFileWithoutPictures) {
  const test::TempFolder folder;
  EXPECT_TRUE(write_video(folder.path() / "a.mp4", 64, 48, 25, 0).has_value());
  EXPECT_EQ(files_in(folder), 0U);
}

}  // namespace
}  // namespace aucast::view

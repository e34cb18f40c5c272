#include "client/app/window/recording/video_recorder.h"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "client/app/window/recording/video_feed.h"
#include "tests/support/fake_ffmpeg.h"
#include "tests/support/manual_clock.h"
#include "tests/support/temp_folder.h"

namespace aucast::app {
namespace {

class VideoRecorderTest : public testing::Test {
 protected:
  VideoRecorder::Hooks hooks() {
    return {.new_file = [this] { return file_; },
            .hear = [this](const sound::SoundPlayer::Tap& tap) { heard_ = tap != nullptr; }};
  }
  Result<void> record(VideoRecorder& recorder) {
    const auto grey = [this](int width, int height) -> Result<view::Image> {
      ++pictures_;
      if (pictures_ > last_picture_) return Error{ErrorKind::Failed, "no picture"};
      return view::make_image(width, height);
    };
    return recorder.record(grey, clock_.now());
  }

  test::TempFolder folder_;
  test::ManualClock clock_;
  Result<std::filesystem::path> file_ = folder_.path() / "video.mp4";
  bool heard_ = false;
  int pictures_ = 0;
  int last_picture_ = 1000;
};

TEST_F(VideoRecorderTest, TheFileIsThereWhenTheVideoHasEnded) {
  VideoRecorder recorder(hooks());
  ASSERT_TRUE(record(recorder)) << "nothing runs";
  EXPECT_EQ(pictures_, 0);
  const auto begun = recorder.begin(64, 64, clock_.now());
  ASSERT_TRUE(begun) << begun.error().message;
  EXPECT_TRUE(recorder.running());
  const std::string name = recorder.view().recording;
  EXPECT_EQ(name, "video.mp4");
  EXPECT_TRUE(heard_);
  for (int frame = 0; frame < 10; ++frame) {
    ASSERT_TRUE(record(recorder));
    clock_.advance(Milliseconds(20));
  }
  EXPECT_EQ(pictures_, 5) << "one for each 40 ms";
  ASSERT_TRUE(recorder.end());
  EXPECT_FALSE(heard_);
  recorder.wait();
  const auto ended = *recorder.ended();
  ASSERT_TRUE(ended) << ended.error().message;
  EXPECT_NE(ended->find(name), std::string::npos) << *ended;
  EXPECT_TRUE(std::filesystem::exists(folder_.path() / name));
  EXPECT_FALSE(recorder.running());
  EXPECT_EQ(recorder.view(), gui::VideoView{});
  EXPECT_FALSE(recorder.ended()) << "said once";
}

TEST_F(VideoRecorderTest, AStalledProgramDoesNotMakeUpForAllThatItMissed) {
  const std::filesystem::path raw = folder_.path() / "raw";
  const test::FakeFfmpeg keeping("cat > '" + raw.string() + "'");
  VideoRecorder recorder(hooks());
  ASSERT_TRUE(recorder.begin(64, 64, clock_.now()));
  ASSERT_TRUE(record(recorder));
  clock_.advance(std::chrono::hours(10));
  ASSERT_TRUE(record(recorder));
  ASSERT_TRUE(recorder.end());
  recorder.wait();
  constexpr std::uintmax_t kPictures = 1 + VideoTime::kGapMax / Milliseconds(40);
  EXPECT_EQ(std::filesystem::file_size(raw), kPictures * 64 * 64 * 4);
}

TEST_F(VideoRecorderTest, ASlowFfmpegDoesNotHoldTheWindowUp) {
  const std::string may_read = (folder_.path() / "may_read").string();
  const std::filesystem::path bytes = folder_.path() / "bytes";
  const test::FakeFfmpeg slow("until [ -e '" + may_read + "' ]; do sleep 0.01; done; wc -c > '" +
                              bytes.string() + "'");
  VideoRecorder recorder(hooks());
  constexpr int kSide = 512;  // so that few pictures fit into the pipe
  ASSERT_TRUE(recorder.begin(kSide, kSide, clock_.now()));
  constexpr int kFrames = 100;
  for (int frame = 0; frame < kFrames; ++frame) {
    ASSERT_TRUE(record(recorder)) << "and it does not block";
    clock_.advance(Milliseconds(40));
  }
  EXPECT_LT(pictures_, 20) << "only a few wait";
  ASSERT_TRUE(recorder.end());
  folder_.write("may_read", "");
  recorder.wait();
  const auto ended = *recorder.ended();
  ASSERT_TRUE(ended) << ended.error().message;
  const std::string repeated = " " + std::to_string(kFrames - pictures_) + " of its pictures";
  EXPECT_NE(ended->find(repeated), std::string::npos) << *ended;
  EXPECT_EQ(std::stoi(folder_.read("bytes")), kFrames * kSide * kSide * 4)
      << "the video is as long as the time it shows";
}

TEST_F(VideoRecorderTest, AnAbandonedVideoDoesNotWaitForAFfmpegThatHangs) {
  const test::FakeFfmpeg hanging("while :; do sleep 0.01; done");
  constexpr int kSide = 512;  // more than fits into the pipe
  auto feed = VideoFeed::start(folder_.path() / "video.mp4", kSide, kSide, 25, Milliseconds(50));
  ASSERT_TRUE(feed);
  ASSERT_TRUE((*feed)->add(view::make_image(kSide, kSide), 1));
  feed->reset();
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path())) << "nothing is left behind";
}

TEST_F(VideoRecorderTest, AFailingFfmpegEndsTheVideo) {
  const test::FakeFfmpeg failing("echo 'no room' >&2; exit 9");
  VideoRecorder recorder(hooks());
  ASSERT_TRUE(recorder.begin(64, 64, clock_.now()));
  Result<void> recorded;
  while (recorded) {
    recorded = record(recorder);
    clock_.advance(Milliseconds(40));
  }
  EXPECT_NE(recorded.error().message.find("no room"), std::string::npos);
  EXPECT_FALSE(recorder.running());
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path())) << "nothing is left behind";
}

TEST_F(VideoRecorderTest, AVideoIsCompletedWhileTheWindowGoesOn) {
  const std::string may_end = (folder_.path() / "may_end").string();
  const test::FakeFfmpeg slow("cat > /dev/null; until [ -e '" + may_end +
                              "' ]; do sleep 0.01; done");
  VideoRecorder recorder(hooks());
  ASSERT_TRUE(recorder.begin(64, 64, clock_.now()));
  ASSERT_TRUE(record(recorder));
  const std::string name = recorder.view().recording;
  ASSERT_TRUE(recorder.end());
  EXPECT_FALSE(recorder.ended());
  EXPECT_EQ(recorder.view().recording, "");
  EXPECT_EQ(recorder.view().completing, name);
  EXPECT_FALSE(recorder.begin(64, 64, clock_.now())) << "it would have the same name";
  folder_.write("may_end", "");
  recorder.wait();
  const auto ended = recorder.ended();
  ASSERT_TRUE(ended);
  ASSERT_TRUE(*ended) << ended->error().message;
  EXPECT_EQ(recorder.view(), gui::VideoView{});
  EXPECT_TRUE(std::filesystem::exists(folder_.path() / name));
  EXPECT_TRUE(recorder.begin(64, 64, clock_.now()));
}

TEST_F(VideoRecorderTest, AVideoThatCannotBeCompletedIsSaid) {
  const test::FakeFfmpeg failing("cat > /dev/null; echo 'no room' >&2; exit 9");
  VideoRecorder recorder(hooks());
  ASSERT_TRUE(recorder.begin(64, 64, clock_.now()));
  ASSERT_TRUE(record(recorder));
  ASSERT_TRUE(recorder.end());
  recorder.wait();
  const auto ended = *recorder.ended();
  ASSERT_FALSE(ended);
  EXPECT_NE(ended.error().message.find("no room"), std::string::npos) << ended.error().message;
}

TEST_F(VideoRecorderTest, AVideoThatFailsIsOver) {
  VideoRecorder recorder(hooks());
  ASSERT_TRUE(recorder.begin(64, 64, clock_.now()));
  last_picture_ = 1;
  ASSERT_TRUE(record(recorder));
  clock_.advance(Milliseconds(40));
  EXPECT_EQ(record(recorder).error().message, "no picture");
  EXPECT_FALSE(recorder.running());
  EXPECT_EQ(recorder.view().recording, "");
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path())) << "nothing is left behind";
}

TEST_F(VideoRecorderTest, WhereNoFileCanBeNoneBegins) {
  file_ = Error{ErrorKind::Failed, "no folder"};
  VideoRecorder recorder(hooks());
  EXPECT_FALSE(recorder.begin(64, 64, clock_.now()).has_value());
  EXPECT_FALSE(recorder.running());
  EXPECT_FALSE(heard_);
}

}  // namespace
}  // namespace aucast::app

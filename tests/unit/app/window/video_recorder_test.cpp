#include "client/app/window/video_recorder.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "tests/support/temp_folder.h"
#include "tests/unit/app/window/window_session_fixture.h"

namespace aucast::app {
namespace {

class VideoRecorderTest : public SessionOnDefaultFace {
 protected:
  VideoRecorderTest() {
    session_.emplace(*assets_, options_, nullptr, stats_);
    gui::PictureSettings pictures;
    pictures.folder = folder_.path().string();
    session_->apply(gui::ChangePictures{pictures}, clock_.now());
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
  int pictures_ = 0;
  int last_picture_ = 1000;
};

TEST_F(VideoRecorderTest, TheFileIsThereWhenTheVideoHasEnded) {
  VideoRecorder recorder(*session_);
  ASSERT_TRUE(record(recorder)) << "nothing runs";
  EXPECT_EQ(pictures_, 0);
  const auto begun = recorder.begin(64, 64, clock_.now());
  ASSERT_TRUE(begun) << begun.error().message;
  EXPECT_TRUE(recorder.running());
  const std::string name = model().recording;
  EXPECT_TRUE(name.ends_with(".mp4")) << name;
  for (int frame = 0; frame < 10; ++frame) {
    ASSERT_TRUE(record(recorder));
    clock_.advance(Milliseconds(20));
  }
  EXPECT_EQ(pictures_, 5) << "one for each 40 ms";
  const auto ended = recorder.end();
  ASSERT_TRUE(ended) << ended.error().message;
  EXPECT_NE(ended->find(name), std::string::npos) << *ended;
  EXPECT_TRUE(std::filesystem::exists(folder_.path() / name));
  EXPECT_FALSE(recorder.running());
  EXPECT_EQ(model().recording, "");
}

TEST_F(VideoRecorderTest, AVideoThatFailsIsOver) {
  VideoRecorder recorder(*session_);
  ASSERT_TRUE(recorder.begin(64, 64, clock_.now()));
  last_picture_ = 1;
  ASSERT_TRUE(record(recorder));
  clock_.advance(Milliseconds(40));
  EXPECT_EQ(record(recorder).error().message, "no picture");
  EXPECT_FALSE(recorder.running());
  EXPECT_EQ(model().recording, "");
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path())) << "nothing is left behind";
}

TEST_F(VideoRecorderTest, WhereNoFolderCanBeNoneBegins) {
  gui::PictureSettings pictures;
  pictures.folder = folder_.write("file", "").string();
  session_->apply(gui::ChangePictures{pictures}, clock_.now());
  VideoRecorder recorder(*session_);
  EXPECT_FALSE(recorder.begin(64, 64, clock_.now()).has_value());
  EXPECT_FALSE(recorder.running());
}

}  // namespace
}  // namespace aucast::app

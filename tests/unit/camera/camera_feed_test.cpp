// What needs the models of scripts/install_models.sh says so when they are not there.
#include "common/camera/camera_feed.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "tests/support/eventually.h"
#include "tests/unit/camera/other_ffmpeg.h"

namespace aucast::camera {
namespace {

// Of the script of an ffmpeg: pictures of 16 x 16 pixels.
const std::string kHeader = "printf 'YUV4MPEG2 W16 H16 F25:1 C444\\n'; ";
const std::string kPicture = "printf 'FRAME\\n'; head -c 768 /dev/zero; ";

/// Reads rows to their end.
std::string read_all(const Descriptor& rows) {
  std::string text;
  std::vector<char> chunk(4096);
  for (;;) {
    pollfd wait{rows.get(), POLLIN, 0};
    const int ready = ::poll(&wait, 1, 30'000);
    EXPECT_EQ(ready, 1);
    const ssize_t got = ready == 1 ? ::read(rows.get(), chunk.data(), chunk.size()) : 0;
    if (got <= 0) return text;
    text.append(chunk.data(), static_cast<std::size_t>(got));
  }
}

class CameraFeedTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!load_face_models()) GTEST_SKIP() << "NOT RUN: the models are not installed";
  }
};

TEST_F(CameraFeedTest, PicturesWithoutAFaceAreRowsWithoutSuccess) {
  const OtherFfmpeg ffmpeg(kHeader + kPicture);
  std::vector<std::size_t> widths;  // by the other thread, as long as it lives
  auto feed = CameraFeed::start({.device = kDevice}, {}, [&widths](const Sight& sight) {
    EXPECT_EQ(sight.landmarks, nullptr);
    EXPECT_TRUE(sight.aus.empty());
    widths.push_back(sight.picture.width);
  });
  ASSERT_TRUE(feed.has_value()) << feed.error().message;
  const std::string text = read_all((*feed)->take_rows());
  EXPECT_TRUE(text.starts_with("aucast_seconds,"));
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2);
  EXPECT_NE(text.find(",0.000,0,"), std::string::npos);
  EXPECT_EQ((*feed)->complaint(), "");
  feed->reset();
  EXPECT_EQ(widths, std::vector<std::size_t>{16});
}

TEST_F(CameraFeedTest, EndsAtOnceWhileItsCameraGoesOn) {
  const OtherFfmpeg ffmpeg(kHeader + "while :; do " + kPicture + "done");
  auto feed = CameraFeed::start({.device = kDevice}, {});
  ASSERT_TRUE(feed.has_value()) << feed.error().message;
  feed->reset();
}

TEST_F(CameraFeedTest, SaysAtOnceWhyItsCameraWentAlsoWhenFfmpegHangs) {
  const OtherFfmpeg ffmpeg(kHeader + kPicture + "echo unplugged >&2; exec >&-; sleep 60");
  auto feed = CameraFeed::start({.device = kDevice}, {});
  ASSERT_TRUE(feed.has_value()) << feed.error().message;
  EXPECT_NE(read_all((*feed)->take_rows()), "");
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_EQ((*feed)->complaint(), "unplugged");
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(1));
}

TEST_F(CameraFeedTest, TakesNoMorePicturesWhenNobodyReadsItsRows) {
  OtherFfmpeg ffmpeg(kHeader + "while :; do " + kPicture + "echo on >> \"${0%/*}/pictures\"; done");
  const std::filesystem::path pictures = ffmpeg.file("pictures", "");
  auto feed = CameraFeed::start({.device = kDevice}, {});
  ASSERT_TRUE(feed.has_value()) << feed.error().message;
  { const Descriptor gone = (*feed)->take_rows(); }
  EXPECT_TRUE(test::eventually([&pictures] {
    const auto before = std::filesystem::file_size(pictures);
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    return std::filesystem::file_size(pictures) == before;
  }));
}

TEST_F(CameraFeedTest, CountsTheRowsThatFindNoRoom) {
  const OtherFfmpeg ffmpeg(kHeader + "while :; do " + kPicture + "done");
  auto feed = CameraFeed::start({.device = kDevice}, {});
  ASSERT_TRUE(feed.has_value()) << feed.error().message;
  const Descriptor rows = (*feed)->take_rows();
  EXPECT_EQ((*feed)->rows_left_out(), 0U);
  // The pipe is filled from here: as many rows would take a slow machine long.
  const std::string pipe = "/proc/self/fd/" + std::to_string(rows.get());
  const Descriptor other_end(::open(pipe.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC));
  while (::write(other_end.get(), "\n", 1) == 1) continue;
  EXPECT_TRUE(test::eventually([&feed] { return (*feed)->rows_left_out() > 0; }));
}

}  // namespace
}  // namespace aucast::camera

#include "client/app/window/recording/video_sound.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <vector>

#include "client/sound/sound_track.h"
#include "tests/support/temp_folder.h"

namespace aucast::app {
namespace {

using namespace std::chrono_literals;

constexpr Instant kBegin{100s};

/// The first and last sample of the file that are not silent, in ms; its length behind them.
std::vector<std::int64_t> sounding(const std::filesystem::path& wav) {
  std::ifstream file(wav, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(file)), {});
  std::vector<std::int64_t> marks{-1, -1, 0};
  const std::size_t count = (bytes.size() - 44) / 2;
  for (std::size_t i = 0; i < count; ++i) {
    if (bytes[44 + 2 * i] == 0 && bytes[45 + 2 * i] == 0) continue;
    if (marks[0] < 0) marks[0] = static_cast<std::int64_t>(i) / sound::kSamplesPerMs;
    marks[1] = static_cast<std::int64_t>(i + 1) / sound::kSamplesPerMs;
  }
  marks[2] = static_cast<std::int64_t>(count) / sound::kSamplesPerMs;
  return marks;
}

class VideoSoundTest : public testing::Test {
 protected:
  void SetUp() override {
    auto sound = VideoSound::open(folder_.path() / "video.mp4", kBegin);
    ASSERT_TRUE(sound);
    sound_ = std::move(*sound);
  }
  void hear(Duration at, int ms, float level = 0.5F) {
    const std::vector<float> samples(static_cast<std::size_t>(ms * sound::kSamplesPerMs), level);
    sound_->add(kBegin + at, samples);
  }
  std::vector<std::int64_t> written() { return sounding(*sound_->file()); }

  test::TempFolder folder_;
  std::unique_ptr<VideoSound> sound_;
};

TEST_F(VideoSoundTest, NothingThatSoundsIsNoFile) {
  EXPECT_EQ(*sound_->file(), std::filesystem::path());
}

TEST_F(VideoSoundTest, SoundGoesToWhereItIsHeard) {
  hear(1500ms, 100);
  hear(1600ms, 100);
  EXPECT_EQ(written(), (std::vector<std::int64_t>{1500, 1700, 1700}));
}

TEST_F(VideoSoundTest, AClockThatLeapsALittleTearsNothing) {
  for (int i = 0; i < 50; ++i) hear(i * 10ms + (i % 2 == 0 ? 15ms : -15ms), 10);
  EXPECT_EQ(written(), (std::vector<std::int64_t>{15, 515, 515}));
}

TEST_F(VideoSoundTest, SaysThatSoundWasLeftOut) {
  constexpr std::size_t kRoom = std::size_t{300} * sound::kSamplesPerMs;
  auto small = VideoSound::open(folder_.path() / "small.mp4", kBegin, kRoom);
  ASSERT_TRUE(small);
  sound_ = std::move(*small);
  hear(0ms, 300);
  EXPECT_FALSE(sound_->cut()) << "it is full, and nothing is lost";
  hear(300ms, 10);
  EXPECT_TRUE(sound_->cut());
  EXPECT_EQ(written()[2], 300);
}

TEST_F(VideoSoundTest, APauseStaysAPauseAndWhatIsPastIsLeftOut) {
  hear(-50ms, 100);
  EXPECT_EQ(written()[1], 50) << "half of it was heard before the video began";
  hear(3000ms, 100);
  EXPECT_EQ(written(), (std::vector<std::int64_t>{0, 3100, 3100}));
  hear(2900ms, 300, 0.25F);
  EXPECT_EQ(written()[2], 3200) << "nothing is heard twice";
}

}  // namespace
}  // namespace aucast::app

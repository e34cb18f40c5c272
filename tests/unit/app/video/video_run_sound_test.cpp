#include "client/app/video/video_run_sound.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>

#include "client/playback/source_playback.h"
#include "tests/support/temp_folder.h"
#include "tests/unit/playback/scripted_source.h"

namespace aucast::app {
namespace {

using playback::SourcePlayback;

constexpr std::uintmax_t kHeaderBytes = 44;
constexpr std::uintmax_t kBytesPerMs = 2 * sound::kSamplesPerMs;
const std::string kTwentyMs(1, '\x48');  ///< an Opus packet

/// A run with a keyframe, a voice that the test puts in, and --sound.
class VideoRunSoundTest : public testing::Test {
 protected:
  VideoRunSoundTest() {
    auto source = std::make_unique<playback::test::ScriptedSource>();
    source_ = source.get();
    playback_ = std::make_unique<SourcePlayback>(std::move(source), SourcePlayback::Options{});
    sound_ = std::make_unique<VideoRunSound>(*playback_, nullptr, stop_);
    SoundOptions options;
    options.file = folder_.path() / "a.wav";
    EXPECT_TRUE(sound_->open(options, {}));
  }

  void keyframe(Milliseconds time) {
    playback::KeyframeBegun begun;
    begun.time = time;
    begun.target.place = time;
    begun.target.span = time;
    sound_->keyframe(begun, time.count());
  }
  [[nodiscard]] std::uintmax_t written_ms() {
    EXPECT_TRUE(sound_->finish());
    return (std::filesystem::file_size(folder_.path() / "a.wav") - kHeaderBytes) / kBytesPerMs;
  }

  test::TempFolder folder_;
  playback::test::ScriptedSource* source_ = nullptr;
  std::unique_ptr<SourcePlayback> playback_;
  int asked_ = 0;
  int stops_at_ = 0;  ///< which question is answered by "stop"; 0: none
  const std::function<bool()> stop_ = [this] { return ++asked_ == stops_at_; };
  std::unique_ptr<VideoRunSound> sound_;
};

TEST_F(VideoRunSoundTest, StopsWithinALongKeyframe) {
  stops_at_ = 4;
  keyframe(std::chrono::hours(1));
  EXPECT_EQ(written_ms(), 3000U);
}

TEST_F(VideoRunSoundTest, HasTheVoiceThatComesAfterTheLastKeyframe) {
  keyframe(Milliseconds(100));
  source_->voice.push_back({Milliseconds(500), kTwentyMs});
  ASSERT_EQ(sound_->tail_ms(), 420);
  sound_->tail(520);
  EXPECT_EQ(written_ms(), 520U);
}

TEST_F(VideoRunSoundTest, LeavesOutTheVoiceLongAfterTheLastKeyframe) {
  source_->voice.push_back({Milliseconds(40), kTwentyMs});
  source_->voice.push_back({Milliseconds(1'000'000'000'000), kTwentyMs});
  keyframe(Milliseconds(100));
  EXPECT_EQ(sound_->tail_ms(), 0);
  EXPECT_EQ(sound_->counts().left_out, 1U);
}

}  // namespace
}  // namespace aucast::app

#include "client/sound/file_track.h"

#include <gtest/gtest.h>

#include <cmath>

#include "client/sound/wav_file.h"
#include "common/voice/voice_encoder.h"
#include "tests/support/temp_folder.h"

namespace aucast::sound {
namespace {

using aucast::test::TempFolder;

TEST(FileTrack, ASampleOfTheFileStaysWhereItIs) {
  std::vector<float> samples(1000);
  samples[500] = 0.5F;
  FileTrack track(samples);
  EXPECT_EQ(track.end(), 3000);
  std::vector<float> heard(3000);
  track.read(0, heard);
  for (std::size_t i = 0; i < heard.size(); i += 3) {
    EXPECT_NEAR(heard[i], i == 1500 ? 0.5F : 0, 1e-4F) << i;
  }
}

TEST(FileTrack, AToneIsTheSameToneAtTheHigherRate) {
  constexpr double kHertz = 3000;
  const auto tone = [](double at) { return 0.5 * std::sin(2 * 3.14159265358979 * kHertz * at); };
  std::vector<float> samples(1600);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples[i] = static_cast<float>(tone(static_cast<double>(i) / voice::kEncoderRate));
  }
  FileTrack track(samples);
  std::vector<float> heard(3000);
  track.read(600, heard);
  for (std::size_t i = 0; i < heard.size(); ++i) {
    EXPECT_NEAR(heard[i], tone(static_cast<double>(i + 600) / kRate), 0.005) << i;
  }
}

TEST(FileTrack, IsSilentBeforeAndAfter) {
  FileTrack track(std::vector<float>(160, 0.5F));
  std::vector<float> heard(100, 1);
  track.read(-200, heard);
  for (const float sample : heard) EXPECT_EQ(sample, 0);
  track.read(600, heard);
  for (const float sample : heard) EXPECT_EQ(sample, 0);
}

TEST(FileTrack, ReadsAFileOfAnotherRate) {
  const TempFolder folder;
  auto file = WavFile::open(folder.path() / "a.wav");
  ASSERT_TRUE(file.has_value());
  (*file)->add(std::vector<float>(kRate, 0.25F));
  ASSERT_TRUE((*file)->finish().has_value());
  const auto track = FileTrack::open(folder.path() / "a.wav");
  ASSERT_TRUE(track.has_value());
  EXPECT_NEAR(static_cast<double>((*track)->end()), kRate, 10);
  std::vector<float> heard(100);
  (*track)->read(kRate / 2, heard);
  for (const float sample : heard) EXPECT_NEAR(sample, 0.25F, 0.01F);
}

TEST(SoundBeside, IsTheFileOfTheSameName) {
  const TempFolder folder;
  const auto stream = folder.write("talk.txt", "{12 100}\n");
  EXPECT_FALSE(sound_beside(stream).has_value());
  folder.write("talk.mp3", "x");
  EXPECT_EQ(sound_beside(stream), folder.path() / "talk.mp3");
  folder.write("talk.wav", "x");
  EXPECT_EQ(sound_beside(stream), folder.path() / "talk.wav");
}

}  // namespace
}  // namespace aucast::sound

#include "client/sound/file_track.h"

#include <gtest/gtest.h>
#include <sndfile.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "client/sound/wav_file.h"
#include "common/voice/voice_encoder.h"
#include "tests/support/temp_folder.h"

namespace aucast::sound {
namespace {

using aucast::test::TempFolder;

/// A track of a file with these samples, at the rate in which files are kept.
std::unique_ptr<FileTrack> track_of(const std::vector<float>& samples) {
  const TempFolder folder;
  const auto path = folder.path() / "a.wav";
  SF_INFO info{};
  info.samplerate = voice::kEncoderRate;
  info.channels = 1;
  info.format = SF_FORMAT_WAV | SF_FORMAT_PCM_16;
  SNDFILE* const file = sf_open(path.c_str(), SFM_WRITE, &info);
  sf_writef_float(file, samples.data(), static_cast<sf_count_t>(samples.size()));
  sf_close(file);
  auto track = FileTrack::open(path);
  EXPECT_TRUE(track.has_value());
  return track ? *std::move(track) : nullptr;
}

TEST(FileTrack, ASampleOfTheFileStaysWhereItIs) {
  const auto hump = [](double at) {
    const double away = (at - 500) / 8;
    return 0.5 * std::exp(-away * away);
  };
  std::vector<float> samples;
  for (int i = 0; i < 1000; ++i) samples.push_back(static_cast<float>(hump(i)));
  const auto track = track_of(samples);
  ASSERT_NE(track, nullptr);
  EXPECT_EQ(track->end(), 3000);
  std::vector<float> heard(3000);
  track->read(0, heard);
  for (std::size_t i = 0; i < heard.size(); ++i) {
    EXPECT_NEAR(heard[i], hump(static_cast<double>(i) / 3), 1e-3) << i;
  }
}

TEST(FileTrack, AToneIsTheSameToneAtTheHigherRate) {
  constexpr double kHertz = 3000;
  const auto tone = [](double at) { return 0.5 * std::sin(2 * 3.14159265358979 * kHertz * at); };
  std::vector<float> samples(1600);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples[i] = static_cast<float>(tone(static_cast<double>(i) / voice::kEncoderRate));
  }
  const auto track = track_of(samples);
  ASSERT_NE(track, nullptr);
  std::vector<float> heard(3000);
  track->read(600, heard);
  for (std::size_t i = 0; i < heard.size(); ++i) {
    EXPECT_NEAR(heard[i], tone(static_cast<double>(i + 600) / kRate), 0.005) << i;
  }
}

TEST(FileTrack, IsSilentBeforeAndAfter) {
  const auto track = track_of(std::vector<float>(160, 0.5F));
  ASSERT_NE(track, nullptr);
  std::vector<float> heard(100, 1);
  track->read(-200, heard);
  for (const float sample : heard) EXPECT_EQ(sample, 0);
  track->read(600, heard);
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

/// A file of `seconds` seconds, which rises from -1 to 1.
std::filesystem::path long_file(const TempFolder& folder, int seconds) {
  auto file = WavFile::open(folder.path() / "long.wav");
  EXPECT_TRUE(file.has_value());
  for (int i = 0; i < seconds; ++i) {
    const float level = 2.0F * static_cast<float>(i) / static_cast<float>(seconds) - 1;
    (*file)->add(std::vector<float>(kRate, level));
  }
  EXPECT_TRUE((*file)->finish().has_value());
  return folder.path() / "long.wav";
}

TEST(FileTrack, InTheBackgroundPlaysTheBeginningAtOnceAndTheRestAsItIsRead) {
  constexpr int kSeconds = 6;
  const TempFolder folder;
  const auto path = long_file(folder, kSeconds);
  const auto whole = FileTrack::open(path);
  ASSERT_TRUE(whole.has_value());
  const auto track = FileTrack::begin(path);
  ASSERT_TRUE(track.has_value());
  // A second is read within the call, and not the whole file, which would keep the window waiting.
  EXPECT_EQ((*track)->end(), kRate);
  std::vector<float> heard(100);
  std::vector<float> wanted(100);
  (*track)->read(kRate / 2, heard);
  (*whole)->read(kRate / 2, wanted);
  EXPECT_EQ(heard, wanted);
  while ((*track)->end() < (*whole)->end()) {
    std::this_thread::yield();
    (*track)->read(0, heard);
  }
  EXPECT_EQ((*track)->end(), (*whole)->end());
  for (int second = 0; second < kSeconds; ++second) {
    (*track)->read(second * kRate - 50, heard);
    (*whole)->read(second * kRate - 50, wanted);
    EXPECT_EQ(heard, wanted) << second;
  }
  EXPECT_EQ((*track)->take_complaint(), "");
}

TEST(FileTrack, IsReadUntilItIsAskedToStop) {
  const TempFolder folder;
  int asked = 0;
  const auto track = FileTrack::open(long_file(folder, 6), [&asked] { return ++asked > 2; });
  ASSERT_TRUE(track.has_value());
  EXPECT_EQ((*track)->end(), 2 * kRate);
}

TEST(FileTrack, IsLetGoWhileItIsStillRead) {
  const TempFolder folder;
  const auto path = long_file(folder, 6);
  const auto track = FileTrack::begin(path);
  ASSERT_TRUE(track.has_value());
}

TEST(FileTrack, ComplainsOnceOfAFileThatWasCutOff) {
  const TempFolder folder;
  const auto path = long_file(folder, 10);
  std::filesystem::resize_file(path, std::filesystem::file_size(path) / 2);
  const auto track = FileTrack::begin(path);
  ASSERT_TRUE(track.has_value());
  std::string complaint;
  while (complaint.empty()) {
    std::this_thread::yield();
    complaint = (*track)->take_complaint();
  }
  EXPECT_NE(complaint.find("long.wav"), std::string::npos) << complaint;
  EXPECT_EQ((*track)->take_complaint(), "");
}

TEST(FileTrack, RefusesWhatWouldNotFitIntoMemory) {
  // A header alone: 8-bit samples, one a millisecond, for five hours.
  const std::uint32_t count = 5 * 3600 * 1000;
  const auto bytes = [](std::uint32_t number, int width) {
    std::string text;
    for (int i = 0; i < width; ++i) text += static_cast<char>(number >> (8U * unsigned(i)));
    return text;
  };
  const TempFolder folder;
  const auto path =
      folder.write("a.wav", "RIFF" + bytes(36 + count, 4) + "WAVEfmt " + bytes(16, 4) +
                                bytes(1, 2) + bytes(1, 2) + bytes(1000, 4) + bytes(1000, 4) +
                                bytes(1, 2) + bytes(8, 2) + "data" + bytes(count, 4));
  std::filesystem::resize_file(path, 44 + count);
  for (const auto& track : {FileTrack::open(path), FileTrack::begin(path)}) {
    ASSERT_FALSE(track.has_value());
    EXPECT_EQ(track.error().kind, ErrorKind::BadData);
    EXPECT_NE(track.error().message.find("4 hours"), std::string::npos) << track.error().message;
  }
}

}  // namespace
}  // namespace aucast::sound

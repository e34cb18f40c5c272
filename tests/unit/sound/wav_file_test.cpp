#include "client/sound/wav_file.h"

#include <gtest/gtest.h>

#include "tests/support/temp_folder.h"

namespace aucast::sound {
namespace {

TEST(WavFile, HasAHeaderAndItsSamples) {
  const aucast::test::TempFolder folder;
  auto file = WavFile::open(folder.path() / "a.wav");
  ASSERT_TRUE(file.has_value());
  const std::vector<float> samples{0, 1, -1, 0.5F, 7, -7};
  (*file)->add(samples);
  EXPECT_EQ(folder.read("a.wav"), "") << "nothing before the end";
  ASSERT_TRUE((*file)->finish().has_value());
  const std::string expected(
      "RIFF\x30\0\0\0WAVEfmt \x10\0\0\0\1\0\1\0\x80\xbb\0\0\0\x77\1\0\2\0\x10\0"
      "data\x0c\0\0\0\0\0\xff\x7f\x01\x80\0\x40\xff\x7f\x01\x80",
      56);
  EXPECT_EQ(folder.read("a.wav"), expected);
}

TEST(WavFile, WhatIsTooLongForAWavFileIsLeftOutAndSaid) {
  const aucast::test::TempFolder folder;
  auto file = WavFile::open(folder.path() / "a.wav", 3);
  ASSERT_TRUE(file.has_value());
  (*file)->add(std::vector<float>{1, 1});
  EXPECT_FALSE((*file)->full());
  EXPECT_EQ((*file)->complaint(), "");
  (*file)->add(std::vector<float>{1, 0.5F, 0.5F});
  (*file)->add(std::vector<float>{0.5F});
  EXPECT_TRUE((*file)->full());
  EXPECT_EQ((*file)->samples(), 3U);
  ASSERT_TRUE((*file)->finish().has_value());
  EXPECT_EQ(folder.read("a.wav").size(), 44U + 6U);
  EXPECT_NE((*file)->complaint().find("a.wav: a WAV file holds 12 hours"), std::string::npos);
}

TEST(WavFile, LeavesWhatWasThereUntilItIsDone) {
  const aucast::test::TempFolder folder;
  folder.write("a.wav", "before");
  {
    auto file = WavFile::open(folder.path() / "a.wav");
    ASSERT_TRUE(file.has_value());
    (*file)->add(std::vector<float>(100, 0.1F));
  }
  EXPECT_EQ(folder.read("a.wav"), "before");
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    if (entry.exists()) ++files;
  }
  EXPECT_EQ(files, 1U);
}

TEST(WavFile, SaysWhenThePlaceCannotBeWritten) {
  EXPECT_FALSE(WavFile::open("/nowhere/a.wav").has_value());
}

}  // namespace
}  // namespace aucast::sound

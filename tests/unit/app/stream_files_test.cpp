#include "client/app/stream_files.h"

#include <gtest/gtest.h>

#include "tests/support/memory_limit.h"
#include "tests/support/temp_folder.h"
#include "tests/unit/sources/tables.h"

namespace aucast::app {
namespace {

TEST(StreamFiles, AKeyframeHasItsTimeOrNone) {
  const test::TempFolder folder;
  const auto read = read_stream(folder.write("two.txt", "Beg_Stream\n12:30;500\n0\nEnd_Stream\n"));
  ASSERT_TRUE(read) << read.error().message;
  ASSERT_EQ(read->keyframes.size(), 2U);
  EXPECT_EQ(read->keyframes[0].time, Milliseconds(500));
  EXPECT_NEAR(read->keyframes[0].aus.left[12], 0.3, 1e-6);
  EXPECT_FALSE(read->keyframes[1].time.has_value());
}

TEST(StreamFiles, AStreamHasItsTitleOrNone) {
  const test::TempFolder folder;
  const auto titled =
      read_stream(folder.write("titled.txt", "# title: A talk\nBeg_Stream\n0\nEnd_Stream\n"));
  ASSERT_TRUE(titled) << titled.error().message;
  EXPECT_EQ(titled->title, "A talk");
  const auto plain =
      read_stream(folder.write("plain.txt", "# a note\nBeg_Stream\n0\nEnd_Stream\n"));
  ASSERT_TRUE(plain) << plain.error().message;
  EXPECT_EQ(plain->title, "");
}

TEST(StreamFiles, ATableIsReadAsItIsSet) {
  const test::TempFolder folder;
  const auto file = folder.write("talk.csv", sources::tables::kFacsvatar);
  const auto plain = open_stream(file, {}, kDialogNames);
  ASSERT_TRUE(plain) << plain.error().message;
  EXPECT_NE(plain->found.find("2 rows"), std::string::npos) << plain->found;
  const auto half = open_stream(file, {.gain_percent = 50}, kDialogNames);
  ASSERT_TRUE(half) << half.error().message;
  EXPECT_NEAR(half->keyframes.front().aus.left[1], plain->keyframes.front().aus.left[1] / 2, 0.01);
}

TEST(StreamFiles, WhatIsOddInATableIsSaidByTheNamesOfTheDialog) {
  const test::TempFolder folder;
  std::string hasty = "frame, face_id, timestamp, confidence, success, AU12_r, AU12_c\n";
  for (int i = 0; i < 10; ++i) {
    hasty += std::to_string(i + 1) + ", 0, 0.00" + std::to_string(i) + ", 0.98, 1, 5.0, 1\n";
  }
  const auto opened = open_stream(folder.write("hasty.csv", hasty), {.neutral_s = 1}, kDialogNames);
  ASSERT_TRUE(opened) << opened.error().message;
  ASSERT_EQ(opened->warnings.size(), 2U);
  EXPECT_EQ(opened->warnings[0], "1000 rows a second are no camera's: Pictures/s says how many");
  EXPECT_TRUE(opened->warnings[1].starts_with("AU12 100 %: ")) << opened->warnings[1];
  EXPECT_NE(opened->warnings[1].find("'Neutral, s'"), std::string::npos) << opened->warnings[1];
  const auto file = folder.write("timeless.csv", sources::tables::kPyFeat1);
  const Error timeless = open_stream(file, {}, kDialogNames).error();
  EXPECT_TRUE(timeless.message.ends_with("such as Pictures/s 30")) << timeless.message;
  const Error typed = open_stream(file, {}, kOptionNames).error();
  EXPECT_TRUE(typed.message.ends_with("such as --table-fps 30")) << typed.message;
}

TEST(StreamFiles, ALongStreamTakesLittleMemory) {
  const test::TempFolder folder;
  constexpr std::size_t kKeyframes = 1'000'000;
  const auto file = folder.write("long.txt", test::short_lines(kKeyframes));
  const test::MemoryLimit limit(std::uint64_t{300} << 20U);
  const auto opened = open_stream(file, {}, kDialogNames);
  ASSERT_TRUE(opened) << opened.error().message;
  EXPECT_EQ(opened->keyframes.size(), kKeyframes);
}

TEST(StreamFiles, WhatDoesNotFitIntoMemoryIsRefusedBeforeItIsRead) {
  const test::TempFolder folder;
  const auto file = folder.write("long.txt", test::short_lines(1'000'000));
  const test::MemoryLimit limit(std::uint64_t{130} << 20U);
  for (const Error& error :
       {open_stream(file, {}, kDialogNames).error(),
        open_stream(file, {.rate = 10}, kDialogNames).error(), read_stream(file).error()}) {
    EXPECT_EQ(error.kind, ErrorKind::Unreadable);
    EXPECT_NE(error.message.find("long.txt: too large to hold: it needs "), std::string::npos)
        << error.message;
    EXPECT_TRUE(error.message.ends_with("; choose a shorter stream")) << error.message;
  }
}

TEST(StreamFiles, WhatCannotBeReadSaysWhere) {
  const test::TempFolder folder;
  EXPECT_EQ(read_stream(folder.path() / "none.txt").error().kind, ErrorKind::Unreadable);
  const auto bad = folder.write("bad.txt", "Beg_Stream\nx\nEnd_Stream\n");
  for (const Error& error :
       {read_stream(bad).error(), open_stream(bad, {}, kDialogNames).error()}) {
    EXPECT_EQ(error.kind, ErrorKind::BadData);
    EXPECT_NE(error.message.find("bad.txt:2"), std::string::npos) << error.message;
  }
}

}  // namespace
}  // namespace aucast::app

#include "server/live/record_writer.h"

#include <semaphore>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/temp_folder.h"

namespace aucast::server {
namespace {

class RecordWriterTest : public ::testing::Test {
 protected:
  test::TempFolder folder_;
  std::filesystem::path path_ = folder_.path() / "kept.txt";
};

TEST_F(RecordWriterTest, WhatComesTooFastEndsItAndWhatWasAcceptedIsKept) {
  auto writer = RecordWriter::start(path_, kStreamFileForm);
  ASSERT_TRUE(writer) << writer.error().message;
  (*writer)->add({"12:20;40\n"});
  (*writer)->add(std::vector<std::string>(std::size_t{1} << 18U, "12;33\n"));  // 1.5 MiB
  (*writer)->add({"0;40\n"});
  const auto finished = (*writer)->finish();
  ASSERT_FALSE(finished);
  EXPECT_NE(finished.error().message.find("the disk takes nothing; record to a faster one"),
            std::string::npos);
  EXPECT_EQ(folder_.read("kept.txt"), "Beg_Stream\n12:20;40\nEnd_Stream\n");
  EXPECT_EQ((*writer)->written(), 1U);
}

TEST_F(RecordWriterTest, WhatIsBeingWrittenCountsAsWaitingForTheDisk) {
  auto writer = RecordWriter::start(path_, kPagesForm);
  ASSERT_TRUE(writer) << writer.error().message;
  std::binary_semaphore begun{0};
  std::binary_semaphore disk{0};
  constexpr std::size_t kHalf = (std::size_t{1} << 19U) - RecordWriter::kBytesEach;
  (*writer)->add(kHalf, [&] {
    begun.release();
    disk.acquire();
    return std::string("begin");
  });
  begun.acquire();
  (*writer)->add(kHalf, [] { return std::string(" and end"); });
  (*writer)->add({"!"});
  disk.release();
  EXPECT_FALSE((*writer)->finish());
  EXPECT_EQ(folder_.read("kept.txt"), "begin and end");
}

TEST_F(RecordWriterTest, PiecesThatHoldNothingHaveTheirLimitToo) {
  auto writer = RecordWriter::start(path_, kPagesForm);
  ASSERT_TRUE(writer) << writer.error().message;
  std::binary_semaphore disk{0};
  (*writer)->add(0, [&disk] {
    disk.acquire();
    return std::string("begin");
  });
  constexpr std::size_t kFitMax = (std::size_t{1} << 20U) / RecordWriter::kBytesEach;
  for (std::size_t i = 0; i < kFitMax; ++i) (*writer)->add(0, [] { return std::string(); });
  disk.release();
  EXPECT_FALSE((*writer)->finish());
}

TEST_F(RecordWriterTest, WhatIsMadeWhenItIsWrittenMayBeLarge) {
  auto writer = RecordWriter::start(path_, kPagesForm);
  ASSERT_TRUE(writer) << writer.error().message;
  std::binary_semaphore disk{0};
  (*writer)->add(8, [&disk] {
    disk.acquire();
    return std::string("begin");
  });
  const std::string silence(std::size_t{5} << 20U, '-');
  (*writer)->add(8, [&silence] { return silence; });
  (*writer)->add(8, [] { return std::string(); });
  (*writer)->add({"end"});
  disk.release();
  EXPECT_TRUE((*writer)->finish());
  EXPECT_TRUE(folder_.read("kept.txt") == "begin" + silence + "end");
  EXPECT_EQ((*writer)->written(), 3U) << "an empty piece is none";
}

}  // namespace
}  // namespace aucast::server

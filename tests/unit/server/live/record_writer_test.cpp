#include "server/live/record_writer.h"

#include <filesystem>
#include <memory>
#include <semaphore>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/temp_folder.h"

namespace aucast::server {
namespace {

class RecordWriterTest : public ::testing::Test {
 protected:
  [[nodiscard]] std::unique_ptr<RecordWriter> start(const RecordForm& form) {
    auto started = RecordWriter::start(path_, form);
    EXPECT_TRUE(started) << started.error().message;
    return *std::move(started);
  }
  /// Has the writer write "begin", which counts as so many bytes, until disk_ is released.
  void hold_disk(RecordWriter& writer, std::size_t bytes) {
    writer.add(bytes, [this] {
      begun_.release();
      disk_.acquire();
      return std::string("begin");
    });
    begun_.acquire();
  }

  test::TempFolder folder_;
  std::filesystem::path path_ = folder_.path() / "kept.txt";
  std::binary_semaphore begun_{0};
  std::binary_semaphore disk_{0};
};

TEST_F(RecordWriterTest, WhatComesTooFastEndsItAndWhatWasAcceptedIsKept) {
  const auto writer = start(kStreamFileForm);
  writer->add({"12:20;40\n"});
  writer->add(std::vector<std::string>(std::size_t{1} << 18U, "12;33\n"));  // 1.5 MiB
  writer->add({"0;40\n"});
  const auto finished = writer->finish();
  ASSERT_FALSE(finished);
  EXPECT_NE(finished.error().message.find("the disk takes nothing; record to a faster one"),
            std::string::npos);
  EXPECT_EQ(folder_.read("kept.txt"), "Beg_Stream\n12:20;40\nEnd_Stream\n");
  EXPECT_EQ(writer->written(), 1U);
}

TEST_F(RecordWriterTest, WhatIsBeingWrittenCountsAsWaitingForTheDisk) {
  const auto writer = start(kPagesForm);
  constexpr std::size_t kHalf = (std::size_t{1} << 19U) - RecordWriter::kBytesEach;
  hold_disk(*writer, kHalf);
  writer->add(kHalf, [] { return std::string(" and end"); });
  writer->add({"!"});
  disk_.release();
  EXPECT_FALSE(writer->finish());
  EXPECT_EQ(folder_.read("kept.txt"), "begin and end");
}

TEST_F(RecordWriterTest, PiecesThatHoldNothingHaveTheirLimitToo) {
  const auto writer = start(kPagesForm);
  hold_disk(*writer, 0);
  constexpr std::size_t kFitMax = (std::size_t{1} << 20U) / RecordWriter::kBytesEach;
  for (std::size_t i = 0; i < kFitMax; ++i) writer->add(0, [] { return std::string(); });
  disk_.release();
  EXPECT_FALSE(writer->finish());
}

TEST_F(RecordWriterTest, WhatIsMadeWhenItIsWrittenMayBeLarge) {
  const auto writer = start(kPagesForm);
  hold_disk(*writer, 8);
  const std::string silence(std::size_t{5} << 20U, '-');
  writer->add(8, [&silence] { return silence; });
  writer->add(8, [] { return std::string(); });
  writer->add({"end"});
  disk_.release();
  EXPECT_TRUE(writer->finish());
  EXPECT_TRUE(folder_.read("kept.txt") == "begin" + silence + "end");
  EXPECT_EQ(writer->written(), 3U) << "an empty piece is none";
}

}  // namespace
}  // namespace aucast::server

#include "server/live/record_file.h"

#include <sys/stat.h>

#include <gtest/gtest.h>

#include "tests/support/temp_folder.h"

namespace aucast::server {
namespace {

using test::TempFolder;

class RecordFileTest : public ::testing::Test {
 protected:
  TempFolder folder_;
  std::filesystem::path path_ = folder_.path() / "kept.txt";
};

TEST_F(RecordFileTest, IsAWholeStreamFileAfterEveryLine) {
  auto file = RecordFile::create(path_);
  ASSERT_TRUE(file) << file.error().message;
  std::string lines;
  for (const char* line : {"12:20;40\n", "12;33\n", "0;3600000\n"}) {
    lines += line;
    ASSERT_TRUE(file->add(line));
    EXPECT_EQ(folder_.read("kept.txt"), "Beg_Stream\n" + lines + "End_Stream\n");
  }
  EXPECT_TRUE(file->sync());
}

TEST_F(RecordFileTest, WithoutALineThereIsNoFile) {
  {
    auto file = RecordFile::create(path_);
    ASSERT_TRUE(file);
  }
  EXPECT_FALSE(std::filesystem::exists(path_));
}

TEST_F(RecordFileTest, AnEmptyFileThatWasThereStays) {
  folder_.write("kept.txt", "");
  EXPECT_TRUE(RecordFile::create(path_));
  EXPECT_TRUE(std::filesystem::exists(path_));
}

TEST_F(RecordFileTest, WhatIsThereIsNeverWrittenOver) {
  folder_.write("kept.txt", "yesterday");
  EXPECT_EQ(RecordFile::create(path_).error(),
            (Error{ErrorKind::Failed, path_.string() +
                                          ": cannot be recorded to: it holds something already, "
                                          "which --record never writes over"}));
  EXPECT_EQ(folder_.read("kept.txt"), "yesterday");
  folder_.write("kept.txt", "");
  EXPECT_TRUE(RecordFile::create(path_));
}

TEST_F(RecordFileTest, TwoCannotWriteToOne) {
  const auto first = RecordFile::create(path_);
  ASSERT_TRUE(first);
  const auto second = RecordFile::create(path_);
  ASSERT_FALSE(second);
  EXPECT_NE(second.error().message.find("another program is recording to it"), std::string::npos);
}

TEST_F(RecordFileTest, OnlyPlainFilesAreTaken) {
  ASSERT_EQ(::mkfifo(path_.c_str(), 0600), 0);
  EXPECT_FALSE(RecordFile::create(path_));
  EXPECT_FALSE(RecordFile::create("/dev/full"));
  EXPECT_FALSE(RecordFile::create(folder_.path() / "no" / "kept.txt"));
  EXPECT_FALSE(RecordFile::create(folder_.path()));
}

}  // namespace
}  // namespace aucast::server

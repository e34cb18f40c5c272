// Files that streams are kept in.
#include "server/live/record_file.h"

#include <sys/stat.h>

#include <gtest/gtest.h>

#include "protocol/stream_file.h"
#include "server/live/record_writer.h"
#include "server/live/recorder.h"
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

TEST_F(RecordFileTest, TheRecorderWritesAllThatItWasGiven) {
  auto recorder = Recorder::start(path_);
  ASSERT_TRUE(recorder) << recorder.error().message;
  protocol::StreamFile stream;
  for (std::uint32_t i = 0; i < 2000; ++i) {
    protocol::Keyframe keyframe;
    keyframe.terms = {{static_cast<std::uint8_t>(i % 60 + 1), Side::Both, 50}};
    keyframe.duration_ms = i + 1;
    (*recorder)->add(keyframe, {}, false);
    stream.keyframes.push_back(keyframe);
  }
  EXPECT_TRUE((*recorder)->finish());
  EXPECT_EQ(folder_.read("kept.txt"), protocol::format_stream_file(stream));
}

TEST_F(RecordFileTest, WhatComesTooFastEndsItAndWhatWasAcceptedIsKept) {
  auto writer = RecordWriter::start(path_, kStreamFileForm);
  ASSERT_TRUE(writer) << writer.error().message;
  (*writer)->add({"12:20;40\n"});
  (*writer)->add(std::vector<std::string>(std::size_t{1} << 18U, "12;33\n"));  // 1.5 MiB
  (*writer)->add({"0;40\n"});
  const auto finished = (*writer)->finish();
  ASSERT_FALSE(finished);
  EXPECT_NE(finished.error().message.find("the disk takes nothing"), std::string::npos);
  EXPECT_EQ(folder_.read("kept.txt"), "Beg_Stream\n12:20;40\nEnd_Stream\n");
}

TEST_F(RecordFileTest, KeepsTheVoiceBesideTheFaceWhereItIsHeard) {
  using namespace std::chrono_literals;
  auto recorder = Recorder::start(path_);
  ASSERT_TRUE(recorder) << recorder.error().message;
  ASSERT_TRUE((*recorder)->add_voice_file());
  protocol::Keyframe keyframe;
  keyframe.terms = {{12, Side::Both, 50}};
  keyframe.duration_ms = 500;
  (*recorder)->add(keyframe, {}, false);
  const std::string opus("\x58\x01\x02", 3);  // 60 ms
  (*recorder)->add_voice({7s, opus}, -200ms);
  (*recorder)->add_voice({7060ms, opus}, -140ms);
  (*recorder)->add_voice({6s, opus}, -400ms);
  EXPECT_TRUE((*recorder)->finish());

  voice::OggOpusWriter expected(0ms, 1);
  EXPECT_TRUE(expected.add({300ms, opus}));
  EXPECT_TRUE(expected.add({360ms, opus}));
  std::string bytes = expected.take();
  bytes += expected.finish(500ms);
  EXPECT_EQ(folder_.read("kept.opus"), bytes);
}

TEST_F(RecordFileTest, WithoutAVoiceThereIsNoVoiceFile) {
  {
    auto recorder = Recorder::start(path_);
    ASSERT_TRUE(recorder);
    ASSERT_TRUE((*recorder)->add_voice_file());
    EXPECT_TRUE((*recorder)->finish());
  }
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "kept.opus"));
  folder_.write("kept.opus", "yesterday");
  auto recorder = Recorder::start(path_);
  ASSERT_TRUE(recorder);
  EXPECT_FALSE((*recorder)->add_voice_file()) << "what is there is never written over";
}

TEST(RecordPath, InAFolderEveryStreamHasItsOwnFile) {
  const TempFolder folder;
  const auto file = folder.path() / "kept.txt";
  EXPECT_EQ(record_path(file, "live", true), file);
  EXPECT_EQ(record_path(file, "other", false), std::nullopt);
  const auto path = record_path(folder.path(), "other", false);
  ASSERT_TRUE(path);
  EXPECT_EQ(path->parent_path(), folder.path());
  const std::string name = path->filename().string();
  EXPECT_TRUE(name.starts_with("other-20")) << name;
  EXPECT_TRUE(name.ends_with("Z.txt")) << name;
  EXPECT_EQ(name.size(), std::string("other-20261121T115000Z.txt").size()) << name;
}

}  // namespace
}  // namespace aucast::server

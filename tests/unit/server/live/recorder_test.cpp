#include "server/live/recorder.h"

#include <set>
#include <string>

#include <gtest/gtest.h>

#include "protocol/stream_file.h"
#include "tests/support/temp_folder.h"

namespace aucast::server {
namespace {

using namespace std::chrono_literals;
using test::TempFolder;

const std::string kOpus("\x58\x01\x02", 3);  // 60 ms

class RecorderTest : public ::testing::Test {
 protected:
  static void add_face(Recorder& recorder, Milliseconds time) {
    protocol::Keyframe keyframe;
    keyframe.terms = {{12, Side::Both, 50}};
    keyframe.time_ms = static_cast<std::uint32_t>(time.count());
    recorder.add(keyframe, {}, false);
  }

  TempFolder folder_;
  std::filesystem::path path_ = folder_.path() / "kept.txt";
};

TEST_F(RecorderTest, WritesAllThatItWasGiven) {
  auto recorder = Recorder::start(path_);
  ASSERT_TRUE(recorder) << recorder.error().message;
  protocol::StreamFile stream;
  for (std::uint32_t i = 0; i < 2000; ++i) {
    protocol::Keyframe keyframe;
    keyframe.terms = {{static_cast<std::uint8_t>(i % 60 + 1), Side::Both, 50}};
    keyframe.time_ms = i + 1;
    (*recorder)->add(keyframe, {}, false);
    stream.keyframes.push_back(keyframe);
  }
  EXPECT_TRUE((*recorder)->finish());
  EXPECT_EQ(folder_.read("kept.txt"), protocol::format_stream_file(stream));
}

TEST_F(RecorderTest, KeepsTheVoiceBesideTheFaceWhereItIsHeard) {
  auto recorder = Recorder::start(path_);
  ASSERT_TRUE(recorder) << recorder.error().message;
  ASSERT_TRUE((*recorder)->add_voice_file());
  add_face(**recorder, 500ms);
  (*recorder)->add_voice({7s, kOpus}, -200ms);
  (*recorder)->add_voice({7060ms, kOpus}, -140ms);
  (*recorder)->add_voice({6s, kOpus}, -400ms);
  EXPECT_TRUE((*recorder)->finish());

  voice::OggOpusWriter expected(0ms, 1);
  EXPECT_TRUE(expected.add({300ms, kOpus}));
  EXPECT_TRUE(expected.add({360ms, kOpus}));
  std::string bytes = expected.take();
  bytes += expected.finish(500ms);
  EXPECT_EQ(folder_.read("kept.opus"), bytes);
}

TEST_F(RecorderTest, GoesOnAfterHoursWithoutAVoice) {
  auto recorder = Recorder::start(path_);
  ASSERT_TRUE(recorder) << recorder.error().message;
  ASSERT_TRUE((*recorder)->add_voice_file());
  const auto three_hours = [&] {
    for (int hour = 0; hour < 3; ++hour) add_face(**recorder, 1h);
  };
  voice::OggOpusWriter expected(0ms, 1);
  for (const Milliseconds place : {3h, 6h}) {  // silence before the first packet, and after it
    three_hours();
    for (const Milliseconds after : {0ms, 60ms}) {
      (*recorder)->add_voice({0ms, kOpus}, after);
      EXPECT_TRUE(expected.add({place + after, kOpus}));
    }
  }
  three_hours();
  const auto finished = (*recorder)->finish();
  EXPECT_TRUE(finished) << finished.error().message;
  std::string bytes = expected.take();
  bytes += expected.finish(9h);
  EXPECT_TRUE(folder_.read("kept.opus") == bytes);
}

TEST_F(RecorderTest, WithoutAVoiceThereIsNoVoiceFile) {
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

TEST(RecordPath, RunsOfOneSecondHaveFilesOfTheirOwn) {
  const TempFolder folder;
  std::set<std::filesystem::path> all;
  for (int run = 0; run < 3; ++run) {
    const auto path = record_path(folder.path(), "live", true);
    ASSERT_TRUE(path);
    EXPECT_TRUE(all.insert(*path).second) << path->string();
    folder.write((run == 0 ? *path : voice_record_path(*path)).filename().string(), "kept");
  }
}

}  // namespace
}  // namespace aucast::server

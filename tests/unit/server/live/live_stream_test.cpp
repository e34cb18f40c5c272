// One live stream, without its source and a clock: the test is what is read, and the time.
#include "server/live/live_stream.h"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "common/sources/hold.h"
#include "common/sources/source_reader.h"
#include "protocol/stream_file.h"
#include "tests/support/quiet_log.h"
#include "tests/support/steady_time.h"
#include "tests/support/temp_folder.h"

namespace aucast::server {
namespace {

using namespace std::chrono_literals;

using Texts = std::vector<std::string>;

class LiveStreamTest : public ::testing::Test {
 protected:
  LiveStreamTest() {
    options_.path = "face.txt";
    begin();
  }

  /// A stream with the options as they are now.
  void begin() {
    stream_.emplace("face", options_, options_.reader, false, [this] {
      const auto feed = stream_->served().live();
      sent_.push_back(feed->ended() ? "end" : feed->newest()->full);
    });
  }

  /// What is sent of these lines, now.
  Texts fed(std::string_view lines, bool only_last = false) {
    stream_->reader().feed(lines, now_);
    stream_->take(now_, only_last);
    stream_->go_on(now_);
    return std::exchange(sent_, {});
  }
  /// What is sent of itself within so long.
  Texts after(Seconds time) {
    const SteadyTime until = now_ + time;
    for (auto next = stream_->next(); next && *next <= until; next = stream_->next()) {
      now_ = std::max(now_, *next) + 1us;
      stream_->go_on(now_);
    }
    now_ = until;
    return std::exchange(sent_, {});
  }

  const test::QuietLog quiet_;
  LiveStreamOptions options_;
  std::optional<LiveStream> stream_;
  SteadyTime now_ = test::at_second(1000);
  Texts sent_;
};

TEST_F(LiveStreamTest, EachKeyframeIsSentAsItComes) {
  EXPECT_FALSE(stream_->begun());
  EXPECT_EQ(fed("12:10;100\n12:20;100\n"), (Texts{"{12:10;100}", "{12:20;100}"}));
  EXPECT_EQ(fed("12:30"), Texts());
  EXPECT_EQ(fed(";100\n"), Texts{"{12:30;100}"});
  EXPECT_TRUE(stream_->begun());
  EXPECT_EQ(stream_->served().name, "face");
}

TEST_F(LiveStreamTest, OfWhatIsPastOnlyTheLastIsSent) {
  EXPECT_EQ(fed("12:10;100\n12:20;100\n", true), Texts{"{12:20;100}"});
}

TEST_F(LiveStreamTest, IsFullUntilItWasSent) {
  std::string lines;
  for (int i = 0; i < 255; ++i) lines += "12;100\n";
  stream_->reader().feed(lines, now_);
  stream_->take(now_, false);
  EXPECT_FALSE(stream_->full());
  stream_->reader().feed("12;100\n", now_);
  stream_->take(now_, false);
  EXPECT_TRUE(stream_->full());
  stream_->go_on(now_);
  EXPECT_FALSE(stream_->full());
}

TEST_F(LiveStreamTest, EndsWhenItsWriterStaysAwayAndGoesOnWhenItComesBack) {
  EXPECT_EQ(fed("12:50;100\n"), Texts{"{12:50;100}"});
  stream_->end_input(now_, false);
  Texts meanwhile = after(options_.timeout - 100ms);
  ASSERT_FALSE(meanwhile.empty());
  EXPECT_EQ(meanwhile.back().substr(0, 2), "{0") << "the face is neutral";
  EXPECT_FALSE(stream_->ended());
  EXPECT_EQ(after(200ms), Texts{"end"});
  EXPECT_TRUE(stream_->ended());
  EXPECT_EQ(fed("12:60;100\n"), Texts{"{12:60;100}"});
  EXPECT_FALSE(stream_->ended());
}

TEST_F(LiveStreamTest, OnceItHasEndedTheFaceThatGoesToNeutralIsNotSent) {
  options_.timeout = Milliseconds(1000);
  begin();
  const test::TempFolder folder;
  const auto record = folder.path() / "record.txt";
  ASSERT_TRUE(stream_->record(record));
  EXPECT_EQ(fed("12:50;100\n"), Texts{"{12:50;100}"});
  stream_->end_input(now_, false);
  Texts rest = after(100s);
  EXPECT_EQ(std::count(rest.begin(), rest.end(), "end"), 1);
  EXPECT_EQ(rest.back(), "end");
  EXPECT_TRUE(stream_->ended());
  EXPECT_EQ(fed("12:60;100\n"), Texts{"{12:60;100}"});
  ASSERT_TRUE(stream_->finish_record());
  const auto recorded = protocol::parse_stream_file(*sources::read_text(record), "record");
  ASSERT_TRUE(recorded);
  EXPECT_EQ(protocol::media_ms(*recorded, 250), 100U + 1000U + 100U) << "without what came later";
}

TEST_F(LiveStreamTest, EndsWithTheFaceWhenNobodyCanWriteAnyMore) {
  EXPECT_EQ(fed("12:50;100\n").size(), 1U);
  stream_->end_input(now_, true);
  const Texts rest = after(Seconds(sources::kHoldSeconds + sources::kEaseSeconds + 0.1));
  ASSERT_FALSE(rest.empty());
  EXPECT_EQ(rest.back(), "end");
  EXPECT_EQ(after(100s), Texts()) << "once";
}

TEST_F(LiveStreamTest, WithoutAnyKeyframeItEndsWithItsInput) {
  stream_->end_input(now_, true);
  EXPECT_EQ(fed(""), Texts{"end"});
  EXPECT_FALSE(stream_->begun());
  EXPECT_TRUE(stream_->ended());
}

TEST_F(LiveStreamTest, WithoutATimeoutItNeverEnds) {
  options_.timeout = Milliseconds(0);
  begin();
  EXPECT_EQ(fed("12:50;100\n").size(), 1U);
  stream_->end_input(now_, true);
  after(1000s);
  EXPECT_FALSE(stream_->ended());
}

}  // namespace
}  // namespace aucast::server

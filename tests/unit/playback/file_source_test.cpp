#include "client/playback/file_source.h"

#include <utility>

#include <gtest/gtest.h>

#include "tests/unit/playback/marked.h"

namespace aucast::playback {
namespace {

using test::mark_of;
using test::marked;

TEST(FileSource, GivesItsKeyframesInOrder) {
  FileSource source({marked(1), marked(2), marked(3)});
  for (int mark = 1; mark <= 3; ++mark) {
    EXPECT_TRUE(source.ready());
    const auto keyframe = source.take();
    ASSERT_TRUE(keyframe);
    EXPECT_EQ(mark_of(*keyframe), mark);
  }
  EXPECT_TRUE(source.ready()) << "nothing will ever come again";
  EXPECT_FALSE(source.take());
  EXPECT_TRUE(source.wait_until(Instant{}));
}

TEST(FileSource, TellsTheEndAndWhatIsLeft) {
  FileSource source({marked(1), marked(2)});
  EXPECT_EQ(source.status().end, EndReason::EndOfStream);
  EXPECT_EQ(source.status().keyframes_received, 2U);
  EXPECT_EQ(source.status().playout_fill, 2U);
  EXPECT_EQ(source.status().keyframe_time, Milliseconds(250));
  EXPECT_TRUE(source.take());
  EXPECT_EQ(source.status().playout_fill, 1U);
}

TEST(FileSource, GivesPlacesToAStreamThatHasAClock) {
  FileSource source({marked(1, Milliseconds(40)), marked(2), marked(3, Milliseconds(0))},
                    Milliseconds(250));
  for (const auto& [place, span] : {std::pair{40, 40}, {290, 250}, {290, 0}}) {
    const auto keyframe = source.take();
    ASSERT_TRUE(keyframe);
    EXPECT_EQ(keyframe->place, Milliseconds(place));
    EXPECT_EQ(keyframe->span, Milliseconds(span));
  }
  FileSource without({marked(1)});
  EXPECT_EQ(without.take()->place, std::nullopt);
}

TEST(FileSource, GivesNothingAfterStop) {
  FileSource source({marked(1)});
  source.stop();
  EXPECT_FALSE(source.take());
  EXPECT_TRUE(source.ready());
  EXPECT_EQ(source.status().end, EndReason::Stopped);
  EXPECT_EQ(source.status().playout_fill, 0U);
}

TEST(FileSource, StopAfterTheLastKeyframeChangesNothing) {
  FileSource source({marked(1)});
  EXPECT_TRUE(source.take());
  source.stop();
  EXPECT_EQ(source.status().end, EndReason::EndOfStream);
}

TEST(FileSource, MayBeEmpty) {
  FileSource source({});
  EXPECT_TRUE(source.ready());
  EXPECT_FALSE(source.take());
}

TEST(EndReason, HasTheNamesOfTheStatistics) {
  EXPECT_EQ(name(EndReason::NotEnded), "not_ended");
  EXPECT_EQ(name(EndReason::EndOfStream), "end_of_stream");
  EXPECT_EQ(name(EndReason::Stopped), "stopped");
  EXPECT_EQ(name(EndReason::ConnectionLost), "connection_lost");
  EXPECT_EQ(name(EndReason::ProtocolError), "protocol_error");
  EXPECT_EQ(name(EndReason::Unreachable), "unreachable");
  EXPECT_EQ(name(EndReason::Refused), "refused");
}

}  // namespace
}  // namespace aucast::playback

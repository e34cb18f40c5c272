#include "client/app/live_text.h"

#include <gtest/gtest.h>

namespace aucast::app {
namespace {

using namespace std::chrono_literals;

TEST(LiveObjection, IsSaidWhereLiveChangesNothing) {
  PlaybackOptions options;
  playback::SourceStatus status;
  EXPECT_EQ(live_objection(options, status), LiveObjection::None) << "nobody asked";
  options.buffers.low_delay = true;
  EXPECT_EQ(live_objection(options, status), LiveObjection::IsClassic);
  EXPECT_EQ(window_text(LiveObjection::IsClassic), terminal_text(LiveObjection::IsClassic))
      << "in English";
  status.negotiated = true;
  EXPECT_EQ(live_objection(options, status), LiveObjection::IsRecorded);
  EXPECT_EQ(window_text(LiveObjection::IsRecorded), terminal_text(LiveObjection::IsRecorded))
      << "in English";
  status.live = true;
  EXPECT_EQ(live_objection(options, status), LiveObjection::None);
  status.live = false;
  options.file = "talk.txt";
  EXPECT_EQ(live_objection(options, status), LiveObjection::IsFile);
  EXPECT_EQ(window_text(LiveObjection::IsFile), terminal_text(LiveObjection::IsFile))
      << "in English";
}

TEST(DelayText, SaysUsualLongestAndWanted) {
  EXPECT_EQ(delay_text({}, 41ms), "");
  EXPECT_EQ(delay_text({250, 42ms, 57'400us}, 41ms), "42 ms (at most 57, wanted 41)");
}

}  // namespace
}  // namespace aucast::app

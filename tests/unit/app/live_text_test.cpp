#include "client/app/live_text.h"

#include <gtest/gtest.h>

namespace aucast::app {
namespace {

using namespace std::chrono_literals;

TEST(LiveObjection, IsSaidWhereLiveChangesNothing) {
  PlaybackOptions options;
  playback::SourceStatus status;
  EXPECT_EQ(live_objection(options, status), "") << "nobody asked";
  options.buffers.low_delay = true;
  EXPECT_NE(live_objection(options, status).find("classic server"), std::string::npos);
  status.negotiated = true;
  EXPECT_NE(live_objection(options, status).find("is recorded"), std::string::npos);
  status.live = true;
  EXPECT_EQ(live_objection(options, status), "");
  status.live = false;
  options.file = "talk.txt";
  EXPECT_NE(live_objection(options, status).find("a file is not live"), std::string::npos);
}

TEST(DelayText, SaysUsualLongestAndWanted) {
  EXPECT_EQ(delay_text({}, 41ms), "");
  EXPECT_EQ(delay_text({250, 42ms, 57'400us}, 41ms), "42 ms (at most 57, wanted 41)");
}

}  // namespace
}  // namespace aucast::app

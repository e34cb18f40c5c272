#include "server/engine/recurring_complaint.h"

#include <gtest/gtest.h>

namespace aucast::server {
namespace {

using namespace std::chrono_literals;

TEST(RecurringComplaint, IsSaidOnceAPeriodWithHowOftenItHappened) {
  const Instant begin = Instant{} + 1h;
  RecurringComplaint complaint(10s);
  EXPECT_EQ(complaint.happened(begin), 1U);
  EXPECT_EQ(complaint.happened(begin), std::nullopt);
  EXPECT_EQ(complaint.happened(begin + 9'999ms), std::nullopt);
  EXPECT_EQ(complaint.happened(begin + 10s), 4U) << "those that were not said count";
  EXPECT_EQ(complaint.happened(begin + 19s), std::nullopt) << "the period begins anew";
  EXPECT_EQ(complaint.happened(begin + 1h), 6U);
}

}  // namespace
}  // namespace aucast::server

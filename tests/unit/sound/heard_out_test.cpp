#include "client/sound/heard_out.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/sound/cranked_out.h"

namespace aucast::sound {
namespace {

using test::Crank;
using test::CrankedOut;

class HeardOutTest : public testing::Test {
 protected:
  void write(Milliseconds time) {
    out_.write(std::vector<float>(static_cast<std::size_t>(samples_of(time))));
  }
  /// Lets time pass for the device and for everybody else; returns whether the device goes on.
  bool pass(Milliseconds time) {
    crank_.turn(time);
    now_ += time;
    return out_.look(now_);
  }

  Crank crank_;
  HeardOut out_{std::make_unique<CrankedOut>(crank_)};
  Instant now_{};
};

TEST_F(HeardOutTest, StandsWhenAllIsHeardAndGoesOnWithWhatIsWritten) {
  out_.begin(now_);
  EXPECT_EQ(out_.reported(), std::nullopt) << "nothing is heard yet";
  write(Milliseconds(100));
  EXPECT_TRUE(pass(Milliseconds(50)));
  EXPECT_EQ(out_.reported(), Milliseconds(50));
  EXPECT_EQ(out_.underruns(), 0U);
  EXPECT_TRUE(pass(Milliseconds(60)));
  EXPECT_EQ(out_.underruns(), 1U);
  EXPECT_TRUE(pass(Milliseconds(500)));
  EXPECT_EQ(out_.underruns(), 1U) << "it is still the same time";
  EXPECT_EQ(out_.heard(now_), Milliseconds(100));
  EXPECT_EQ(out_.reported(), std::nullopt);
  write(Milliseconds(100));
  EXPECT_TRUE(pass(Milliseconds(50)));
  EXPECT_EQ(out_.reported(), Milliseconds(150));
}

TEST_F(HeardOutTest, EachTimeThatItRunsDryTheLeadGrowsUpToItsMost) {
  EXPECT_EQ(out_.lead(), HeardOut::kLeadMin);
  for (int i = 1; i <= 10; ++i) {
    out_.begin(now_);
    write(Milliseconds(20));
    EXPECT_TRUE(pass(Milliseconds(40)));
    EXPECT_EQ(out_.lead(),
              std::min<Duration>(HeardOut::kLeadMin + i * HeardOut::kLeadStep, HeardOut::kLeadMax));
  }
  EXPECT_EQ(out_.lead(), HeardOut::kLeadMax);
}

TEST_F(HeardOutTest, ADeviceThatIsDeafOrLostIsNoneAnyMore) {
  out_.begin(now_);
  write(Milliseconds(20'000));
  now_ += HeardOut::kDeafMax;
  EXPECT_TRUE(out_.look(now_)) << "just in time";
  now_ += Milliseconds(1);
  EXPECT_FALSE(out_.look(now_));
  out_.begin(now_);
  EXPECT_TRUE(pass(Milliseconds(10)));
  crank_.lost = true;
  EXPECT_FALSE(pass(Milliseconds(10)));
  out_.close();
  EXPECT_FALSE(out_.open());
}

TEST_F(HeardOutTest, ADevicesReportGoesNeitherBackNorBeyondWhatItWasGiven) {
  out_.begin(now_);
  write(Milliseconds(100));
  EXPECT_TRUE(pass(Milliseconds(40)));
  crank_.misread = -samples_of(Milliseconds(20));
  EXPECT_TRUE(out_.look(now_));
  EXPECT_EQ(out_.reported(), Milliseconds(40));
  crank_.misread = samples_of(Milliseconds(500));
  EXPECT_EQ(out_.reported(), Milliseconds(100));
}

TEST(SamplesOf, AndTimeOfAreEachOthersToTheSample) {
  for (const std::int64_t samples : {0, 1, 47, 48, 49, 48'000, 123'456'789}) {
    const std::int64_t there = samples_of(time_of(samples));
    EXPECT_LE(samples - there, 1) << samples << ": a third of a nanosecond is rounded down";
    EXPECT_GE(samples, there);
  }
  EXPECT_EQ(samples_of(Milliseconds(1)), 48);
  EXPECT_EQ(time_of(48'000), std::chrono::seconds(1));
}

}  // namespace
}  // namespace aucast::sound

#include "common/sources/one_euro.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "common/sources/hold.h"
#include "tests/support/seeded.h"

namespace aucast::sources {
namespace {

constexpr OneEuroSettings kOnes{1, 1, 1};

std::vector<double> filtered(const std::vector<double>& values, double step,
                             const OneEuroSettings& settings) {
  OneEuro filter;
  std::vector<double> results;
  double seconds = 0;
  for (const double value : values) {
    results.push_back(filter.next(seconds, value, settings));
    seconds += step;
  }
  return results;
}

// Worked out by hand from algorithm 1 of the paper, every parameter 1: with r = 2 pi cutoff step
// the share of the new value is r / (r + 1).
TEST(OneEuro, FollowsThePaperStepByStep) {
  OneEuro filter;
  EXPECT_EQ(filter.next(0, 0, kOnes), 0);
  // speed (1 - 0) / 0.1 = 10, of it 0.385869; cutoff 1 + 3.858695; share 0.753257
  EXPECT_NEAR(filter.next(0.1, 1, kOnes), 0.753257, 1e-6);
  // speed (1 - 0.753257) / 0.1 = 2.467425, with the last one 3.321846; share 0.730857
  EXPECT_NEAR(filter.next(0.2, 1, kOnes), 0.933591, 1e-6);
  // half the step: speed (0 - 0.933591) / 0.05, with the last one -1.935898; share 0.479801
  EXPECT_NEAR(filter.next(0.25, 0, kOnes), 0.485654, 1e-6);
}

TEST(OneEuro, AStepIsApproachedWithoutOvershoot) {
  test::Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  for (int round = 0; round < 200; ++round) {
    const OneEuroSettings settings{seeded.real(0.01, 20), seeded.real(0, 20),
                                   seeded.real(0.01, 20)};
    OneEuro filter;
    double seconds = 0;
    double last = filter.next(seconds, 0, settings);
    for (int row = 0; row < 300; ++row) {
      seconds += seeded.real(0.001, kHoldSeconds);
      const double now = filter.next(seconds, 1, settings);
      ASSERT_GE(now, last);
      ASSERT_LE(now, 1);
      last = now;
    }
  }
}

TEST(OneEuro, NoiseOfWhatStandsStillIsTakenOff) {
  test::Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  std::vector<double> noisy(900);
  for (double& value : noisy) value = 0.5 + seeded.real(-0.05, 0.05);
  const auto smooth = filtered(noisy, 1.0 / 30, {0.5, 0.1, 1});
  const auto spread = [](const std::vector<double>& values) {
    double sum = 0;
    for (std::size_t row = 100; row < values.size(); ++row) {
      sum += (values[row] - 0.5) * (values[row] - 0.5);
    }
    return std::sqrt(sum / static_cast<double>(values.size() - 100));
  };
  EXPECT_LT(spread(smooth), spread(noisy) / 3);
}

TEST(OneEuro, WhatMovesFastIsLessLateWithMoreBeta) {
  const std::vector<double> blink{0, 0, 0.5, 1, 1, 1};
  double last = 0;
  for (const double beta : {0.0, 1.0, 4.0, 16.0}) {
    const double reached = filtered(blink, 1.0 / 30, {1, beta, 1})[3];
    EXPECT_GT(reached, last) << beta;
    last = reached;
  }
  EXPECT_GT(last, 0.9);
}

/// Without beta it is an exponential mean in the time that has really passed: 1 - exp(-t / tau) but
/// for the sampling, however the rows lie.
TEST(OneEuro, GoesByTheTimeThatHasPassedAndNotByRows) {
  constexpr OneEuroSettings kPlain{1, 0, 1};
  const double wanted = 1 - std::exp(-2 * std::numbers::pi * 0.4);
  for (const std::vector<double>& steps :
       {std::vector<double>(400, 0.001), std::vector<double>{0.1, 0.001, 0.2, 0.099},
        std::vector<double>(40, 0.01)}) {
    OneEuro filter;
    double seconds = 0;
    double reached = filter.next(0, 0, kPlain);
    for (const double step : steps) {
      // Rows that are close together, on the way to the next of the uneven ones.
      for (int part = 1; part <= 100; ++part) {
        reached = filter.next(seconds + step * part / 100, 1, kPlain);
      }
      seconds += step;
    }
    EXPECT_NEAR(reached, wanted, 0.005) << steps.size();
  }
}

TEST(OneEuro, AGapBeginsAnewInsteadOfTrailingBehind) {
  OneEuro filter;
  EXPECT_EQ(filter.next(0, 1, kOnes), 1);
  EXPECT_LT(filter.next(kHoldSeconds, 0, kOnes), 1);
  EXPECT_EQ(filter.next(2 * kHoldSeconds + 0.01, 0.3, kOnes), 0.3);
  // The speed is forgotten as well: from rest as at the first row.
  OneEuro fresh;
  EXPECT_EQ(fresh.next(0, 0.3, kOnes), 0.3);
  EXPECT_NEAR(filter.next(2 * kHoldSeconds + 0.05, 0.4, kOnes), fresh.next(0.04, 0.4, kOnes),
              1e-12);
}

TEST(OneEuro, AMomentThatIsNotLaterChangesNothing) {
  OneEuro filter;
  EXPECT_EQ(filter.next(1, 0.5, kOnes), 0.5);
  EXPECT_EQ(filter.next(1, 1, kOnes), 0.5);
  EXPECT_EQ(filter.next(0.5, 1, kOnes), 0.5);
}

TEST(OneEuroBank, WhatHasNoDataStaysSoAndItsFilterWaits) {
  OneEuroBank bank;
  OneEuro alone;
  const auto at = [&bank](double seconds, float smile) {
    Signals signals = no_signals();
    signals[12] = smile;
    signals[1] = 0.5F;
    bank.apply(seconds, signals, kOnes);
    EXPECT_EQ(signals[1], 0.5F);
    EXPECT_FALSE(is_signal(signals[2]));
    return signals[12];
  };
  EXPECT_EQ(at(0, 0), 0);
  static_cast<void>(alone.next(0, 0, kOnes));
  EXPECT_FALSE(is_signal(at(0.1, kNoSignal)));
  EXPECT_FLOAT_EQ(at(0.2, 1), static_cast<float>(alone.next(0.2, 1, kOnes)));
}

}  // namespace
}  // namespace aucast::sources

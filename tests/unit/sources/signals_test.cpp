#include "common/sources/signals.h"

#include <gtest/gtest.h>

namespace aucast::sources {
namespace {

TEST(Signals, NoDataIsBelowEveryIntensity) {
  for (const auto& side : {no_data().left, no_data().right}) {
    for (const float value : side) EXPECT_EQ(value, -1);
  }
}

TEST(Signals, DirectionsOfOneMovementAreOneSignal) {
  EXPECT_EQ(opposite_of(51), 52U);
  EXPECT_EQ(opposite_of(64), 63U);
  EXPECT_EQ(opposite_of(12), 0U);
  EXPECT_EQ(opposite_of(59), 0U);
  EXPECT_EQ(opposite_of(60), 0U);
  EXPECT_TRUE(is_second_direction(58));
  EXPECT_FALSE(is_second_direction(57));
  EXPECT_FALSE(is_second_direction(12));
  AuFrame update = no_data();
  update.left[51] = 0;
  update.left[52] = 0.25F;
  update.right[51] = 0.5F;
  update.right[52] = 0;
  const Signals signals = signals_of(update);
  EXPECT_EQ(signals[channel_of(51, false)], -0.25F);
  EXPECT_EQ(signals[channel_of(51, true)], 0.5F);
  EXPECT_FALSE(is_signal(signals[channel_of(52, false)]));
}

TEST(Signals, GoThereAndBackWithoutLoss) {
  AuFrame update = no_data();
  update.left[12] = 0.75F;
  update.right[12] = 0.5F;
  for (const std::size_t number : {1U, 53U, 58U, 61U}) {
    update.left[number] = update.right[number] = 0.25F;
    if (const std::size_t opposite = opposite_of(number)) {
      update.left[opposite] = update.right[opposite] = 0;
    }
  }
  EXPECT_EQ(update_of(signals_of(update)), update);
  EXPECT_EQ(update_of(no_signals()), no_data()) << "no data stays no data";
}

TEST(Signals, WhatIsShownIsFromNoneToFull) {
  Signals signals = no_signals();
  signals[channel_of(12, false)] = -0.25F;
  signals[channel_of(12, true)] = 1.5F;
  signals[channel_of(53, false)] = -1.5F;
  const AuFrame update = update_of(signals);
  EXPECT_EQ(update.left[12], 0);
  EXPECT_EQ(update.right[12], 1);
  EXPECT_EQ(update.left[53], 0);
  EXPECT_EQ(update.left[54], 1);
}

}  // namespace
}  // namespace aucast::sources

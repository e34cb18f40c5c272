#include "protocol/answer_window.h"

#include <gtest/gtest.h>

namespace aucast::protocol {
namespace {

TEST(AnswerWindow, HasRoomForAsManyKeyframesAsItsSize) {
  AnswerWindow window;
  window.set_size(2);
  EXPECT_FALSE(window.count_sent());
  EXPECT_TRUE(window.may_send());
  EXPECT_FALSE(window.count_sent());
  EXPECT_FALSE(window.may_send());
  EXPECT_EQ(window.in_flight(), 2U);
  EXPECT_TRUE(window.count_answer());
  EXPECT_TRUE(window.may_send());
}

TEST(AnswerWindow, ABankedAnswerAnswersTheNextKeyframe) {
  AnswerWindow window;
  EXPECT_FALSE(window.count_answer());
  EXPECT_EQ(window.banked(), 1U);
  EXPECT_TRUE(window.count_sent());
  EXPECT_EQ(window.banked(), 0U);
  EXPECT_EQ(window.in_flight(), 0U);
  EXPECT_FALSE(window.count_sent());
  EXPECT_EQ(window.in_flight(), 1U);
}

TEST(AnswerWindow, WithoutAnswersThereIsAlwaysRoom) {
  AnswerWindow window;
  window.set_size(0);
  for (int i = 0; i < 1000; ++i) EXPECT_FALSE(window.count_sent());
  EXPECT_TRUE(window.may_send() && window.settled());
  EXPECT_FALSE(window.answers());
}

TEST(AnswerWindow, APauseAndAFullConnectionKeepEverythingBack) {
  AnswerWindow window;
  window.set_paused(true);
  EXPECT_FALSE(window.may_send() || window.settled());
  window.set_blocked(true);
  window.set_paused(false);
  EXPECT_FALSE(window.may_send() || window.settled());
  window.set_blocked(false);
  EXPECT_TRUE(window.may_send() && window.settled());
}

}  // namespace
}  // namespace aucast::protocol

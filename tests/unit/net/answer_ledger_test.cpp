#include "client/net/answer_ledger.h"

#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <variant>

#include "tests/support/manual_clock.h"

namespace aucast::net {
namespace {

using namespace std::chrono_literals;
using aucast::test::ManualClock;

/// A ledger beside a session that somebody streams to.
class Ledger : public ::testing::Test {
 protected:
  static protocol::ClientSession session(bool negotiate) {
    protocol::ClientSessionOptions options;
    options.negotiate = negotiate;
    options.hello.window = 32;
    return protocol::ClientSession(std::move(options));
  }

  void connect(bool negotiate) {
    session_ = session(negotiate);
    static_cast<void>(session_.on_connected(clock_.now()));
    if (negotiate) get("{hello v=2 window=32 keyframe=40}");
  }
  void get(std::string_view bytes) {
    while (!bytes.empty()) {
      for (const auto& event : session_.on_bytes(bytes)) {
        if (std::holds_alternative<protocol::DeliverKeyframe>(event)) ledger_.owe(clock_.now());
      }
    }
  }
  /// What is said now. That something is said is told before, and that nothing is left after.
  std::string speak() {
    const bool expected = ledger_.has_output(session_, wishes_, clock_.now());
    std::string words = ledger_.speak(session_, wishes_, clock_.now());
    EXPECT_EQ(expected, !words.empty()) << words;
    EXPECT_FALSE(ledger_.has_output(session_, wishes_, clock_.now())) << "after " << words;
    return words;
  }

  ManualClock clock_;
  protocol::ClientSession session_ = session(true);
  AnswerLedger ledger_;
  AnswerLedger::Wishes wishes_;
};

TEST_F(Ledger, EveryKeyframeIsAnswered) {
  for (const bool negotiate : {false, true}) {
    connect(negotiate);
    EXPECT_EQ(speak(), "");
    get("{6}");
    EXPECT_EQ(speak(), "1");
    get("{6}{12}{1}");
    EXPECT_EQ(speak(), "111");
  }
}

TEST_F(Ledger, InClassicAPauseStandsForAnAnswerAndSoDoesItsEnd) {
  connect(false);
  wishes_.user_paused = true;
  EXPECT_EQ(speak(), "") << "nothing is there that it could answer";
  get("{6}");
  EXPECT_EQ(speak(), "-1");
  EXPECT_EQ(ledger_.pauses_sent(), 1U);
  wishes_.user_paused = false;
  EXPECT_EQ(speak(), "-3");
  EXPECT_EQ(ledger_.resumes_sent(), 1U);
  get("{12}");
  EXPECT_EQ(speak(), "1");
}

TEST_F(Ledger, InClassicTheLastKeyframeThereIsRoomForIsAnsweredWhenThereIsMore) {
  connect(false);
  get("{6}{12}{1}");
  wishes_.full = true;
  EXPECT_EQ(speak(), "11-1") << "a server that sends ahead of the answers";
  EXPECT_EQ(speak(), "");
  wishes_.full = false;
  EXPECT_EQ(speak(), "-3");
}

TEST_F(Ledger, InLevelTwoThePauseComesBeforeTheAnswers) {
  connect(true);
  get("{6}{12}");
  wishes_.full = true;
  EXPECT_EQ(speak(), "-111");
  get("{1}");
  EXPECT_EQ(speak(), "1") << "what was on its way";
  wishes_.user_paused = true;
  wishes_.full = false;
  EXPECT_EQ(speak(), "") << "it is paused already";
  wishes_.user_paused = false;
  EXPECT_EQ(speak(), "-3");
}

TEST_F(Ledger, WithAVoiceAnswersWaitForEachOther) {
  connect(true);
  wishes_.voice = true;
  get("{6}");
  EXPECT_EQ(speak(), "");
  const auto due = ledger_.deadline(session_, wishes_, clock_.now());
  ASSERT_TRUE(due.has_value());
  EXPECT_EQ(*due - clock_.now(), 250ms);
  clock_.advance(249ms);
  get("{12}");
  EXPECT_EQ(speak(), "");
  EXPECT_EQ(ledger_.deadline(session_, wishes_, clock_.now()), due) << "of the first one";
  clock_.advance(1ms);
  EXPECT_EQ(speak(), "11");
  EXPECT_FALSE(ledger_.deadline(session_, wishes_, clock_.now()).has_value());

  get("{6}{6}{6}{6}{6}{6}{6}");
  EXPECT_EQ(speak(), "");
  get("{6}");
  EXPECT_EQ(speak(), "11111111") << "a quarter of the window";
  get("{6}");
  wishes_.user_paused = true;
  EXPECT_EQ(speak(), "-11") << "a pause waits for nothing";
}

TEST_F(Ledger, InClassicAVoiceMakesNothingWait) {
  connect(false);
  wishes_.voice = true;
  get("{6}");
  EXPECT_EQ(speak(), "1");
}

TEST_F(Ledger, WhatALostConnectionWasOwedIsOwedNoMore) {
  connect(true);
  get("{6}{12}");
  ledger_.forget();
  EXPECT_EQ(speak(), "");
}

TEST_F(Ledger, HasRoomUpToItsLimit) {
  connect(false);
  for (std::size_t i = 0; i < protocol::kOwedAnswersMax; ++i) {
    EXPECT_TRUE(ledger_.has_room());
    get("{6}");
  }
  EXPECT_FALSE(ledger_.has_room());
  EXPECT_EQ(speak(), std::string(protocol::kOwedAnswersMax, '1'));
  EXPECT_TRUE(ledger_.has_room());
}

}  // namespace
}  // namespace aucast::net

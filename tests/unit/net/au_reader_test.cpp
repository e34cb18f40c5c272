#include "client/net/au_reader.h"

#include <vector>

#include <gtest/gtest.h>

#include "tests/support/manual_clock.h"
#include "tests/unit/net/reader_options.h"

namespace aucast::net {
namespace {

using namespace std::chrono_literals;
using aucast::test::ManualClock;
using playback::EndReason;
using Next = Reaction::Next;
using Aus = std::vector<int>;

constexpr playback::BufferOptions kTiny{1, 1, 100};
/// Plays from the second keyframe on, and has room for whatever a test sends.
constexpr playback::BufferOptions kEager{100, 100, 1};

/// The reader with a clock and the words it has said.
class Reading {
 public:
  explicit Reading(playback::BufferOptions buffers, bool classic = false)
      : reader(test::reader_options(classic, buffers)) {
    said = reader.connected(clock.now()).send;
  }

  /// What the reader answers to these bytes.
  std::string feed(std::string_view bytes) {
    clock.advance(1ms);
    last = reader.received(bytes, clock.now());
    return last.send;
  }
  std::string close() {
    last = reader.closed(clock.now());
    return last.send;
  }
  std::string speak() {
    return reader.has_output() ? reader.speak(clock.now()).send : "(nothing to say)";
  }

  /// The first AU of the next keyframe, 0 when there is none.
  int take() {
    const auto keyframe = reader.take();
    if (!keyframe) return 0;
    for (int au = 1; au < kAuCount; ++au) {
      if (keyframe->aus.left[static_cast<std::size_t>(au)] > 0) return au;
    }
    return -1;
  }
  Aus take_all() {
    Aus all;
    while (const int au = take()) all.push_back(au);
    return all;
  }

  ManualClock clock;
  AuReader reader;
  std::string said;
  Reaction last;
};

constexpr std::string_view kGrantFour = "{hello v=2 window=4 keyframe=100}";

TEST(AuReader, SaysNothingFirstInClassic) {
  Reading reading(kEager, true);
  EXPECT_EQ(reading.said, "");
  EXPECT_TRUE(reading.reader.status().connected);
}

TEST(AuReader, AsksForAWindowThatTheBufferHolds) {
  EXPECT_NE(Reading({100, 30, 40}).said.find(" window=64"), std::string::npos);
  EXPECT_NE(Reading({8, 4, 40}).said.find(" window=8"), std::string::npos);
}

TEST(AuReader, AnswersEachPacketInClassic) {
  Reading reading({100, 30, 40}, true);
  EXPECT_EQ(reading.feed("{1,6,12,14}"), "1");
  EXPECT_EQ(reading.feed("{1,4,1"), "");
  EXPECT_EQ(reading.feed("5,23}"), "1");
  EXPECT_FALSE(reading.reader.ready()) << "below the threshold";
  EXPECT_EQ(reading.feed("{-2}"), "");
  EXPECT_EQ(reading.last.next, Next::Close);
  EXPECT_TRUE(reading.reader.ready());

  const auto status = reading.reader.status();
  EXPECT_EQ(status.end, EndReason::EndOfStream);
  EXPECT_FALSE(status.connected);
  EXPECT_EQ(status.keyframes_received, 2U);
  EXPECT_EQ(status.bytes_received, 22U);
  EXPECT_DOUBLE_EQ(status.receive_seconds, 0.004);
  const auto keyframe = reading.reader.take();
  ASSERT_TRUE(keyframe);
  EXPECT_EQ(keyframe->aus, frame_from_terms(std::vector<AuTerm>{{1}, {6}, {12}, {14}}));
  EXPECT_FALSE(keyframe->time);
}

TEST(AuReader, TakesTheTimesOfLevel2) {
  Reading reading(kEager);
  EXPECT_EQ(reading.feed(kGrantFour), "");
  EXPECT_TRUE(reading.reader.status().negotiated);
  EXPECT_EQ(reading.reader.status().keyframe_time, 100ms);
  EXPECT_EQ(reading.feed("{12:80;40@0}"), "1");
  reading.feed("{-2}");
  const auto keyframe = reading.reader.take();
  ASSERT_TRUE(keyframe);
  EXPECT_EQ(keyframe->time, 40ms);
  EXPECT_FLOAT_EQ(keyframe->aus.left[12], 0.8F);
}

// === A hello that a classic server does not know.

TEST(AuReader, KeepsTheFirstClassicPacketAsideAfterAHello) {
  Reading reading(kEager);
  EXPECT_EQ(reading.feed("{1}"), "1") << "without an answer no second one would come";
  EXPECT_FALSE(reading.reader.ready());
  EXPECT_EQ(reading.feed("{2}"), "1");
  EXPECT_TRUE(reading.reader.ready());
  EXPECT_EQ(reading.feed("{4}{-2}"), "1");
  EXPECT_EQ(reading.take_all(), (Aus{1, 2, 4}));
  EXPECT_FALSE(reading.reader.status().negotiated);
}

TEST(AuReader, PlaysTheOnlyPacketAtTheEnd) {
  Reading reading(kEager);
  EXPECT_EQ(reading.feed("{1}"), "1");
  reading.feed("{-2}");
  EXPECT_EQ(reading.take_all(), Aus{1});
  EXPECT_TRUE(reading.reader.ready());
}

TEST(AuReader, StartsAgainInClassicAndShowsNothingTwice) {
  Reading reading(kEager);
  reading.feed("{1}");
  reading.close();
  EXPECT_EQ(reading.last.next, Next::Reconnect);
  EXPECT_EQ(reading.reader.status().end, EndReason::NotEnded);
  EXPECT_EQ(reading.reader.status().keyframes_received, 0U) << "what came has been dropped";
  EXPECT_EQ(reading.reader.connected(reading.clock.now()).send, "") << "no hello now";
  for (const auto* packet : {"{1}", "{2}", "{4}"}) EXPECT_EQ(reading.feed(packet), "1");
  reading.feed("{-2}");
  EXPECT_EQ(reading.take_all(), (Aus{1, 2, 4}));
  EXPECT_EQ(reading.reader.status().keyframes_received, 3U);
}

TEST(AuReader, WhatWasDroppedAtTheStartTookNoTime) {
  Reading reading(kEager);
  reading.feed("{1}");
  reading.close();
  static_cast<void>(reading.reader.connected(reading.clock.now()));
  reading.feed("{1}{2}{-2}");
  const auto first = reading.reader.take();
  ASSERT_TRUE(first);
  EXPECT_EQ(first->place, first->span);
}

TEST(AuReader, DoesNotReconnectTwice) {
  Reading reading(kEager);
  reading.feed("{1}");
  reading.close();
  static_cast<void>(reading.reader.connected(reading.clock.now()));
  reading.feed("{1}");
  reading.close();
  EXPECT_EQ(reading.last.next, Next::Close);
  EXPECT_EQ(reading.reader.status().end, EndReason::ConnectionLost);
  EXPECT_EQ(reading.take_all(), Aus{1}) << "what was received stays playable";
}

// === Full buffers and the user's pause, in classic.

TEST(AuReader, PausesInsteadOfAnsweringWhenBothBuffersAreFull) {
  Reading reading(kTiny, true);
  EXPECT_EQ(reading.feed("{1}"), "1");
  EXPECT_EQ(reading.feed("{2}"), "1");
  EXPECT_EQ(reading.feed("{4}"), "-1");
  EXPECT_TRUE(reading.reader.status().paused);
  EXPECT_EQ(reading.speak(), "(nothing to say)");
  EXPECT_EQ(reading.take(), 1);
  EXPECT_EQ(reading.speak(), "-3");
  EXPECT_FALSE(reading.reader.status().paused);
  EXPECT_EQ(reading.feed("{5}"), "-1");
  EXPECT_EQ(reading.take(), 2);
  EXPECT_EQ(reading.speak(), "-3");
  reading.feed("{-2}");
  EXPECT_EQ(reading.take_all(), (Aus{4, 5}));
  EXPECT_EQ(reading.reader.status().pauses_sent, 2U);
  EXPECT_EQ(reading.reader.status().resumes_sent, 2U);
}

TEST(AuReader, CallsForSpeakOnceUntilItHasSpoken) {
  Reading reading(kTiny, true);
  for (const auto* packet : {"{1}", "{2}", "{4}"}) reading.feed(packet);
  EXPECT_FALSE(reading.reader.calls_for_speak());
  reading.take();
  EXPECT_TRUE(reading.reader.calls_for_speak());
  EXPECT_FALSE(reading.reader.calls_for_speak()) << "one is on its way";
  EXPECT_EQ(reading.speak(), "-3");
  EXPECT_EQ(reading.feed("{5}"), "-1");
  reading.take();
  EXPECT_TRUE(reading.reader.calls_for_speak()) << "again";
  static_cast<void>(reading.reader.connected(reading.clock.now()));
  EXPECT_TRUE(reading.reader.calls_for_speak()) << "the last connection's call was in vain";
}

TEST(AuReader, PlaysTheKeptKeyframeWhenTheConnectionIsLost) {
  Reading reading(kTiny, true);
  for (const auto* packet : {"{1}", "{2}", "{4}"}) reading.feed(packet);
  reading.close();
  EXPECT_EQ(reading.reader.status().end, EndReason::ConnectionLost);
  EXPECT_EQ(reading.take_all(), (Aus{1, 2, 4}));
  EXPECT_TRUE(reading.reader.ready());
  EXPECT_EQ(reading.speak(), "(nothing to say)");
}

TEST(AuReader, DefersTheUsersPauseToTheNextPacketInClassic) {
  Reading reading(kEager, true);
  EXPECT_EQ(reading.feed("{1}"), "1");
  reading.reader.set_paused(true);
  EXPECT_TRUE(reading.reader.status().paused);
  EXPECT_EQ(reading.speak(), "(nothing to say)");
  EXPECT_EQ(reading.feed("{2}"), "-1");
  EXPECT_EQ(reading.take_all(), (Aus{1, 2})) << "what is buffered plays on";
  EXPECT_EQ(reading.speak(), "(nothing to say)");
  reading.reader.set_paused(false);
  EXPECT_EQ(reading.speak(), "-3");
  EXPECT_EQ(reading.feed("{4}"), "1");
  EXPECT_EQ(reading.reader.status().pauses_sent, 1U);
  EXPECT_EQ(reading.reader.status().resumes_sent, 1U);
}

TEST(AuReader, APauseTakenBackInTimeSaysNothing) {
  Reading reading(kEager, true);
  EXPECT_EQ(reading.feed("{1}"), "1");
  reading.reader.set_paused(true);
  reading.reader.set_paused(false);
  EXPECT_EQ(reading.speak(), "(nothing to say)");
  EXPECT_EQ(reading.feed("{2}"), "1");
  EXPECT_EQ(reading.reader.status().pauses_sent, 0U);
}

TEST(AuReader, ResumesOnlyWhenTheUserAndTheBuffersAgree) {
  Reading reading(kTiny, true);
  reading.feed("{1}");
  reading.feed("{2}");
  EXPECT_EQ(reading.feed("{4}"), "-1");
  reading.reader.set_paused(true);
  EXPECT_EQ(reading.take(), 1);
  EXPECT_EQ(reading.speak(), "(nothing to say)") << "room, but the user";
  reading.reader.set_paused(false);
  EXPECT_EQ(reading.speak(), "-3");
}

TEST(AuReader, PausesOverTheKeptFirstPacket) {
  Reading reading(kEager);
  reading.reader.set_paused(true);
  EXPECT_EQ(reading.feed("{1}"), "-1");
  reading.reader.set_paused(false);
  EXPECT_EQ(reading.speak(), "-3");
  EXPECT_EQ(reading.feed("{2}"), "1");
  EXPECT_EQ(reading.take_all(), (Aus{1, 2}));
}

TEST(AuReader, BearsAServerThatDoesNotWaitForAnswers) {
  Reading reading(kTiny, true);
  std::string flood;
  for (int i = 0; i < 600; ++i) flood += "{7}";
  reading.feed(flood + "{-2}");
  EXPECT_FALSE(reading.reader.wants_bytes()) << "the rest is for TCP to hold";
  int taken = 0;
  while (reading.take() != 0) {
    ++taken;
    reading.speak();
  }
  EXPECT_EQ(taken, 600);
  EXPECT_EQ(reading.reader.status().end, EndReason::EndOfStream);
}

TEST(AuReader, BearsSuchAServerWhileTheUserPauses) {
  Reading reading({1000, 30, 1}, true);
  reading.reader.set_paused(true);
  std::string flood;
  for (int i = 0; i < 600; ++i) flood += "{7}";
  EXPECT_EQ(reading.feed(flood), "-1");
  EXPECT_FALSE(reading.reader.wants_bytes());
  reading.reader.set_paused(false);
  EXPECT_TRUE(reading.speak().starts_with("-31"));
  EXPECT_TRUE(reading.reader.wants_bytes());
  EXPECT_EQ(reading.reader.status().keyframes_received, 600U);
}

// === Full buffers, in level 2.

TEST(AuReader, PausesBeforeItAnswersWhenBothBuffersAreFullAndKeepsWhatIsUnderWay) {
  Reading reading({2, 1, 100});
  reading.feed("{hello v=2 window=2}");
  EXPECT_EQ(reading.feed("{1}{2}"), "11");
  EXPECT_EQ(reading.feed("{4}"), "1") << "case B: a full receiver fills the playout";
  EXPECT_EQ(reading.feed("{5}"), "-11") << "case A";
  EXPECT_EQ(reading.feed("{6}"), "1") << "still under way when the server heard of it";
  EXPECT_EQ(reading.take(), 1);
  EXPECT_EQ(reading.speak(), "(nothing to say)") << "another one is kept aside";
  EXPECT_EQ(reading.take(), 2);
  EXPECT_EQ(reading.speak(), "-3");
  EXPECT_EQ(reading.take_all(), (Aus{4, 5, 6}));
  EXPECT_EQ(reading.reader.status().pauses_sent, 1U);
  EXPECT_EQ(reading.reader.status().resumes_sent, 1U);
}

TEST(AuReader, TakesNoMoreThanTheWindowFromAServerThatIgnoresThePause) {
  Reading reading({1, 1, 100});
  reading.feed("{hello v=2 window=1}");
  for (int i = 0; i < 20; ++i) reading.feed("{7}");
  EXPECT_EQ(reading.reader.status().keyframes_received, 3U) << "playout, receiver, kept aside";
  EXPECT_FALSE(reading.reader.wants_bytes()) << "the rest is for TCP to hold";
  int taken = 0;
  while (reading.take() != 0) {
    ++taken;
    reading.speak();
  }
  EXPECT_EQ(taken, 20);
}

TEST(AuReader, KeepsTheThresholdWhateverTheWindow) {
  Reading reading({64, 30, 40});
  reading.feed("{hello v=2 window=64}");
  for (int i = 0; i < 26; ++i) EXPECT_EQ(reading.feed("{9}"), "1");
  EXPECT_FALSE(reading.reader.ready());
  EXPECT_EQ(reading.feed("{9}"), "1");
  EXPECT_TRUE(reading.reader.ready()) << "40 of 100 of the receiver were there";
  EXPECT_EQ(reading.reader.status().pauses_sent, 0U);
}

TEST(AuReader, TheUserPausesAtOnceInLevel2) {
  Reading reading(kEager);
  reading.feed(kGrantFour);
  reading.feed("{1}");
  reading.reader.set_paused(true);
  EXPECT_EQ(reading.speak(), "-1");
  EXPECT_EQ(reading.speak(), "(nothing to say)");
  EXPECT_EQ(reading.feed("{2}"), "1") << "was under way, and is stored";
  reading.reader.set_paused(false);
  EXPECT_EQ(reading.speak(), "-3");
}

TEST(AuReader, APauseBeforeTheGrantIsSaidWithTheFirstPacket) {
  Reading reading(kEager);
  reading.reader.set_paused(true);
  EXPECT_EQ(reading.speak(), "(nothing to say)") << "nothing may come between hello and grant";
  EXPECT_EQ(reading.feed(std::string(kGrantFour) + "{1}"), "-11");
}

// === Ends.

TEST(AuReader, AnEmptyStreamIsTheEnd) {
  Reading reading(kEager);
  reading.feed("{-2}");
  EXPECT_EQ(reading.last.next, Next::Close);
  EXPECT_EQ(reading.reader.status().end, EndReason::EndOfStream);
  EXPECT_TRUE(reading.reader.ready());
  EXPECT_EQ(reading.take(), 0);
}

TEST(AuReader, TellsOfGarbage) {
  Reading reading(kEager, true);
  reading.feed("{1}{2}");
  reading.feed("\x1b[31m");
  const auto status = reading.reader.status();
  EXPECT_EQ(reading.last.next, Next::Close);
  EXPECT_EQ(status.end, EndReason::ProtocolError);
  EXPECT_TRUE(status.detail.starts_with("server:4650: the server sent")) << status.detail;
  EXPECT_NE(status.detail.find("\\x1b"), std::string::npos) << status.detail;
  EXPECT_EQ(status.detail.find('\x1b'), std::string::npos);
  EXPECT_EQ(reading.take_all(), (Aus{1, 2}));
}

TEST(AuReader, TellsOfARefusal) {
  Reading reading(kEager);
  reading.feed("{error 404 no such stream}");
  const auto status = reading.reader.status();
  EXPECT_EQ(status.end, EndReason::Refused);
  EXPECT_EQ(status.refusal, 404);
  EXPECT_NE(status.detail.find("server:4650: the server refused"), std::string::npos)
      << status.detail;
  EXPECT_NE(status.detail.find("no such stream"), std::string::npos) << status.detail;
}

TEST(AuReader, IsRefusedWhenNoHostIsLeftThatHasRoom) {
  AuReaderOptions options;
  options.peer = "a:4650 or b:4650";
  options.reconnect = true;
  options.hosts = 2;
  ManualClock clock;
  AuReader reader(options);
  (void)reader.connected(clock.now());
  EXPECT_EQ(reader.received("{error 503 the server is full}", clock.now()).next,
            Next::ReconnectLater)
      << "the other may have room";
  (void)reader.connected(clock.now());
  EXPECT_EQ(reader.received("{error 503 the stream has not come yet}", clock.now()).next,
            Next::Close);
  EXPECT_EQ(reader.status().end, EndReason::Refused);
}

TEST(AuReader, GivesUpWhenNoHostCouldBeReachedAtFirst) {
  AuReaderOptions options;
  options.peer = "a:4650 or b:4650";
  options.reconnect = true;
  options.one_round = true;
  options.hosts = 2;
  AuReader in_vain(options);
  EXPECT_EQ(in_vain.unreachable("cannot reach a").next, Next::ReconnectLater);
  EXPECT_EQ(in_vain.unreachable("cannot reach b").next, Next::Close);
  EXPECT_EQ(in_vain.status().end, EndReason::Unreachable);

  ManualClock clock;
  AuReader begun(options);
  (void)begun.connected(clock.now());
  (void)begun.received("{1}{2}", clock.now());
  EXPECT_EQ(begun.closed(clock.now()).next, Next::ReconnectLater);
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(begun.unreachable("cannot reach it").next, Next::ReconnectLater)
        << "the stream has begun, and the face holds";
  }
  AuReader waiting(options);
  (void)waiting.connected(clock.now());
  (void)waiting.received("{hello v=2 window=4 live=1 keyframe=250}", clock.now());
  EXPECT_EQ(waiting.closed(clock.now()).next, Next::ReconnectLater);
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(waiting.unreachable("cannot reach it").next, Next::ReconnectLater)
        << "a live stream may begin hours after its server";
  }
}

TEST(AuReader, TellsOfSilence) {
  Reading reading(kEager);
  ASSERT_TRUE(reading.reader.deadline());
  EXPECT_EQ(*reading.reader.deadline(), reading.clock.now() + 10s);
  reading.clock.advance(10s);
  EXPECT_EQ(reading.reader.time(reading.clock.now()).next, Next::Close);
  EXPECT_EQ(reading.reader.status().end, EndReason::Unreachable);
  EXPECT_NE(reading.reader.status().detail.find("server:4650: nothing came"), std::string::npos);
  EXPECT_FALSE(reading.reader.deadline());
}

TEST(AuReader, TellsOfALostConnection) {
  Reading reading(kEager, true);
  reading.feed("{1}{2");
  reading.close();
  EXPECT_EQ(reading.reader.status().end, EndReason::ConnectionLost);
  EXPECT_NE(
      reading.reader.status().detail.find("server:4650: the connection ended within a packet"),
      std::string::npos);
  EXPECT_EQ(reading.take_all(), Aus{1});
}

TEST(AuReader, GivesNothingAfterLeaving) {
  Reading reading(kEager, true);
  reading.feed("{1}{2}");
  ASSERT_TRUE(reading.reader.ready());
  reading.reader.leave();
  EXPECT_EQ(reading.take(), 0);
  EXPECT_TRUE(reading.reader.ready());
  EXPECT_EQ(reading.reader.status().end, EndReason::Stopped);
  EXPECT_EQ(reading.reader.farewell(), "-4");
  EXPECT_EQ(reading.feed("{4}"), "");
  EXPECT_EQ(reading.reader.status().end, EndReason::Stopped);
}

TEST(AuReader, LeavingAfterTheLastKeyframeKeepsTheEnd) {
  Reading reading(kEager, true);
  reading.feed("{1}");
  reading.feed("{-2}");
  EXPECT_EQ(reading.take_all(), Aus{1});
  reading.reader.leave();
  EXPECT_EQ(reading.reader.status().end, EndReason::EndOfStream);
}

TEST(AuReader, TheFirstReasonOfTheEndStays) {
  AuReader reader(test::reader_options(false, kEager));
  reader.unreachable("cannot reach server:4650: no route");
  reader.unreachable("something else");
  EXPECT_EQ(reader.status().end, EndReason::Unreachable);
  EXPECT_EQ(reader.status().detail, "cannot reach server:4650: no route");
  EXPECT_TRUE(reader.ready());
}

}  // namespace
}  // namespace aucast::net

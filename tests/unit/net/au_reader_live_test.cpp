// The reader with a live stream, and with connections that are lost.

#include <gtest/gtest.h>

#include "client/net/au_reader.h"
#include "tests/support/manual_clock.h"

namespace aucast::net {
namespace {

using namespace std::chrono_literals;
using aucast::test::ManualClock;
using playback::EndReason;
using Next = Reaction::Next;

const std::string kLow = "{hello v=2 window=0 delta=1 live=1 keyframe=200}";
const std::string kLive = "{hello v=2 window=4 delta=1 live=1 keyframe=200}";

class LiveReading : public ::testing::Test {
 protected:
  void start(AuReaderOptions options) {
    options.peer = "server:4650";
    reader_.emplace(std::move(options));
    said_ = reader_->connected(clock_.now()).send;
  }
  std::string feed(std::string_view bytes) {
    clock_.advance(1ms);
    last_ = reader_->received(bytes, clock_.now());
    return last_.send;
  }
  Reaction close() { return last_ = reader_->closed(clock_.now()); }
  [[nodiscard]] playback::SourceStatus status() const { return reader_->status(); }

  ManualClock clock_;
  std::optional<AuReader> reader_;
  std::string said_;
  Reaction last_;
};

TEST_F(LiveReading, AsksForChangesOnlyAndResolvesThem) {
  start({});
  EXPECT_EQ(said_, "{hello v=2 window=64 delta=1}");
  EXPECT_EQ(feed(kLive + "{1,6;200}{~6:0;200}"), "11");
  EXPECT_TRUE(status().live);
  EXPECT_EQ(reader_->take()->aus, frame_from_terms(std::vector<AuTerm>{{1}, {6}}));
  EXPECT_EQ(reader_->take()->aus, frame_from_terms(std::vector<AuTerm>{{1}}));
}

TEST_F(LiveReading, PlaysAfterTheDelayAndNotTheThreshold) {
  start({});
  feed(kLive + "{1}");
  EXPECT_FALSE(reader_->ready());
  feed("{2}");
  EXPECT_TRUE(reader_->ready()) << "2 x 200 ms";
}

TEST_F(LiveReading, TakesTheSpeedForUntimedKeyframes) {
  AuReaderOptions options;
  options.speed = 100ms;
  start(options);
  feed(kLive + "{1}{2}");
  EXPECT_FALSE(reader_->ready());
  feed("{4}");
  EXPECT_TRUE(reader_->ready()) << "3 x 100 ms";
}

TEST_F(LiveReading, NeverPausesALiveStreamForRoom) {
  AuReaderOptions options;
  options.buffers = {4, 1, 100};
  start(options);
  feed(kLive);
  for (int i = 0; i < 50; ++i) EXPECT_EQ(feed("{1}"), "1");
  EXPECT_EQ(status().pauses_sent, 0U);
  EXPECT_GE(status().keyframes_dropped, 40U);
}

TEST_F(LiveReading, IsAStreamWithAThresholdWhenNotLive) {
  start({});
  feed("{hello v=2 window=4}{1}{2}{4}");
  EXPECT_FALSE(status().live);
  EXPECT_FALSE(reader_->ready());
}

class LowDelay : public LiveReading {
 protected:
  LowDelay() {
    AuReaderOptions options;
    options.buffers.low_delay = true;
    options.buffers.adapt = true;
    start(options);
  }
};

TEST_F(LowDelay, PlaysWithTheFirstKeyframeAndSaysWhenItIsDue) {
  feed(kLow + "{1}");
  ASSERT_TRUE(reader_->ready());
  const auto first = reader_->take();
  EXPECT_EQ(first->arrived, clock_.now());
  EXPECT_GE(*first->due - clock_.now(), 200ms);
  EXPECT_LE(*first->due - clock_.now(), 205ms);
  EXPECT_EQ(status().delay, 202ms);
  clock_.advance(39ms);
  feed("{1;40}");
  EXPECT_EQ(reader_->take()->arrived, clock_.now()) << "one by one";
}

TEST_F(LowDelay, GoesByTheTimesAndPlacesOfTheStream) {
  feed(kLow + "{1;40@5000}");
  clock_.advance(119ms);
  feed("{2;40@5120}");  // two were left out
  static_cast<void>(reader_->take());
  EXPECT_EQ(*reader_->take()->due, clock_.now() + 42ms);
}

TEST_F(LowDelay, SkipsToThePresentWhileTheFaceStands) {
  feed(kLow);
  for (int i = 0; i < 100; ++i) {
    clock_.advance(39ms);
    feed("{1;40}");
    static_cast<void>(reader_->take());
  }
  EXPECT_FALSE(reader_->take());
  clock_.advance(2s);
  std::string burst;
  for (int i = 0; i < 50; ++i) burst += i == 49 ? "{9;40}" : "{2;40}";
  EXPECT_EQ(feed(burst), "") << "with window=0 nothing is answered";
  std::optional<playback::Keyframe> last;
  int left = 0;
  while (const auto next = reader_->take()) {
    last = next;
    ++left;
  }
  EXPECT_LE(left, 3);
  ASSERT_TRUE(last);
  EXPECT_EQ(last->aus.left[9], 1.0F) << "the newest is what counts";
  EXPECT_EQ(status().keyframes_dropped, 50U - static_cast<unsigned>(left));
}

TEST_F(LowDelay, AsksForALiveStreamWithoutAnswers) {
  EXPECT_EQ(said_, "{hello v=2 window=0 delta=1}");
  EXPECT_EQ(feed(kLow + "{1;40}{2;40}"), "");
  EXPECT_FALSE(reader_->has_output());
  reader_->set_paused(true);
  EXPECT_EQ(reader_->speak(clock_.now()).send, "-1");
  reader_->set_paused(false);
  EXPECT_EQ(reader_->speak(clock_.now()).send, "-3");
}

TEST_F(LowDelay, AServerThatWantsAnswersGetsThem) {
  EXPECT_EQ(feed("{hello v=2 window=1 live=1 keyframe=200}{1;40}"), "1");
}

TEST_F(LowDelay, TakesARecordedStreamWithAWindowOverAnotherConnection) {
  EXPECT_EQ(feed("{hello v=2 window=1 keyframe=200}{1}"), "");
  EXPECT_EQ(last_.next, Next::Reconnect);
  EXPECT_EQ(reader_->connected(clock_.now()).send, "{hello v=2 window=64 delta=1}");
  EXPECT_EQ(feed("{hello v=2 window=4 keyframe=200}{1}{2}"), "11");
  EXPECT_FALSE(reader_->ready()) << "the threshold holds";
  EXPECT_EQ(status().keyframes_received, 2U);
  static_cast<void>(close());
  EXPECT_FALSE(reader_->take()->due);
}

TEST_F(LowDelay, BeginsAgainAfterThePauseOfTheUser) {
  feed(kLow + "{1;40}{1;40}");
  reader_->set_paused(true);
  clock_.advance(10s);
  reader_->set_paused(false);
  while (reader_->take()) {
  }
  feed("{1;40}");
  EXPECT_EQ(*reader_->take()->due, clock_.now() + 42ms) << "and not ten seconds ago";
}

TEST_F(LiveReading, SaysWhenKeyframesCame) {
  start({});
  feed(kLive + "{1}{2}");
  EXPECT_EQ(reader_->take()->arrived, clock_.now());
  EXPECT_FALSE(reader_->take()->due);
}

class Reconnecting : public LiveReading {
 protected:
  Reconnecting() {
    AuReaderOptions options;
    options.reconnect = true;
    start(options);
  }
};

TEST_F(Reconnecting, HoldsAndTriesAgainAfterALoss) {
  feed("{hello v=2 window=4 keyframe=200}{1}{2}");
  EXPECT_EQ(close().next, Next::ReconnectLater);
  EXPECT_EQ(last_.retry_after, 1s);
  EXPECT_EQ(status().end, EndReason::NotEnded);
  EXPECT_FALSE(status().connected);
  EXPECT_NE(status().detail.find("trying again in 1 s"), std::string::npos) << status().detail;
  EXPECT_EQ(reader_->take()->aus.left[1], 1.0F) << "what was there plays, below the threshold too";
  EXPECT_EQ(reader_->take()->aus.left[2], 1.0F);
  EXPECT_FALSE(reader_->ready()) << "the face holds";

  EXPECT_EQ(reader_->connected(clock_.now()).send, "{hello v=2 window=64 delta=1 from=400}")
      << "level 2 is tried anew, from where it was";
  EXPECT_EQ(feed("{hello v=2 window=4 keyframe=200 from=400}{4}{-2}"), "1");
  EXPECT_EQ(reader_->take()->aus.left[4], 1.0F);
  EXPECT_EQ(status().end, EndReason::EndOfStream);
  EXPECT_EQ(status().keyframes_received, 3U);
  EXPECT_EQ(status().reconnects, 1U);
}

TEST_F(Reconnecting, WaitsLongerEachTimeUntilSomethingComes) {
  for (const auto wait : {1s, 2s, 4s}) {
    const Reaction reaction = reader_->unreachable("cannot reach server:4650");
    EXPECT_EQ(reaction.next, Next::ReconnectLater);
    EXPECT_EQ(reaction.retry_after, wait);
  }
  static_cast<void>(reader_->connected(clock_.now()));
  feed("{hello v=2 window=4}{1}");
  EXPECT_EQ(close().retry_after, 1s);
}

TEST_F(Reconnecting, CountsThePlaceOverSeveralLosses) {
  feed("{hello v=2 window=4 keyframe=200}{1;100}{2}");
  close();
  EXPECT_EQ(reader_->connected(clock_.now()).send, "{hello v=2 window=64 delta=1 from=300}");
  feed("{hello v=2 window=4 keyframe=200 from=300}{4;1000}");
  close();
  EXPECT_EQ(reader_->connected(clock_.now()).send, "{hello v=2 window=64 delta=1 from=1300}");
  // A server that knows no places begins again.
  feed("{hello v=2 window=4 keyframe=200}{1;100}");
  close();
  EXPECT_EQ(reader_->connected(clock_.now()).send, "{hello v=2 window=64 delta=1 from=100}");
}

TEST_F(Reconnecting, JoinsALiveStreamWhereItIs) {
  feed(kLive + "{1;200}{2;200}");
  close();
  EXPECT_EQ(reader_->connected(clock_.now()).send, said_);
}

/// Ends the connection, and the one after it as a classic server does that is sent a hello; then
/// there is one without a hello.
class FallingBack : public Reconnecting {
 protected:
  void fall_back() {
    EXPECT_EQ(close().next, Next::ReconnectLater);
    EXPECT_NE(reader_->connected(clock_.now()).send, "");
    EXPECT_EQ(close().next, Next::Reconnect);
    EXPECT_EQ(reader_->connected(clock_.now()).send, "");
  }
};

TEST_F(FallingBack, TakesNoClassicServerForTheLiveOneBeforeIt) {
  AuReaderOptions options;
  options.reconnect = true;
  options.voice = true;
  options.captions = true;
  start(options);
  feed(
      "{hello v=2 window=4 live=1 keyframe=200 stream=talk title=QSB0YWxr voice=opus text=1}"
      "{1}{1}");
  ASSERT_TRUE(status().live && status().voice && status().captions);
  ASSERT_EQ(status().stream, "talk");
  ASSERT_EQ(status().title, "A talk");
  while (reader_->take()) {
  }
  fall_back();
  EXPECT_EQ(feed("{2}"), "1");
  EXPECT_FALSE(status().live || status().voice || status().captions);
  EXPECT_EQ(status().stream, "");
  EXPECT_EQ(status().title, "");
  EXPECT_EQ(status().keyframe_time, 250ms);
  EXPECT_FALSE(status().negotiated);
  feed("{-2}");
  EXPECT_FALSE(reader_->take()->arrived) << "only a live one says when";
}

TEST_F(FallingBack, CountsThePlaceFromTheClassicBeginning) {
  feed("{hello v=2 window=4 keyframe=200}{1}{2}");
  fall_back();
  feed("{4}");
  close();
  EXPECT_EQ(reader_->connected(clock_.now()).send, "{hello v=2 window=64 delta=1 from=250}");
}

TEST_F(FallingBack, KeepsThePlaceUntilAKeyframeComes) {
  feed("{hello v=2 window=4 keyframe=200}{1}{2}");
  fall_back();
  EXPECT_EQ(close().next, Next::ReconnectLater) << "the server of before is just starting";
  EXPECT_EQ(reader_->connected(clock_.now()).send, "{hello v=2 window=64 delta=1 from=400}");
}

class Adapting : public LiveReading {
 protected:
  Adapting() {
    AuReaderOptions options;
    options.buffers.adapt = true;
    options.peer = "server:4650";
    reader_.emplace(std::move(options));
  }
};

TEST_F(Adapting, BeginsByTheRoundTrip) {
  static_cast<void>(reader_->connected(clock_.now(), 600ms));
  feed(kLive + "{1;100}");
  EXPECT_EQ(status().delay, 1500ms);
  for (int i = 0; i < 13; ++i) feed("{1;100}");
  EXPECT_FALSE(reader_->ready()) << "1400 ms";
  feed("{1;100}");
  EXPECT_TRUE(reader_->ready());
}

TEST_F(Adapting, KeepsNoLessThanAskedForAndNoMoreThanBearable) {
  static_cast<void>(reader_->connected(clock_.now(), 1ms));
  feed(kLive + "{1}");
  EXPECT_EQ(status().delay, 300ms);
  static_cast<void>(reader_->closed(clock_.now()));
  start({});
  static_cast<void>(reader_->connected(clock_.now(), 60s));
  feed(kLive);
  EXPECT_EQ(status().delay, 300ms) << "who asked for a time gets it";
}

TEST_F(Adapting, KeepsJustEnoughOnceItKnowsTheLink) {
  static_cast<void>(reader_->connected(clock_.now(), 600ms));
  feed(kLive);
  for (int i = 0; i < 800; ++i) {  // 32 s
    clock_.advance(39ms);
    feed("{1;40}");
    static_cast<void>(reader_->take());
  }
  EXPECT_EQ(status().delay, 60ms) << "nothing came late for half a minute";
  clock_.advance(2s);
  feed("{1;40}");
  EXPECT_GE(status().delay, 2s);
  EXPECT_LE(status().delay, 2100ms);
  clock_.advance(1h);
  feed("{1;40}");
  EXPECT_EQ(status().delay, 4s) << "a face that is later than that is of no use";
}

TEST_F(Reconnecting, TriesAgainAfterSilence) {
  clock_.advance(10s);
  EXPECT_EQ(reader_->time(clock_.now()).next, Next::ReconnectLater);
}

/// The buffers and what was kept aside are full of the connection before: what the new one brings
/// has to wait, for minutes if keyframes are long.
TEST_F(Reconnecting, TakesFullBuffersForNoSilenceOfTheServer) {
  AuReaderOptions options;
  options.reconnect = true;
  options.buffers = {4, 2, 50};
  start(options);
  feed("{hello v=2 window=4 keyframe=1000}{1}{1}{1}{1}{1}{1}{1}{1}{1}");
  EXPECT_EQ(close().next, Next::ReconnectLater);
  static_cast<void>(reader_->connected(clock_.now()));
  EXPECT_EQ(feed("{hello v=2 window=4 keyframe=1000 from=9000}{2}"), "");
  EXPECT_FALSE(reader_->deadline());
  clock_.advance(1min);
  EXPECT_EQ(reader_->time(clock_.now()).next, Next::GoOn);
  int taken = 0;
  std::string said;
  for (int i = 0; i < 20; ++i) {
    if (reader_->take()) ++taken;
    if (reader_->has_output()) said += reader_->speak(clock_.now()).send;
  }
  EXPECT_EQ(taken, 10);
  EXPECT_EQ(said, "1");
  EXPECT_TRUE(status().negotiated);
  EXPECT_EQ(status().keyframes_received, 10U);
}

TEST_F(Reconnecting, AsksForNoPlaceOnceTheStreamIsLive) {
  feed("{hello v=2 window=4 keyframe=200}{1}{2}");
  close();
  EXPECT_EQ(reader_->connected(clock_.now()).send, "{hello v=2 window=64 delta=1 from=400}");
  feed(kLive + "{4}");
  close();
  EXPECT_EQ(reader_->connected(clock_.now()).send, "{hello v=2 window=64 delta=1}");
}

TEST_F(Reconnecting, DropsTheHalfPacketThatWasUnderWay) {
  feed("{hello v=2 window=4}{1}{2,");
  close();
  static_cast<void>(reader_->connected(clock_.now()));
  feed("{hello v=2 window=4}{4}{-2}");
  EXPECT_EQ(reader_->take()->aus.left[1], 1.0F);
  EXPECT_EQ(reader_->take()->aus.left[4], 1.0F);
  EXPECT_EQ(status().end, EndReason::EndOfStream);
}

TEST_F(Reconnecting, AsksAgainForAStreamThatWasHere) {
  feed("{hello v=2 window=4}{1}");
  close();
  for (const char* refusal :
       {"{error 503 the server is full}", "{error 404 there is no stream 'x' here}"}) {
    static_cast<void>(reader_->connected(clock_.now()));
    feed(refusal);
    EXPECT_EQ(last_.next, Next::ReconnectLater) << refusal;
  }
  static_cast<void>(reader_->connected(clock_.now()));
  feed("{error 401 the token is wrong}");
  EXPECT_EQ(last_.next, Next::Close);
}

TEST_F(Reconnecting, EndsWithTheStreamOrWithWhatNoRetryMends) {
  feed("{error 404 there is no stream 'x' here}");
  EXPECT_EQ(last_.next, Next::Close);
  EXPECT_EQ(status().end, EndReason::Refused);
  Reconnecting::start([] {
    AuReaderOptions options;
    options.reconnect = true;
    return options;
  }());
  feed("garbage");
  EXPECT_EQ(status().end, EndReason::ProtocolError);
}

TEST_F(Reconnecting, StopsTryingWhenTheUserLeaves) {
  feed("{hello v=2 window=4}{1}");
  reader_->leave();
  EXPECT_EQ(reader_->unreachable("gone").next, Next::Close);
  EXPECT_EQ(status().end, EndReason::Stopped);
}

}  // namespace
}  // namespace aucast::net

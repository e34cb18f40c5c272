#include <gtest/gtest.h>

#include "protocol/limits.h"
#include "protocol/live_replay.h"
#include "protocol/server_session.h"
#include "tests/unit/protocol/packets.h"
#include "tests/unit/protocol/session_text.h"

namespace aucast::protocol {
namespace {

using namespace std::chrono_literals;
using test::encoded;
using test::reason_of;
using test::served;
using test::text_of;

const std::string kHello = "{hello v=2 window=4 stream=talk live=1 keyframe=250}";

/// A live stream of five keyframes, 100 ms each, and a hand on its clock.
class LiveServer : public ::testing::Test {
 protected:
  LiveServer() {
    stream_ = encoded({"{1:30}", "{2:30}", "{3:30}", "{4:30}", "{5:30}"},
                      {"{1}", "{2}", "{3}", "{4}", "{5}"});
    stream_.changes = test::packets({"{1:30}", "{~a2}", "{~a3}", "{~a4}", "{~a5}"});
    stream_.times.assign(5, KeyframeTime(100));
    start(false);
  }

  void start(bool loop) {
    live_ =
        std::make_shared<LiveReplay>(std::make_shared<const EncodedStream>(stream_), loop, now_);
    live_->advance(now_);
    catalogue_.streams = {{"talk", live_}};
    connect();
  }
  void start_recorded() {
    catalogue_.streams = {served("talk", stream_)};
    connect();
  }
  void connect() { session_.emplace(catalogue_, 0ms, now_); }

  /// Goes on to the next moment.
  std::string beat() {
    now_ = *live_->next_at();
    EXPECT_TRUE(live_->advance(now_));
    return text_of(session_->on_moment(now_));
  }
  std::string get(std::string_view bytes) { return text_of(session_->on_bytes(bytes, now_)); }
  std::string peer_end() { return text_of(session_->on_peer_end(now_)); }
  std::string grace() { return text_of(session_->on_time(now_ += 100ms)); }
  std::string set_blocked(bool blocked) { return text_of(session_->set_blocked(blocked, now_)); }

  EncodedStream stream_;
  ServerCatalogue catalogue_;
  Instant now_ = Instant{} + 1h;
  std::shared_ptr<LiveReplay> live_;
  std::optional<ServerSession> session_;
};

TEST_F(LiveServer, SaysSoInItsHelloAndBeginsWithNow) {
  EXPECT_EQ(beat(), "") << "nothing before the level is settled";
  EXPECT_EQ(get("{hello v=2 window=4}"), "send " + kHello + "{2:30}");
  EXPECT_TRUE(session_->live());
  EXPECT_EQ(beat(), "send {3:30}");
  EXPECT_EQ(session_->sent().keyframes_merged, 0U) << "what was before is nobody's loss";
}

TEST_F(LiveServer, GivesAClassicClientTheNewestAtEachAnswer) {
  EXPECT_EQ(grace(), "send {1}") << "the clock has not been moved";
  EXPECT_EQ(beat(), "");
  EXPECT_EQ(beat(), "");
  EXPECT_EQ(get("1"), "send {3}");
  EXPECT_EQ(session_->sent().keyframes_merged, 1U);
  EXPECT_EQ(get("1"), "") << "there is nothing newer yet";
  EXPECT_EQ(beat(), "send {4}");
}

TEST_F(LiveServer, SendsSeveralMomentsInOnePiece) {
  const auto late = [this] {
    now_ += 200ms;
    EXPECT_TRUE(live_->advance(now_));
    return text_of(session_->on_moment(now_));
  };
  get("{hello v=2 window=0 delta=1}");
  EXPECT_EQ(late(), "send {~a2}{~a3}");
  EXPECT_EQ(text_of(session_->on_moment(now_)), "") << "told twice";
  set_blocked(true);
  EXPECT_EQ(late(), "");
  EXPECT_EQ(set_blocked(false), "send {5:30}") << "who was behind gets the newest only";
  EXPECT_EQ(session_->sent().keyframes_merged, 1U);
}

TEST_F(LiveServer, SendsOfSeveralMomentsWhatTheWindowTakes) {
  get("{hello v=2 window=2}");
  now_ += 400ms;
  EXPECT_TRUE(live_->advance(now_));
  EXPECT_EQ(text_of(session_->on_moment(now_)), "send {2:30}");
  EXPECT_EQ(get("1"), "send {5:30}");
  EXPECT_EQ(session_->sent().keyframes_merged, 2U);
}

TEST_F(LiveServer, EndsWhenTheTimeOfTheLastIsOver) {
  get("{hello v=2 window=0}");
  for (int i = 0; i < 4; ++i) beat();
  EXPECT_EQ(beat(), "send {-2} | close finished");
}

TEST_F(LiveServer, EndsAfterTheLastAnswerAndAfterAPause) {
  get("{hello v=2 window=4}");
  for (int i = 0; i < 4; ++i) beat();
  EXPECT_EQ(beat(), "");
  EXPECT_EQ(get("-1"), "");
  EXPECT_EQ(get("1111"), "") << "the last moment has not been sent yet";
  EXPECT_EQ(get("-3"), "send {5:30}");
  EXPECT_EQ(get("1"), "send {-2} | close finished");
}

TEST_F(LiveServer, EndsAtOnceForWhoComesAfterTheEnd) {
  while (live_->next_at()) live_->advance(now_ = *live_->next_at());
  connect();
  EXPECT_EQ(get("{hello v=2 window=4}"), "send " + kHello + "{-2} | close finished");
  connect();
  EXPECT_EQ(grace(), "send {-2} | close finished");
}

TEST_F(LiveServer, StartsAgainWithoutEnd) {
  start(true);
  get("{hello v=2 window=0}");
  for (int i = 0; i < 4; ++i) beat();
  EXPECT_EQ(beat(), "send {1:30}");
  EXPECT_EQ(beat(), "send {2:30}");
}

TEST_F(LiveServer, SendsTheNewestWhenTheWindowOpensAgain) {
  start(true);
  EXPECT_EQ(get("{hello v=2 window=2}"),
            "send {hello v=2 window=2 stream=talk live=1 keyframe=250}{1:30}");
  EXPECT_EQ(beat(), "send {2:30}");
  EXPECT_EQ(beat(), "");
  EXPECT_EQ(beat(), "");
  EXPECT_EQ(get("11"), "send {4:30}");
  EXPECT_EQ(session_->sent().keyframes_merged, 1U);
}

TEST_F(LiveServer, GrantsNoLongerWindowThanABearableDelay) {
  EXPECT_NE(get("{hello v=2 window=256}").find("window=20 "), std::string::npos);
  stream_.times.assign(5, KeyframeTime(10'000));
  start(false);
  EXPECT_NE(get("{hello v=2 window=256}").find("window=2 "), std::string::npos);
  connect();
  EXPECT_NE(get("{hello v=2 window=1}").find("hello v=2 window=1 "), std::string::npos);
}

TEST_F(LiveServer, SendsChangesOnlyBetweenWhatWasSentInARow) {
  start(true);
  EXPECT_EQ(get("{hello v=2 window=1 delta=1}"),
            "send {hello v=2 window=1 delta=1 stream=talk live=1 keyframe=250}{1:30}");
  EXPECT_EQ(get("1"), "");
  EXPECT_EQ(beat(), "send {~a2}");
  EXPECT_EQ(beat(), "");
  EXPECT_EQ(get("1"), "send {~a3}") << "late, but nothing was left out";
  EXPECT_EQ(beat(), "");
  EXPECT_EQ(beat(), "");
  EXPECT_EQ(get("1"), "send {5:30}") << "full after a skip";
}

TEST_F(LiveServer, JoinsLateWithAFullPacket) {
  beat();
  EXPECT_NE(get("{hello v=2 window=4 delta=1}").find("{2:30}"), std::string::npos);
  EXPECT_EQ(beat(), "send {~a3}");
}

TEST_F(LiveServer, SkipsWhilePausedAndResumesWithAFullPacket) {
  start(true);
  get("{hello v=2 window=4 delta=1}1");
  EXPECT_EQ(get("-1"), "");
  EXPECT_EQ(beat(), "");
  EXPECT_EQ(beat(), "");
  EXPECT_EQ(get("-3"), "send {3:30}");
  EXPECT_EQ(beat(), "send {~a4}");
  EXPECT_EQ(get("-1-3"), "") << "there is nothing newer";
  EXPECT_EQ(beat(), "send {5:30}") << "full after a pause, even when nothing was left out";
}

TEST_F(LiveServer, PausesAClassicClientInPlaceOfAnAnswer) {
  EXPECT_EQ(get("1"), "send {1}");
  EXPECT_EQ(beat(), "send {2}");
  EXPECT_EQ(get("-1"), "");
  EXPECT_EQ(beat(), "");
  EXPECT_EQ(get("-3"), "send {3}");
}

TEST_F(LiveServer, AsksForNoAnswersWithAWindowOfNone) {
  EXPECT_EQ(get("{hello v=2 window=0}"),
            "send {hello v=2 window=0 stream=talk live=1 keyframe=250}{1:30}");
  EXPECT_EQ(beat(), "send {2:30}");
  EXPECT_FALSE(session_->awaiting_answer());
  for (int i = 0; i < 4; ++i) EXPECT_EQ(get(std::string(1000, '1')), "") << "does not matter";
  EXPECT_EQ(beat(), "send {3:30}");
}

TEST_F(LiveServer, HandsNothingOutWhileTheSocketIsFull) {
  get("{hello v=2 window=0 delta=1}");
  EXPECT_EQ(set_blocked(true), "");
  EXPECT_EQ(beat(), "");
  EXPECT_EQ(beat(), "");
  EXPECT_EQ(set_blocked(true), "");
  EXPECT_EQ(set_blocked(false), "send {3:30}");
  EXPECT_EQ(session_->sent().keyframes_merged, 1U);
  EXPECT_EQ(set_blocked(false), "");
  EXPECT_EQ(set_blocked(true), "");
  beat();
  beat();
  EXPECT_EQ(beat(), "") << "the end waits for the last state";
  EXPECT_EQ(set_blocked(false), "send {5:30}{-2} | close finished");
}

TEST_F(LiveServer, UsesUpTheAnswersOfWhoHasShutItsSide) {
  start(true);
  EXPECT_EQ(get("11"), "send {1}");
  EXPECT_EQ(peer_end(), "");
  EXPECT_EQ(beat(), "send {2}");
  EXPECT_EQ(beat(), "send {3} | close peer gone");
}

TEST_F(LiveServer, GoesOnForWhoHasShutItsSideAndOwesNothing) {
  get("{hello v=2 window=0}");
  EXPECT_EQ(peer_end(), "");
  EXPECT_EQ(beat(), "send {2:30}");
  beat();
  beat();
  beat();
}

TEST_F(LiveServer, ClosesWhoHasShutItsSideWhilePaused) {
  get("{hello v=2 window=4}1-1");
  EXPECT_EQ(peer_end(), "close peer gone");
}

TEST_F(LiveServer, IsHeldButNotMovedWhenRecorded) {
  start_recorded();
  get("{hello v=2 window=1}");
  EXPECT_FALSE(session_->live());
  EXPECT_EQ(set_blocked(true), "");
  EXPECT_EQ(text_of(session_->on_moment(now_)), "");
  EXPECT_EQ(get("1"), "") << "the socket takes no more";
  EXPECT_EQ(set_blocked(false), "send {2:30}");
}

class RecordedChanges : public LiveServer {
 protected:
  RecordedChanges() { start_recorded(); }
};

TEST_F(RecordedChanges, AreSentWhenAskedFor) {
  EXPECT_EQ(get("{hello v=2 window=3 delta=1}"),
            "send {hello v=2 window=3 delta=1 stream=talk keyframe=250}{1:30}{~a2}{~a3}");
  EXPECT_EQ(get("-1-3111"), "send {~a4}{~a5}") << "nothing is skipped, so nothing need be full";
}

TEST_F(RecordedChanges, AreNotGrantedWhereThereAreNone) {
  stream_.changes = {};
  start_recorded();
  EXPECT_EQ(get("{hello v=2 window=1 delta=1}"),
            "send {hello v=2 window=1 stream=talk keyframe=250}{1:30}");
}

class FullHouse : public LiveServer {
 protected:
  FullHouse() { session_.emplace(catalogue_, 0ms, now_, Admission::Full); }
};

TEST_F(FullHouse, RefusesAHelloByItsNumber) {
  const auto events = session_->on_bytes("{hello v=2 window=4}", now_);
  EXPECT_EQ(text_of(events), "send {error 503 the server is full} | close refused");
}

TEST_F(FullHouse, ClosesOnOthersWithoutAWord) {
  EXPECT_EQ(grace(), "close refused");
  session_.emplace(catalogue_, 0ms, now_, Admission::Full);
  EXPECT_EQ(get("1"), "close refused");
  session_.emplace(catalogue_, 0ms, now_, Admission::Full);
  EXPECT_EQ(peer_end(), "close refused");
}

}  // namespace
}  // namespace aucast::protocol

// What a server session does with a stream that comes from another server.

#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "protocol/codec.h"
#include "protocol/encoded_stream.h"
#include "protocol/live_feed.h"
#include "protocol/server_chain.h"
#include "protocol/server_session.h"
#include "protocol/stream_choice.h"
#include "tests/support/manual_clock.h"

namespace aucast::protocol {
namespace {

using std::chrono::milliseconds;

/// What comes out: bytes, "!WHY" for the close.
std::string sent_of(const std::vector<ServerEvent>& events) {
  std::string text;
  for (const ServerEvent& event : events) {
    if (const auto* bytes = std::get_if<SendBytes>(&event)) text += bytes->bytes;
    if (const auto* close = std::get_if<CloseConnection>(&event))
      text += "!" + std::string(name(close->why));
  }
  return text;
}

void append(EncodedStream& stream, const std::string& packet, std::uint32_t ms) {
  stream.classic.push_back("{1}");
  stream.negotiated.push_back(packet);
  stream.changes.push_back(packet);
  stream.times.emplace_back(ms);
}

/// A relay of one stream, `talk`, and a client of it.
class RelayedSession : public testing::Test {
 protected:
  RelayedSession() {
    upstream_->name = "talk";
    upstream_->patience = milliseconds(8000);
    catalogue_.id = "me";
    catalogue_.streams.push_back({"talk", upstream_});
  }

  std::string hear(std::string_view bytes) {
    if (!session_) session_.emplace(catalogue_, Duration{}, clock_.now());
    return sent_of(session_->on_bytes(bytes, clock_.now()));
  }
  std::string wake() { return sent_of(session_->on_moment(clock_.now())); }
  std::string half_close() { return sent_of(session_->on_peer_end(clock_.now())); }
  std::string wait(milliseconds time) {
    clock_.advance(time);
    return sent_of(session_->on_time(clock_.now()));
  }
  std::shared_ptr<EncodedStream> grow() {
    auto stream = std::make_shared<EncodedStream>();
    stream->extent = Extent::Growing;
    stream->duration_ms = 120;
    append(*stream, "{1;40}", 40);
    upstream_->content = RecordedStream{stream};
    return stream;
  }

  test::ManualClock clock_;
  std::shared_ptr<UpstreamStream> upstream_ = std::make_shared<UpstreamStream>();
  ServerCatalogue catalogue_;
  std::optional<ServerSession> session_;
};

TEST_F(RelayedSession, AClientWaitsForTheStreamAndGetsIt) {
  EXPECT_EQ(hear("{hello v=2 window=8 stream=talk}"), "");
  EXPECT_EQ(wake(), "") << "nothing is known yet";
  auto feed = std::make_shared<LiveFeed>(33, 20);
  upstream_->content = feed;
  upstream_->keyframe_ms = 33;
  EXPECT_EQ(wake(), "{hello v=2 window=8 stream=talk live=1 keyframe=33}");
  feed->add({"{1}", "{1;40}", "{1;40}", false}, milliseconds(40));
  EXPECT_EQ(wake(), "{1;40}");
}

TEST_F(RelayedSession, AClientIsToldWhenTheStreamDoesNotCome) {
  EXPECT_EQ(hear("{hello v=2 window=8 stream=talk}"), "");
  EXPECT_EQ(wait(milliseconds(7999)), "");
  EXPECT_TRUE(wait(milliseconds(1)).starts_with("{error 503 the stream has not come")) << "told";
}

TEST_F(RelayedSession, AClassicClientWaitsAndIsClosed) {
  EXPECT_EQ(hear("1"), "");
  EXPECT_EQ(wait(milliseconds(8000)), "!refused");
}

TEST_F(RelayedSession, AClassicClientGetsItsFirstKeyframeWhenThereIsOne) {
  EXPECT_EQ(hear("1"), "");
  grow();
  EXPECT_EQ(wake(), "{1}");
}

TEST_F(RelayedSession, WhoEndsWhilePausedDoesNotWaitForTheStream) {
  EXPECT_EQ(hear("{hello v=2 window=8 stream=talk}-1"), "");
  EXPECT_EQ(half_close(), "!peer gone");
}

TEST_F(RelayedSession, APauseWhileWaitingIsNoAnswerInLevel2) {
  EXPECT_EQ(hear("{hello v=2 window=1}-1-3"), "");
  EXPECT_EQ(session_->level(), Level::Negotiated);
  append(*grow(), "{2;40}", 40);
  EXPECT_EQ(wake(), "{hello v=2 window=1 stream=talk duration=120 keyframe=250}{1;40}");
  EXPECT_EQ(hear("1"), "{2;40}");
}

TEST_F(RelayedSession, StopWhileWaitingIsTheEnd) {
  EXPECT_EQ(hear("{hello v=2}-4"), "{-2}!stopped");
}

TEST_F(RelayedSession, WhoWaitsIsSentAwayToo) {
  EXPECT_EQ(hear("{hello v=2}"), "");
  EXPECT_TRUE(session_->movable());
  EXPECT_EQ(sent_of(session_->send_away(clock_.now())), "!sent away");
}

TEST_F(RelayedSession, WhatAClassicClientAnsweredWhileItWaitedCounts) {
  EXPECT_EQ(hear("11"), "");
  auto stream = grow();
  append(*stream, "{2;40}", 40);
  EXPECT_EQ(wake(), "{1}{1}");
}

TEST_F(RelayedSession, AGrowingStreamIsSentAsItGrows) {
  auto stream = grow();
  EXPECT_EQ(hear("{hello v=2 window=8}"),
            "{hello v=2 window=8 stream=talk duration=120 keyframe=250}{1;40}");
  EXPECT_EQ(hear("1"), "") << "all of it is sent, and more will come";
  append(*stream, "{2;40}", 40);
  EXPECT_EQ(wake(), "{2;40}");
  append(*stream, "{0;40}", 40);
  stream->extent = Extent::Whole;
  EXPECT_EQ(wake(), "{0;40}");
  EXPECT_EQ(hear("11"), "{-2}!finished");
}

TEST_F(RelayedSession, AHalfClosedClientGetsWhatStillComesWhileItHasAnswersLeft) {
  auto stream = grow();
  EXPECT_EQ(hear("111"), "{1}");
  EXPECT_EQ(half_close(), "") << "two answers are banked, and more will come";
  append(*stream, "{2;40}", 40);
  EXPECT_EQ(wake(), "{1}");
  append(*stream, "{0;40}", 40);
  stream->extent = Extent::Whole;
  EXPECT_EQ(wake(), "{1}{-2}!finished");
}

TEST_F(RelayedSession, AHalfClosedClientMayWaitForItsStreamToo) {
  EXPECT_EQ(hear("11"), "");
  EXPECT_EQ(half_close(), "") << "nothing is known yet";
  auto stream = grow();
  stream->extent = Extent::Whole;
  EXPECT_EQ(wake(), "{1}{-2}!finished");
}

TEST_F(RelayedSession, AHalfClosedClientIsGoneWhenWhatCameCannotBeAnswered) {
  auto stream = grow();
  EXPECT_EQ(hear("1"), "{1}");
  EXPECT_EQ(half_close(), "");
  append(*stream, "{2;40}", 40);
  EXPECT_EQ(wake(), "{1}!peer gone");
}

TEST_F(RelayedSession, AStreamThatBrokeOffHasNoEnd) {
  auto stream = grow();
  EXPECT_FALSE(hear("{hello v=2 window=8}").empty());
  stream->extent = Extent::BrokenOff;
  EXPECT_EQ(wake(), "!broken off");
}

TEST_F(RelayedSession, FromWaitsUntilTheStreamHasGrownSoFar) {
  auto stream = grow();
  EXPECT_EQ(hear("{hello v=2 window=8 from=40}"), "") << "what ends after 40 ms is not here yet";
  append(*stream, "{2;40}", 40);
  EXPECT_EQ(wake(), "{hello v=2 window=8 stream=talk duration=120 keyframe=250 from=40}{2;40}");
}

TEST_F(RelayedSession, FromWaitsForNoMoreThanAKeyframeThatTakesNoTime) {
  auto stream = grow();
  append(*stream, "{2;0}", 0);
  EXPECT_EQ(hear("{hello v=2 window=8 from=40}"),
            "{hello v=2 window=8 stream=talk duration=120 keyframe=250 from=40}{2;0}");
}

TEST_F(RelayedSession, ALoopBeginsAgainOnlyWhenTheStreamIsWhole) {
  catalogue_.loop = true;
  auto stream = grow();
  EXPECT_EQ(hear("{hello v=2 window=2}"), "{hello v=2 window=2 stream=talk keyframe=250}{1;40}");
  EXPECT_EQ(hear("1"), "");
  stream->extent = Extent::Whole;
  EXPECT_EQ(wake(), "{1;40}{1;40}");
}

TEST_F(RelayedSession, ALoopOfTheParentIsOneHere) {
  upstream_->loop = true;
  auto stream = grow();
  stream->duration_ms = 40;
  stream->extent = Extent::Whole;
  EXPECT_EQ(hear("{hello v=2 window=2}"),
            "{hello v=2 window=2 stream=talk keyframe=250}{1;40}{1;40}");
  EXPECT_EQ(hear("1"), "{1;40}");
}

TEST_F(RelayedSession, ARelayOfARelayGetsOneTurnOfALoop) {
  upstream_->loop = true;
  auto stream = grow();
  EXPECT_EQ(hear("{hello v=2 window=8 loop=1 relay=b}"),
            "{hello v=2 window=8 stream=talk duration=120 keyframe=250 loop=1 origin=me}{1;40}");
  append(*stream, "{2;40}", 40);
  append(*stream, "{0;40}", 40);
  stream->extent = Extent::Whole;
  EXPECT_EQ(wake(), "{2;40}{0;40}");
  EXPECT_EQ(hear("111"), "{-2}!finished");
}

TEST_F(RelayedSession, FromInALoopWaitsForItsPlaceInTheTurn) {
  upstream_->loop = true;
  auto stream = grow();
  EXPECT_EQ(hear("{hello v=2 window=1 from=280}"), "") << "40 ms into the third turn";
  append(*stream, "{2;40}", 40);
  EXPECT_EQ(wake(), "{hello v=2 window=1 stream=talk keyframe=250 from=40}{2;40}");
}

TEST_F(RelayedSession, AStreamWithoutANameYetMayBeTheOneThatIsAskedFor) {
  upstream_->name.clear();
  catalogue_.streams.front().name.clear();
  EXPECT_EQ(hear("{hello v=2 stream=talk}"), "");
  upstream_->name = "smile";
  EXPECT_EQ(wake(), "{error 404 there is no stream 'talk' here}!refused");
}

TEST_F(RelayedSession, ARelayIsToldWhereTheStreamComesFrom) {
  upstream_->servers = "o,a";
  grow();
  EXPECT_EQ(hear("{hello v=2 relay=b}"),
            "{hello v=2 window=1 stream=talk duration=120 keyframe=250 origin=o,a,me}{1;40}");
}

TEST_F(RelayedSession, ARelayThatItComesThroughIsRefused) {
  upstream_->servers = "o,a";
  grow();
  EXPECT_TRUE(hear("{hello v=2 relay=a}").starts_with("{error 508 the stream would come back"));
}

/// Two relays that have lost the origin at the same time have taken each other as parents.
TEST_F(RelayedSession, ARelayIsRefusedAsSoonAsTheStreamComesThroughIt) {
  auto feed = std::make_shared<LiveFeed>(40, 20);
  upstream_->content = feed;
  upstream_->servers = "o";
  EXPECT_TRUE(hear("{hello v=2 window=8 relay=b}").ends_with(" origin=o,me}"));
  feed->add({"{1}", "{1;40}", "{1;40}", false}, milliseconds(40));
  EXPECT_EQ(wake(), "{1;40}");
  upstream_->servers = "o,a";
  feed->add({"{2}", "{2;40}", "{2;40}", false}, milliseconds(40));
  EXPECT_EQ(wake(), "{2;40}") << "by another way";
  upstream_->servers = "o,b";
  feed->add({"{3}", "{3;40}", "{3;40}", false}, milliseconds(40));
  EXPECT_EQ(wake(), "{error 508 the stream would come back to the relay that asks for it}!refused");
}

TEST_F(RelayedSession, ARelayThatDialsItselfIsRefusedAtOnce) {
  EXPECT_TRUE(hear("{hello v=2 relay=me}").starts_with("{error 508 ")) << "nothing is known yet";
}

TEST_F(RelayedSession, EightRelaysAreTheMost) {
  upstream_->servers = "o,r1,r2,r3,r4,r5,r6";
  grow();
  EXPECT_TRUE(hear("{hello v=2 relay=r8}").starts_with("{hello ")) << "this one is the seventh";
  upstream_->servers += ",r7";
  session_.reset();
  EXPECT_TRUE(hear("{hello v=2 relay=r9}").starts_with("{error 508 the stream has come through 8"));
}

TEST(ServerChain, HasIdsOfItsForm) {
  for (const char* good : {"a", "o,r1", "0123456789abcdef", "a,b,c,d,e,f,g,h"}) {
    EXPECT_TRUE(is_server_chain(good)) << good;
  }
  for (const char* bad :
       {"", ",", "a,", ",a", "a,,b", "a b", "0123456789abcdefg", "a,b,c,d,e,f,g,h,i"}) {
    EXPECT_FALSE(is_server_chain(bad)) << bad;
  }
  EXPECT_TRUE(passes_through("o,ab", "ab"));
  EXPECT_FALSE(passes_through("o,ab", "a"));
  EXPECT_FALSE(passes_through("", "a"));
}

}  // namespace
}  // namespace aucast::protocol

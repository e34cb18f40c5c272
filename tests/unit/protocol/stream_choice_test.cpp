#include "protocol/stream_choice.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "protocol/live_feed.h"
#include "protocol/server_chain.h"

namespace aucast::protocol {
namespace {

using State = StreamChoice::State;

std::shared_ptr<EncodedStream> recorded(std::size_t keyframes, Extent extent = Extent::Whole) {
  auto stream = std::make_shared<EncodedStream>();
  for (std::size_t i = 0; i < keyframes; ++i) {
    stream->classic.push_back("{1}");
    stream->negotiated.push_back("{1;40}");
    stream->times.emplace_back(40);
  }
  stream->extent = extent;
  return stream;
}

HelloAsked asks(const std::string& stream) {
  HelloAsked hello;
  hello.stream = stream;
  return hello;
}

class StreamChoiceTest : public testing::Test {
 protected:
  StreamChoiceTest() {
    catalogue_.id = "me";
    catalogue_.streams.push_back({"talk", RecordedStream{recorded(3)}});
    catalogue_.streams.push_back({"face", std::make_shared<const LiveFeed>(250, 20)});
  }
  StreamChoice choose(const HelloAsked& hello) const { return choose_stream(catalogue_, hello); }
  /// Adds a stream of another server.
  UpstreamStream& relay(const std::string& name) {
    auto upstream = std::make_shared<UpstreamStream>();
    upstream->patience = Milliseconds(5000);
    catalogue_.streams.push_back({name, upstream});
    return *upstream;
  }

  ServerCatalogue catalogue_;
};

TEST_F(StreamChoiceTest, IsTheFirstUnlessAnotherIsNamed) {
  EXPECT_EQ(choose_stream(catalogue_, std::nullopt).stream.name, "talk");
  EXPECT_EQ(choose(HelloAsked{}).stream.name, "talk");
  const StreamChoice named = choose(asks("face"));
  EXPECT_EQ(named.state, State::Ready);
  EXPECT_EQ(named.stream.name, "face");
  EXPECT_TRUE(named.stream.live());
}

TEST_F(StreamChoiceTest, WhatIsNotThereIsRefusedByItsName) {
  const StreamChoice choice = choose(asks("song"));
  EXPECT_EQ(choice.state, State::Refused);
  EXPECT_EQ(choice.refusal, (ErrorReply{404, "there is no stream 'song' here"}));
  EXPECT_EQ(choose(asks("Talk")).state, State::Refused) << "names are as they are written";
}

TEST_F(StreamChoiceTest, WhatMayStillBeBroughtIsWaitedFor) {
  catalogue_.patience = Milliseconds(3000);
  const StreamChoice choice = choose(asks("song"));
  EXPECT_EQ(choice.state, State::NotYet);
  EXPECT_EQ(choice.patience, Milliseconds(3000));
}

TEST_F(StreamChoiceTest, AStreamWhoseNameIsNotKnownYetMayBeTheOne) {
  UpstreamStream& upstream = relay("");
  const StreamChoice waits = choose(asks("song"));
  EXPECT_EQ(waits.state, State::NotYet);
  EXPECT_EQ(waits.patience, kStreamWaitMax);
  upstream.name = "song";
  upstream.title = "A song";
  upstream.content = RecordedStream{recorded(2)};
  const StreamChoice found = choose(asks("song"));
  EXPECT_EQ(found.state, State::Ready);
  EXPECT_EQ(found.stream.name, "song");
  EXPECT_EQ(found.stream.title, "A song");
  EXPECT_EQ(choose(asks("tune")).state, State::Refused) << "now it is known not to be";
}

TEST_F(StreamChoiceTest, WaitsForAStreamThatIsNotKnownAsLongAsItIsWorth) {
  relay("song");
  const StreamChoice choice = choose(asks("song"));
  EXPECT_EQ(choice.state, State::NotYet);
  EXPECT_EQ(choice.patience, Milliseconds(5000));
}

TEST_F(StreamChoiceTest, WaitsForThePlaceInAStreamThatGrows) {
  UpstreamStream& upstream = relay("song");
  upstream.content = RecordedStream{recorded(3, Extent::Growing)};
  HelloAsked hello = asks("song");
  hello.from_ms = 119;
  EXPECT_EQ(choose(hello).state, State::Ready);
  hello.from_ms = 120;
  EXPECT_EQ(choose(hello).state, State::NotYet);
  upstream.content = RecordedStream{recorded(3, Extent::BrokenOff)};
  EXPECT_EQ(choose(hello).state, State::Ready) << "no more will come: its client is cut off";
  upstream.content = RecordedStream{recorded(3)};
  EXPECT_EQ(choose(hello).state, State::Ready);
}

TEST_F(StreamChoiceTest, InALoopThePlaceIsOneOfItsTurn) {
  UpstreamStream& upstream = relay("song");
  auto growing = recorded(3, Extent::Growing);
  growing->duration_ms = 400;
  upstream.content = RecordedStream{growing};
  upstream.loop = true;
  HelloAsked hello = asks("song");
  hello.from_ms = 440;
  EXPECT_EQ(choose(hello).state, State::Ready) << "40 ms into the second turn";
  hello.loop = true;
  EXPECT_EQ(choose(hello).state, State::NotYet) << "who makes the turns himself counts in one";
}

TEST_F(StreamChoiceTest, ARelayNeverGetsItsOwnStreamBack) {
  UpstreamStream& upstream = relay("song");
  upstream.content = RecordedStream{recorded(2)};
  upstream.servers = "origin,north";
  HelloAsked hello = asks("song");
  hello.relay = "north";
  EXPECT_EQ(choose(hello).refusal,
            (ErrorReply{508, "the stream would come back to the relay that asks for it"}));
  hello.relay = "me";
  EXPECT_EQ(choose(hello).state, State::Refused) << "we are in the chain, too";
  hello.relay = "south";
  EXPECT_EQ(choose(hello).state, State::Ready);
  EXPECT_EQ(servers_told(catalogue_, catalogue_.streams.back(), hello), "origin,north,me");
  catalogue_.id.clear();
  hello.relay = "north";
  EXPECT_EQ(choose(hello).state, State::Ready) << "without an ID nothing is told or known";
  EXPECT_EQ(servers_told(catalogue_, catalogue_.streams.back(), hello), "");
}

TEST_F(StreamChoiceTest, OfTooManyRelaysTheLastIsRefused) {
  UpstreamStream& upstream = relay("song");
  upstream.content = RecordedStream{recorded(2)};
  HelloAsked hello = asks("song");
  hello.relay = "last";
  for (std::size_t i = 1; i < kRelayHopsMax; ++i) {
    upstream.servers = chained(std::move(upstream.servers), "r" + std::to_string(i));
    EXPECT_EQ(choose(hello).state, State::Ready) << upstream.servers;
  }
  upstream.servers = chained(std::move(upstream.servers), "more");
  const StreamChoice choice = choose(hello);
  EXPECT_EQ(choice.state, State::Refused);
  EXPECT_EQ(choice.refusal.code, 508);
  EXPECT_EQ(choose(asks("song")).state, State::Ready) << "a player is no relay";
}

TEST_F(StreamChoiceTest, OnlyRelaysAreToldTheServers) {
  EXPECT_EQ(servers_told(catalogue_, catalogue_.streams.front(), asks("talk")), "");
  HelloAsked hello = asks("talk");
  hello.relay = "south";
  EXPECT_EQ(servers_told(catalogue_, catalogue_.streams.front(), hello), "me");
}

}  // namespace
}  // namespace aucast::protocol

#include "server/upstream/dialled_address.h"

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "server/settings/limits.h"
#include "server/upstream/host_turns.h"
#include "server/upstream/parent.h"
#include "server/upstream/relayed_stream.h"
#include "tests/support/fake_link.h"

namespace aucast::server {
namespace {

using link::Ending;
using test::FakeLink;

/// A relay of the stream `talk`, whose parents the test plays one after the other.
class RelayOfTalk : public testing::Test {
 protected:
  RelayedStream::Options options() {
    return {"talk", 20, Milliseconds(8000), [this](std::uint64_t bytes) -> Result<void> {
              asked_bytes_ = bytes;
              if (full_) return Error{ErrorKind::Unreadable, "talk: there is no memory left"};
              return {};
            }};
  }

  /// The next parent; returns what the relay says to it.
  std::string connect() {
    outcome_.reset();
    link_ = std::make_shared<FakeLink>();
    parent_ = std::make_unique<Parent>(
        link_, stream_, Parent::Greeting{"secret", "me"},
        Parent::Events{[this] { ++moments_; },
                       [this](const Parent::Outcome& outcome) { outcome_ = outcome; }});
    parent_->start();
    return link_->heard();
  }
  std::string hear(std::string_view bytes) {
    link_->say(bytes);
    return link_->heard();
  }
  [[nodiscard]] std::string why() const { return outcome_ ? outcome_->reason : ""; }
  [[nodiscard]] const protocol::EncodedStream& kept() const {
    return *stream_.shared()->recorded()->encoded;
  }
  [[nodiscard]] std::vector<std::string> packets(const protocol::PacketList& list) const {
    std::vector<std::string> all;
    for (std::size_t at = 0; at < list.size(); ++at) all.emplace_back(list[at]);
    return all;
  }

  bool full_ = false;
  std::uint64_t asked_bytes_ = 0;
  RelayedStream stream_{options()};
  std::shared_ptr<FakeLink> link_;
  std::unique_ptr<Parent> parent_;
  std::optional<Parent::Outcome> outcome_;
  int moments_ = 0;
};

constexpr const char* kLive = "{hello v=2 window=50 delta=1 stream=talk live=1 origin=o,a}";
constexpr const char* kRecorded =
    "{hello v=2 window=256 delta=1 stream=talk duration=120 keyframe=40}";

TEST_F(RelayOfTalk, SaysWhoAsksForWhat) {
  EXPECT_EQ(
      connect(),
      "{hello v=2 window=256 stream=talk token=secret delta=1 voice=opus text=1 loop=1 relay=me}");
}

TEST_F(RelayOfTalk, PassesPacketsOfALiveStreamOnAsTheyCame) {
  connect();
  EXPECT_EQ(hear(kLive), "");
  const auto live = stream_.shared()->live();
  ASSERT_NE(live, nullptr) << "known before its first keyframe";
  EXPECT_EQ(stream_.shared()->servers, "o,a");
  EXPECT_EQ(hear("{12C;40@1000} {~1:30;33@1033}\n"), "11");
  ASSERT_NE(live->newest(), nullptr);
  EXPECT_EQ(live->newest()->number, 1U);
  EXPECT_EQ(live->newest()->changes, "{~1:30;33@1033}");
  EXPECT_EQ(live->newest()->full, "{1:30,12:50;33@1033}") << "for who joins now";
  EXPECT_EQ(live->newest()->classic, "{1,12}");
  EXPECT_GE(moments_, 2);
}

TEST_F(RelayOfTalk, TakesPacketsThatAreCutAnywhere) {
  connect();
  hear(kLive);
  const std::string packet = "{L12:80;40@7}";
  for (const char byte : packet) hear(std::string(1, byte));
  EXPECT_EQ(stream_.shared()->live()->newest()->full, packet);
}

TEST_F(RelayOfTalk, LeavesOutNoneOfTheMomentsThatComeAtOnce) {
  connect();
  hear(std::string(kLive) + "{1;40}{~2;40}");
  const auto live = stream_.shared()->live();
  const auto latest = [&live] {
    std::string packets;
    for (const protocol::LiveMoment& moment : live->latest()) packets += moment.changes;
    return packets;
  };
  hear("{~4;40}{~5;40}{~6;");
  EXPECT_EQ(latest(), "{~4;40}{~5;40}");
  hear("40}");
  EXPECT_EQ(latest(), "{~6;40}");
  EXPECT_EQ(live->newest()->number, 4U);
}

TEST_F(RelayOfTalk, KeepsARecordedStreamInEveryForm) {
  connect();
  hear(kRecorded);
  EXPECT_EQ(stream_.shared()->recorded(), nullptr) << "its forms show with the first keyframe";
  hear("{12C}{~1:30}");
  EXPECT_EQ(kept().extent, protocol::Extent::Growing);
  EXPECT_EQ(packets(kept().changes), (std::vector<std::string>{"{12C}", "{~1:30}"}));
  EXPECT_EQ(packets(kept().negotiated), (std::vector<std::string>{"{12C}", "{1:30,12:50}"}));
  EXPECT_EQ(packets(kept().classic), (std::vector<std::string>{"{12}", "{1,12}"}));
  hear("{0;40}{-2}");
  EXPECT_TRUE(stream_.whole());
  ASSERT_TRUE(outcome_);
  EXPECT_TRUE(outcome_->in_order);
}

TEST_F(RelayOfTalk, KeepsOneTurnOfALoop) {
  connect();
  hear("{hello v=2 window=256 delta=1 stream=talk duration=80 keyframe=40 loop=1}{1}");
  EXPECT_TRUE(stream_.shared()->loop);
  hear("{2}{-2}");
  EXPECT_TRUE(stream_.whole());
  EXPECT_TRUE(outcome_->in_order);
}

TEST_F(RelayOfTalk, KeepsTheVoiceOfARecordedStreamOnce) {
  const std::string kSpoken =
      "{hello v=2 window=256 stream=talk duration=120 keyframe=40 voice=opus text=1";
  connect();
  hear(kSpoken + "}{a@0 CP/+}{t@0 SGk}{1}");
  ASSERT_NE(stream_.shared()->recorded()->spoken, nullptr);
  const protocol::EncodedTrack& voice = *stream_.shared()->recorded()->spoken->voice;
  EXPECT_EQ(voice.packets().size(), 1U);
  EXPECT_EQ(voice.encoded_until(), Milliseconds(40));
  EXPECT_FALSE(voice.complete());
  link_->end({Ending::Why::Lost, "reset by peer"});
  connect();
  hear(kSpoken + " from=40}{a@0 CP/+}{t@0 SGk}{a@40 CP/+}{2}{0}{-2}");
  EXPECT_EQ(voice.packets().size(), 2U) << "what sounded already is not heard twice";
  EXPECT_EQ(stream_.shared()->recorded()->spoken->captions.size(), 1U);
  EXPECT_TRUE(voice.complete());
}

TEST_F(RelayOfTalk, KeepsEachOfTheCaptionsOfOnePlaceOnce) {
  const std::string kCaptioned =
      "{hello v=2 window=256 stream=talk duration=120 keyframe=40 text=1";
  connect();
  hear(kCaptioned + "}{t@0}{t@0 SGk}{1;0}");
  link_->end({Ending::Why::Lost, "reset by peer"});
  connect();
  hear(kCaptioned + "}{t@0}{t@0 SGk}{1;0}{1}{t@60}{t@60 SGk}{t@60}{2");
  link_->end({Ending::Why::Lost, "reset by peer"});
  connect();
  hear(kCaptioned + " from=40}{t@0 SGk}{t@60}{t@60 SGk}{t@60}{t@60 SG8}{2}{0}{-2}");
  std::string captions;
  for (const auto& caption : stream_.shared()->recorded()->spoken->captions) {
    captions += encode(caption);
  }
  EXPECT_EQ(captions, "{t@0}{t@0 SGk}{t@60}{t@60 SGk}{t@60}{t@60 SG8}");
  EXPECT_TRUE(stream_.whole());
}

TEST_F(RelayOfTalk, VoiceOfTheNextLiveParentFollowsThatOfTheOneBefore) {
  const std::string kSpoken = "{hello v=2 window=50 delta=1 stream=talk live=1 voice=opus}";
  connect();
  hear(kSpoken + "{a@0 CP/+}{1;40}");
  link_->end({Ending::Why::Lost, "reset by peer"});
  connect();
  hear(kSpoken + "{a@0 CP/+}{1;40}");
  const auto& voice = stream_.shared()->live()->voice();
  ASSERT_NE(voice.find(1), nullptr);
  EXPECT_EQ(voice.find(1)->begin, Milliseconds(40));
}

TEST_F(RelayOfTalk, ARecordedStreamGoesOnWithTheNextParentWhereItWasCutOff) {
  connect();
  hear(kRecorded);
  hear("{1;40}{2;4");
  link_->end({Ending::Why::Lost, "reset by peer"});
  EXPECT_EQ(why(), "reset by peer");
  EXPECT_EQ(connect(),
            "{hello v=2 window=256 stream=talk token=secret delta=1 from=40 voice=opus text=1 "
            "loop=1 relay=me}");
  hear("{hello v=2 window=256 delta=1 stream=talk duration=120 keyframe=40 from=40}{2}{0}{-2}");
  EXPECT_EQ(packets(kept().negotiated), (std::vector<std::string>{"{1;40}", "{2}", "{0}"}));
  EXPECT_TRUE(stream_.whole());
}

TEST_F(RelayOfTalk, KeyframesThatTakeNoTimeAreKeptOnceAfterALoss) {
  connect();
  hear(kRecorded);
  hear("{1;0}");
  connect();
  hear("{hello v=2 window=256 delta=1 stream=talk duration=120 keyframe=40}{1;0}{2;120}{3;0}");
  connect();
  hear("{hello v=2 window=256 delta=1 stream=talk duration=120 keyframe=40 from=120}");
  hear("{3;0}{4;0}{-2}");
  EXPECT_EQ(packets(kept().negotiated),
            (std::vector<std::string>{"{1;0}", "{2;120}", "{3;0}", "{4;0}"}));
  EXPECT_TRUE(stream_.whole());
}

TEST_F(RelayOfTalk, ALiveStreamGoesOnWithAFullPacketOfTheNextParent) {
  connect();
  hear(kLive);
  hear("{1;40}{~2;40}");
  link_->end({Ending::Why::Lost, "reset by peer"});
  connect();
  hear(kLive);
  hear("{4;40}");
  const protocol::LiveMoment& newest = *stream_.shared()->live()->newest();
  EXPECT_EQ(newest.number, 2U);
  EXPECT_EQ(newest.changes, "{4;40}") << "no change of what the parent before sent";
}

TEST_F(RelayOfTalk, GivingUpEndsALiveStreamUntilAParentSendsAgain) {
  connect();
  hear(kLive);
  hear("{1;40}{-2}");
  EXPECT_FALSE(stream_.shared()->live()->ended()) << "another parent may have it";
  stream_.give_up();
  EXPECT_TRUE(stream_.shared()->live()->ended());
  connect();
  hear(kLive);
  hear("{4;40}");
  EXPECT_FALSE(stream_.shared()->live()->ended());
}

TEST_F(RelayOfTalk, GivingUpBreaksARecordedStreamOffUntilAParentSendsAgain) {
  connect();
  hear(kRecorded);
  hear("{1;40}");
  link_->end({Ending::Why::Lost, "reset by peer"});
  stream_.give_up();
  EXPECT_EQ(kept().extent, protocol::Extent::BrokenOff);
  connect();
  hear("{hello v=2 window=256 delta=1 stream=talk duration=120 keyframe=40 from=40}");
  EXPECT_EQ(kept().extent, protocol::Extent::Growing);
}

/// Each of these parents is left with a reason, and nothing else happens.
TEST_F(RelayOfTalk, LeavesAParentThatIsNotWhatItShouldBe) {
  const struct {
    const char* says;
    const char* reason;
  } parents[] = {
      {"HTTP/1.1 400 Bad Request", "not the protocol"},
      {"{hello v=2 window=50 stream=other live=1}", "sends the stream 'other', asked was 'talk'"},
      {"{hello v=2 window=50 stream=talk}", "does not say how long"},
      {"{hello v=2 stream=talk duration=0 loop=1}", "takes no time at all"},
      {"{hello v=3}", "answered in version 3"},
      {"{1}", "it speaks classic only"},
      {"{error 404 there is no stream 'talk' here}", "the server refused: 404"},
      {"{streams talk}", "a list of streams that was not asked for"},
      {"{hello v=2 stream=talk duration=80 keyframe=40}{1}{2}{4}", "more than the 80 ms"},
      {"{hello v=2 stream=talk duration=80 keyframe=40}{1}{-2}", "ended after 40 ms of the 80 ms"},
      {"{hello v=2 stream=talk live=1 delta=1}{~1}", "names only changes"},
      {"{hello v=2 stream=talk live=1 origin=a,,b}", "origin has IDs of 1-16"},
  };
  for (const auto& parent : parents) {
    SCOPED_TRACE(parent.says);
    RelayedStream fresh(options());
    std::optional<Parent::Outcome> ending;
    auto link = std::make_shared<FakeLink>();
    Parent met(link, fresh, {"", "me"}, {[] {}, [&](const Parent::Outcome& why) { ending = why; }});
    met.start();
    link->say(parent.says);
    ASSERT_TRUE(ending);
    EXPECT_FALSE(ending->in_order);
    EXPECT_NE(ending->reason.find(parent.reason), std::string::npos) << ending->reason;
  }
}

TEST_F(RelayOfTalk, ANextParentMustHaveTheSameStream) {
  connect();
  hear(kRecorded);
  hear("{1;40}");
  const struct {
    const char* says;
    const char* reason;
  } parents[] = {
      {"{hello v=2 stream=talk live=1 keyframe=40}", "its stream is live"},
      {"{hello v=2 stream=talk duration=160 keyframe=40 from=40}", "its stream takes 160 ms"},
      {"{hello v=2 stream=talk duration=120 keyframe=40 from=40 loop=1}",
       "its stream starts again at its end (--loop), and what is served here ends"},
      {"{hello v=2 stream=talk duration=120 keyframe=33 from=40}", "without a time take 33 ms"},
      {"{hello v=2 stream=talk duration=120 keyframe=40 from=33}", "begins at 33 ms, asked was 40"},
  };
  for (const auto& parent : parents) {
    SCOPED_TRACE(parent.says);
    connect();
    hear(parent.says);
    EXPECT_NE(why().find(parent.reason), std::string::npos) << why();
    EXPECT_EQ(kept().negotiated.size(), 1U);
  }
}

TEST_F(RelayOfTalk, WhatAParentOnlyAnnouncedBindsNoOther) {
  connect();
  hear("{hello v=2 window=256 stream=talk duration=120 keyframe=33 voice=opus}{a@0 CP/+}");
  link_->end({Ending::Why::Lost, "reset by peer"});
  connect();
  hear(kLive);
  EXPECT_FALSE(outcome_) << why();
  EXPECT_TRUE(stream_.live());
  EXPECT_EQ(stream_.shared()->recorded(), nullptr);
}

TEST_F(RelayOfTalk, AFloodOfLiveKeyframesIsLeft) {
  connect();
  hear(kLive);
  std::string many;
  for (std::uint32_t count = 0; count < kRelayedPerSecondMax; ++count) many += "{1;0}";
  hear(many);
  EXPECT_FALSE(outcome_);
  hear("{1;0}");
  EXPECT_NE(why().find("2000 keyframes, voice packets and captions a second"), std::string::npos);
}

TEST_F(RelayOfTalk, AFloodOfLiveVoiceIsLeft) {
  connect();
  hear("{hello v=2 window=50 delta=1 stream=talk live=1 voice=opus}{1;0}{a@0 WAEC}");
  std::string many;
  for (std::uint32_t count = 2; count < kRelayedPerSecondMax; ++count) many += "{a WAM}";
  hear(many);
  EXPECT_FALSE(outcome_);
  hear("{a WAM}");
  EXPECT_NE(why().find("voice packets and captions a second"), std::string::npos);
}

TEST_F(RelayOfTalk, VoiceWithoutKeyframesTakesMemoryToo) {
  full_ = true;
  connect();
  hear("{hello v=2 window=256 stream=talk duration=120 keyframe=40 voice=opus}");
  EXPECT_FALSE(outcome_);
  hear("{a@0 WAEC}");
  EXPECT_EQ(why(), "talk: there is no memory left");
}

TEST_F(RelayOfTalk, WhoComesBeforeTheFirstCaptionIsGrantedCaptions) {
  connect();
  hear("{hello v=2 window=256 stream=talk duration=120 keyframe=40 text=1}{1;40}");
  ASSERT_NE(stream_.shared()->recorded()->spoken, nullptr);
  EXPECT_TRUE(stream_.shared()->recorded()->spoken->captions.empty());
  EXPECT_TRUE(stream_.shared()->recorded()->spoken->has_captions());
}

TEST_F(RelayOfTalk, ARecordingThatLeavesNoMemoryIsLeftOfEachParent) {
  full_ = true;
  for (int parent = 0; parent < 2; ++parent) {
    connect();
    hear(kRecorded);
    hear("{1;40}");
    EXPECT_EQ(why(), "talk: there is no memory left");
  }
}

TEST_F(RelayOfTalk, ASilentParentIsLeft) {
  connect();
  link_->advance(std::chrono::seconds(10));
  EXPECT_NE(why().find("nothing came from the server within"), std::string::npos);
}

TEST_F(RelayOfTalk, TakesTheNameOfTheParentsFirstStream) {
  RelayedStream::Options nameless = options();
  nameless.name.clear();
  RelayedStream stream(nameless);
  protocol::HelloGranted hello;
  hello.stream = "smile";
  hello.live = true;
  EXPECT_EQ(stream.begin(hello), std::nullopt);
  EXPECT_EQ(stream.shared()->name, "smile");
  EXPECT_EQ(stream.asked().stream, "smile") << "of the next parent too";
}

TEST_F(RelayOfTalk, TakesNoNameThatAnotherStreamHas) {
  RelayedStream::Options nameless = options();
  nameless.name.clear();
  nameless.take_name = [](const std::string& name) { return name != "talk"; };
  RelayedStream stream(nameless);
  protocol::HelloGranted hello;
  hello.stream = "talk";
  hello.live = true;
  EXPECT_NE(stream.begin(hello).value_or("").find("another one here has that name"),
            std::string::npos);
  EXPECT_EQ(stream.shared()->name, "");
  hello.stream = "smile";
  EXPECT_EQ(stream.begin(hello), std::nullopt) << "the next parent's is free";
}

TEST(HostTurns, TakeTheNextAtOnceAndWaitWhenAllHaveFailed) {
  HostTurns turns(3, 1);
  EXPECT_EQ(turns.current(), 0U);
  EXPECT_LE(turns.next(), kNextHostWaitMax);
  EXPECT_EQ(turns.current(), 1U);
  EXPECT_LE(turns.next(), kNextHostWaitMax);
  EXPECT_GE(turns.next(), kRedialWaitFirst / 2);
  EXPECT_EQ(turns.current(), 0U);
}

TEST(HostTurns, WaitLongerEachRoundUpToTheMost) {
  HostTurns turns(1, 1);
  Milliseconds most{0};
  for (int round = 0; round < 20; ++round) {
    const Milliseconds wait = turns.next();
    EXPECT_LE(wait, kRedialWaitMax);
    most = std::max(most, wait);
  }
  EXPECT_GT(most, kRedialWaitMax / 2);
  turns.worked();
  EXPECT_LE(turns.next(), kRedialWaitFirst);
}

TEST(HostTurns, ComeAtDifferentMomentsForDifferentServers) {
  HostTurns one(1, 1);
  HostTurns other(1, 99);
  EXPECT_NE(one.next(), other.next());
}

TEST(DialledAddress, IsReadWithItsSecrets) {
  const auto options = dialled_address("aucast://localhost:7/talk", {});
  ASSERT_TRUE(options) << options.error().message;
  EXPECT_EQ(options->address.stream, "talk");
  EXPECT_FALSE(options->tls);
  EXPECT_TRUE(dialled_address("aucasts://localhost/talk", {})->tls);
  EXPECT_FALSE(dialled_address("aucast://", {}));
  DialSecrets secrets;
  secrets.tls.authorities = "/nowhere";
  secrets.tls_options = "--push-tls";
  const auto wrong = dialled_address("aucasts://localhost/talk", secrets);
  ASSERT_FALSE(wrong);
  EXPECT_NE(wrong.error().message.find("--push-tls-ca"), std::string::npos)
      << wrong.error().message;
}

}  // namespace
}  // namespace aucast::server

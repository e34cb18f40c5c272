// The streams that publishers bring, without a socket: the test is all the publishers.
#include "server/push/pushed_streams.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "server/push/introduction.h"
#include "server/settings/limits.h"
#include "tests/support/fake_link.h"
#include "tests/support/quiet_log.h"
#include "tests/support/run_until.h"

namespace aucast::server {
namespace {

using test::FakeLink;

constexpr const char* kPushedLive = "{hello v=2 window=50 delta=1 stream=talk live=1}";

protocol::HelloAsked brings(const std::string& name, const std::string& id = "") {
  protocol::HelloAsked hello;
  hello.publish = name;
  hello.relay = id;
  return hello;
}

class PushedStreamsTest : public testing::Test {
 protected:
  /// A publisher that may come; what it hears first is in heard().
  std::shared_ptr<FakeLink> bring(const std::string& name, const std::string& id = "") {
    auto link = std::make_shared<FakeLink>();
    EXPECT_FALSE(streams_.refusal(brings(name, id)));
    streams_.take(link, brings(name, id), "192.0.2.1:5");
    return link;
  }
  [[nodiscard]] int refusal_of(const std::string& name, const std::string& id = "") const {
    const auto refusal = streams_.refusal(brings(name, id));
    return refusal ? refusal->code : 0;
  }
  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const auto& stream : streams_.streams()) all.push_back(stream.name);
    return all;
  }
  [[nodiscard]] std::shared_ptr<const protocol::UpstreamStream> only() const {
    return std::get<std::shared_ptr<const protocol::UpstreamStream>>(streams_.streams().at(0).kind);
  }

  const test::QuietLog quiet_;
  asio::io_context io_;
  int moments_ = 0;
  int changes_ = 0;
  Milliseconds wait_{30};
  PushedStreams streams_{io_, {"me", wait_, 20}, {[this] { ++moments_; }, [this] { ++changes_; }}};
};

using Names = std::vector<std::string>;

TEST_F(PushedStreamsTest, AsksAsARelayDoesAndSaysThatItTakes) {
  const auto link = bring("talk");
  EXPECT_EQ(link->heard(),
            "{hello v=2 window=256 stream=talk delta=1 voice=opus text=1 loop=1 relay=me takes=1}");
  EXPECT_EQ(names(), Names{"talk"});
  EXPECT_EQ(changes_, 1);
  link->say(std::string(kPushedLive) + "{12C;40}");
  EXPECT_EQ(link->heard(), "1");
  ASSERT_NE(only()->live(), nullptr);
  EXPECT_EQ(only()->live()->newest()->full, "{12C;40}");
}

TEST_F(PushedStreamsTest, ANameHasOnePublisherAndItMayComeAgain) {
  const auto first = bring("talk", "a");
  first->say(std::string(kPushedLive) + "{1}");
  EXPECT_EQ(refusal_of("talk"), 409);
  EXPECT_EQ(refusal_of("talk", "b"), 409);
  EXPECT_EQ(refusal_of("other", "b"), 0);
  const auto second = bring("talk", "a");
  EXPECT_TRUE(first->closed()) << "it was dead and had not been found out";
  second->say(std::string(kPushedLive) + "{2}");
  EXPECT_EQ(only()->live()->newest()->full, "{2}");
  EXPECT_EQ(only()->live()->newest()->number, 1U) << "the same stream goes on";
  second->end({link::Ending::Why::Lost, "reset"});
  EXPECT_EQ(refusal_of("talk", "b"), 0);
}

TEST_F(PushedStreamsTest, ALiveStreamThatNobodySendsIsForgotten) {
  const auto link = bring("talk");
  link->say(std::string(kPushedLive) + "{1}");
  const auto live = only()->live();
  link->end({link::Ending::Why::Lost, "reset"});
  EXPECT_FALSE(live->ended());
  EXPECT_TRUE(test::run_until(io_, [this] { return names().empty(); }));
  EXPECT_TRUE(live->ended());
  EXPECT_EQ(changes_, 2);
}

TEST_F(PushedStreamsTest, WhoBringsNothingIsForgottenWhenItIsGone) {
  const auto link = bring("talk");
  EXPECT_TRUE(test::run_until(io_, [this] { return moments_ > 0; })) << "given up";
  io_.poll();
  io_.restart();
  EXPECT_EQ(names(), Names{"talk"}) << "it may still send";
  link->say("garbage");
  EXPECT_TRUE(test::run_until(io_, [this] { return names().empty(); }));
}

TEST_F(PushedStreamsTest, ARecordedStreamStaysAndIsReplacedByAnother) {
  auto link = bring("talk");
  link->say("{hello v=2 window=256 stream=talk duration=80 keyframe=40}{1}{2}{-2}");
  const auto before = only();
  ASSERT_NE(before->recorded(), nullptr);
  EXPECT_EQ(before->recorded()->encoded->extent, protocol::Extent::Whole);
  link = bring("talk");
  EXPECT_NE(link->heard().find(" from=80 "), std::string::npos);
  link->say("{hello v=2 window=256 stream=talk duration=120 keyframe=40 from=80}");
  EXPECT_TRUE(link->closed()) << "it is asked for the whole of it when it comes again";
  EXPECT_NE(only(), before);
  EXPECT_EQ(before->recorded()->encoded->extent, protocol::Extent::Whole) << "for who is there";
  link = bring("talk");
  EXPECT_EQ(link->heard().find("from="), std::string::npos);
}

TEST_F(PushedStreamsTest, ThereIsRoomForSoManyAtATime) {
  std::vector<std::shared_ptr<FakeLink>> links;
  for (std::size_t i = 0; i < kPushedStreamsMax; ++i) {
    links.push_back(bring("s" + std::to_string(i)));
  }
  EXPECT_EQ(refusal_of("more"), 503);
  links[5]->end({link::Ending::Why::Lost, "reset"});
  links.push_back(bring("more"));
  EXPECT_EQ(names().size(), kPushedStreamsMax);
  EXPECT_EQ(names().back(), "more");
  EXPECT_EQ(refusal_of("s5"), 503);
}

TEST_F(PushedStreamsTest, GivesWayToAStreamOfTheServerItself) {
  const auto link = bring("talk");
  link->say(std::string(kPushedLive) + "{1}");
  const auto live = only()->live();
  streams_.give_way("talk");
  EXPECT_TRUE(link->closed());
  EXPECT_TRUE(live->ended());
  EXPECT_TRUE(names().empty());
}

class IntroductionTest : public testing::Test {
 protected:
  IntroductionTest() {
    introduction_ = std::make_unique<Introduction>(
        link_, protocol::PublishSession({"talk", "word", "a"}), [this](const auto& answer) {
          if (const auto* failed = std::get_if<protocol::PublishSession::Failed>(&answer)) {
            why_ = failed->reason;
          } else {
            bytes_ = std::get<protocol::PublishSession::Taken>(answer).bytes;
            released_ = introduction_->release();
          }
          introduction_.reset();
        });
    introduction_->start();
  }

  std::shared_ptr<FakeLink> link_ = std::make_shared<FakeLink>();
  std::unique_ptr<Introduction> introduction_;
  std::shared_ptr<link::Link> released_;
  std::string why_;
  std::string bytes_;
};

TEST_F(IntroductionTest, HandsTheLinkOnWhenItIsTaken) {
  EXPECT_EQ(link_->heard(), "{hello v=2 window=1 token=word relay=a publish=talk}");
  link_->say("{hello takes=1}");
  EXPECT_EQ(bytes_, "{hello takes=1}");
  EXPECT_EQ(released_, link_);
  EXPECT_FALSE(link_->closed());
}

TEST_F(IntroductionTest, WaitsNoLongerThanItMust) {
  link_->advance(kPublishAnswerTimeMax);
  EXPECT_EQ(why_, "nothing came from it within 10 s");
  EXPECT_TRUE(link_->closed());
}

TEST_F(IntroductionTest, SaysThatItWasCutOff) {
  link_->say("{hel");
  link_->end_sending();
  EXPECT_NE(why_.find("closed before it answered"), std::string::npos);
}

}  // namespace
}  // namespace aucast::server

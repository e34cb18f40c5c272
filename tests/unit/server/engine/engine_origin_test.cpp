// What --publish does, and says, with a bus that the test holds.
#include "server/engine/engine_origin.h"

#include <chrono>
#include <cstddef>
#include <memory>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <asio/io_context.hpp>
#include <asio/steady_timer.hpp>

#include "protocol/encoded_stream.h"
#include "protocol/engine_message.h"
#include "protocol/live_feed.h"
#include "tests/support/kept_log.h"
#include "tests/unit/protocol/packets.h"

namespace aucast::server {
namespace {

/// Keeps what is said.
class KeepingBus final : public Bus {
 public:
  explicit KeepingBus(std::vector<Message>& said) : said_(said) {}
  void subscribe(const std::string& /*subject*/) override {}
  void send(const Message& message) override { said_.push_back(message); }
  [[nodiscard]] std::string own_subject() const override { return "mine"; }
  [[nodiscard]] std::uint64_t left_out() const override { return 7; }

 private:
  std::vector<Message>& said_;
};

using LiveFeed = protocol::LiveFeed;

/// Publishes the first stream of its catalogue as `talk`.
class EngineOriginTest : public ::testing::Test {
 protected:
  EngineOriginTest() {
    catalogue_->id = "org";
    EXPECT_TRUE(origin_.start([this](Bus::Events events) {
      bus_ = std::move(events);
      return Result<std::unique_ptr<Bus>>(std::make_unique<KeepingBus>(said_));
    }));
    bus_.on_connected("a");
  }
  ~EngineOriginTest() override { origin_.stop(); }

  void serve(protocol::ServedStream::Kind kind) {
    catalogue_->streams = {{"talk", std::move(kind)}};
  }
  void serve(const std::shared_ptr<LiveFeed>& feed) {
    serve(std::shared_ptr<const protocol::LiveChannel>(feed));
  }
  /// The stream of another server, which comes from there through these servers.
  std::shared_ptr<protocol::UpstreamStream> serve_upstream(const std::string& servers) {
    const auto upstream = std::make_shared<protocol::UpstreamStream>();
    upstream->name = "talk";
    upstream->servers = servers;
    upstream->content = std::shared_ptr<const protocol::LiveChannel>(feed_);
    serve(std::shared_ptr<const protocol::UpstreamStream>(upstream));
    return upstream;
  }
  /// The packets that are sent of the next face.
  std::string smile() {
    protocol::Keyframe face;
    face.terms.push_back({12, Side::Both, 50});
    feed_->add(face);
    said_.clear();
    origin_.on_moment();
    std::string packets;
    for (const Bus::Message& message : said_) {
      packets += message.bytes.substr(message.bytes.find('\n') + 1);
    }
    return packets;
  }
  /// What somebody is told who joins.
  std::string joined() {
    said_.clear();
    bus_.on_message({"au.talk.join", "asker", "join"});
    return said_.empty() ? std::string() : said_.back().bytes;
  }
  [[nodiscard]] std::size_t times_said(const std::string& text) const {
    const std::string all = log_.said();
    std::size_t times = 0;
    for (auto at = all.find(text); at != std::string::npos; at = all.find(text, at + 1)) ++times;
    return times;
  }

  const test::KeptLog log_;
  const std::shared_ptr<LiveFeed> feed_ = std::make_shared<LiveFeed>(250, 20);
  const std::shared_ptr<protocol::ServerCatalogue> catalogue_ =
      std::make_shared<protocol::ServerCatalogue>();
  std::vector<Bus::Message> said_;
  asio::io_context io_;
  Bus::Events bus_;
  EngineOrigin origin_{io_, {"talk", Milliseconds(0)}, [this] { return catalogue_; }};
};

TEST_F(EngineOriginTest, AnswersSoManyQuestionsASecondAndCountsTheRest) {
  serve(feed_);
  smile();
  std::size_t answers = 0;
  // In how many seconds is the machine's business.
  while (!joined().empty()) ++answers;
  Status status;
  origin_.describe(status);
  EXPECT_GE(answers, EngineOrigin::kAnswersPerSecond);
  ASSERT_TRUE(status.engine);
  EXPECT_EQ(status.engine->questions_left_out, 1U);
  EXPECT_EQ(status.engine->messages_left_out, 7U) << "by the bus";
}

TEST_F(EngineOriginTest, MayEndWhileTheEndOfABatchIsQueued) {
  serve(feed_);
  auto origin = std::make_unique<EngineOrigin>(
      io_, EngineOrigin::Options{"batched", Milliseconds(1)}, [this] { return catalogue_; });
  Bus::Events bus;
  ASSERT_TRUE(origin->start([&](Bus::Events events) {
    bus = std::move(events);
    return Result<std::unique_ptr<Bus>>(std::make_unique<KeepingBus>(said_));
  }));
  bus.on_connected("a");
  protocol::Keyframe face;
  face.terms.push_back({12, Side::Both, 50});
  feed_->add(face);
  origin->on_moment();
  asio::steady_timer first(io_);
  first.expires_at(std::chrono::steady_clock::now() - std::chrono::hours(1));
  first.async_wait([&](const std::error_code& /*error*/) { origin.reset(); });
  // Both are due: the loop queues both handlers at once.
  const auto until = std::chrono::steady_clock::now() + std::chrono::milliseconds(5);
  while (std::chrono::steady_clock::now() < until) std::this_thread::yield();
  io_.poll();
  EXPECT_FALSE(origin);
  EXPECT_TRUE(said_.empty());
}

TEST_F(EngineOriginTest, SaysOnceThatARecordedStreamIsNotPublished) {
  protocol::EncodedStream recorded;
  recorded.classic = recorded.negotiated = test::packets({"{1}"});
  recorded.times.assign(1, protocol::KeyframeTime(100));
  serve(protocol::RecordedStream{
      std::make_shared<const protocol::EncodedStream>(std::move(recorded))});
  EXPECT_EQ(smile(), "");
  EXPECT_EQ(smile(), "");
  EXPECT_EQ(times_said("talk: it is not published: it is recorded where it comes from"), 1U);
}

TEST_F(EngineOriginTest, SaysOnceWhyAStreamThatCameTooFarIsNotPublished) {
  serve_upstream("a,b,c,d,e,f,g,h");
  EXPECT_EQ(smile(), "");
  EXPECT_EQ(smile(), "");
  EXPECT_EQ(times_said("talk: it is not published: the stream has come through 8 relays already"),
            1U);
}

TEST_F(EngineOriginTest, EndsForWhoFollowsWhenItMayNoLongerBePublished) {
  const auto upstream = serve_upstream("a,b");
  EXPECT_EQ(smile(), "{12:50}");
  upstream->servers = "a,b,c,d,e,f,g,h";
  EXPECT_EQ(smile(), "{-2}");
  EXPECT_EQ(smile(), "") << "once";
  EXPECT_EQ(joined(), "");
  upstream->servers = "a,b";
  EXPECT_EQ(smile(), "{12:50}") << "the whole face";
}

TEST_F(EngineOriginTest, IsUnderstoodHoweverOftenItsChannelIsANewOne) {
  std::set<std::string> origins;
  for (int run = 0; run < 1'100; ++run) {
    const auto feed = std::make_shared<LiveFeed>(250, 20);
    feed->add(protocol::Keyframe());
    serve(feed);
    said_.clear();
    origin_.on_moment();
    ASSERT_FALSE(said_.empty());
    const auto read = protocol::parse_engine_message(said_.back().bytes);
    ASSERT_TRUE(read) << said_.back().bytes << ": " << read.error().message;
    EXPECT_TRUE(origins.insert(read->origin).second) << "its own run";
  }
}

TEST_F(EngineOriginTest, TellsThroughWhichServersTheStreamComesNow) {
  const auto upstream = serve_upstream("a,b");
  smile();
  EXPECT_NE(joined().find(" origin=a,b,org}"), std::string::npos) << joined();
  upstream->servers = "c";
  smile();
  EXPECT_NE(joined().find(" origin=c,org}"), std::string::npos) << joined();
}

}  // namespace
}  // namespace aucast::server

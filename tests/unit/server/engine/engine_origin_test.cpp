// What --publish does with the questions of an engine.
#include "server/engine/engine_origin.h"

#include <memory>
#include <utility>

#include <gtest/gtest.h>
#include <asio/io_context.hpp>

#include "common/log.h"
#include "protocol/live_feed.h"

namespace aucast::server {
namespace {

/// Counts what is said.
class CountingBus final : public Bus {
 public:
  explicit CountingBus(std::size_t& said) : said_(said) {}
  void subscribe(const std::string& /*subject*/) override {}
  void send(const Message& message) override {
    if (message.subject == "asker") ++said_;
  }
  [[nodiscard]] std::string own_subject() const override { return "mine"; }
  [[nodiscard]] std::uint64_t left_out() const override { return 7; }

 private:
  std::size_t& said_;
};

TEST(EngineOrigin, AnswersSoManyQuestionsASecondAndCountsTheRest) {
  const auto level_before = spdlog::get_level();
  spdlog::set_level(spdlog::level::off);
  const auto feed = std::make_shared<protocol::LiveFeed>(250, 20);
  const auto catalogue = std::make_shared<protocol::ServerCatalogue>();
  catalogue->id = "org";
  catalogue->streams.emplace_back("talk", std::shared_ptr<const protocol::LiveChannel>(feed));
  asio::io_context io;
  EngineOrigin origin(io, {"talk", Milliseconds(0)}, [&] { return catalogue; });
  std::size_t said = 0;
  Bus::Events bus;
  ASSERT_TRUE(origin.start([&](Bus::Events events) {
    bus = std::move(events);
    return Result<std::unique_ptr<Bus>>(std::make_unique<CountingBus>(said));
  }));
  protocol::Keyframe smile;
  smile.terms.push_back({12, Side::Both, 50});
  feed->add(smile);
  origin.on_moment();
  std::size_t questions = 0;
  Status status;
  // In how many seconds is the machine's business.
  while (said == questions) {
    bus.on_message({"au.talk.join", "asker", "join"});
    ++questions;
  }
  origin.describe(status);
  EXPECT_GE(said, EngineOrigin::kAnswersPerSecond);
  ASSERT_TRUE(status.engine);
  EXPECT_EQ(status.engine->questions_left_out, 1U);
  EXPECT_EQ(status.engine->messages_left_out, 7U) << "by the bus";
  origin.stop();
  spdlog::set_level(level_before);
}

}  // namespace
}  // namespace aucast::server

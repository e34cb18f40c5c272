// A bus over a module of the test's own, which decides when a server answers.
#include "server/engine/nats_bus.h"

#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <semaphore>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <asio/executor_work_guard.hpp>
#include <asio/post.hpp>

#include "common/link/loop_gate.h"
#include "common/log.h"
#include "tests/support/kept_log.h"
#include "tests/support/quiet_log.h"
#include "tests/support/run_until.h"

namespace aucast::server {
namespace {

using namespace std::chrono_literals;

std::atomic<int> asked{0};
std::counting_semaphore<1> answers{0};
std::shared_ptr<NatsListener> library;
std::vector<std::string> subscribed;  ///< of the loop's thread

class OpenConnection final : public NatsConnection {
 public:
  [[nodiscard]] bool is_connected() const override { return true; }
  [[nodiscard]] Result<void> subscribe(const std::string& subject) override {
    subscribed.push_back(subject);
    return {};
  }
  [[nodiscard]] Result<void> send(const Bus::Message& /*message*/) override { return {}; }
};

/// Refuses the first time; then is connected, but takes its time to say so.
Result<std::unique_ptr<NatsConnection>> connect(const NatsServers& /*servers*/,
                                                const std::shared_ptr<NatsListener>& listener) {
  library = listener;
  if (++asked == 1) return Error{ErrorKind::Network, "not you"};
  listener->on_connected("hub");
  if (!answers.try_acquire_for(10s)) return Error{ErrorKind::Network, "nobody let it go on"};
  return std::unique_ptr<NatsConnection>(std::make_unique<OpenConnection>());
}

Result<std::string> new_subject() {
  return std::string("mine");
}

TEST(NatsBus, TheLoopGoesRoundWhileAServerThatRefusedIsAskedAgain) {
  const auto level_before = spdlog::get_level();
  spdlog::set_level(spdlog::level::off);
  const NatsModule module{"", connect, new_subject};
  asio::io_context io;
  const auto work = asio::make_work_guard(io);  // a server always has some
  std::vector<std::string> told;
  auto bus = open_nats_bus(io, module, {},
                           {[](const Bus::Message&) {},
                            [&told](const std::string& server) {
                              told.push_back(server + " with " + std::to_string(subscribed.size()));
                            },
                            [] {}},
                           1ms);
  ASSERT_TRUE(bus);
  (*bus)->subscribe("talk");
  ASSERT_TRUE(test::run_until(io, [] { return asked == 2; }));
  bool went_round = false;
  asio::post(io, [&went_round] { went_round = true; });
  EXPECT_TRUE(test::run_until(io, [&went_round] { return went_round; }));
  EXPECT_TRUE(told.empty()) << "nothing can be said yet";
  answers.release();
  EXPECT_TRUE(test::run_until(io, [&told] { return !told.empty(); }));
  EXPECT_EQ(told, std::vector<std::string>{"hub with 1"});
  EXPECT_EQ((*bus)->left_out(), 0U);
  // Each part of a message counts, and there is room for two of three such.
  const std::string much(link::LoopGate::kBytesMax / 3, 'x');
  library->on_message({"talk", "", much});
  library->on_message({"talk", much, ""});
  library->on_message({much, "", ""});
  EXPECT_EQ((*bus)->left_out(), 1U);
  constexpr std::uint64_t kFitMax = link::LoopGate::kBytesMax / link::LoopGate::kBytesEach;
  for (std::uint64_t i = 0; i < 2 * kFitMax; ++i) library->on_message({"talk", "", ""});
  EXPECT_GT((*bus)->left_out(), kFitMax) << "empty messages have their limit too";
  bus->reset();
  spdlog::set_level(level_before);
}

std::atomic<int> opened{0};
std::atomic<bool> ending{false};
std::atomic<bool> went_on{false};
std::binary_semaphore may_end{0};

/// The first one is connected, but gets no subscription, and takes its time to end.
class RefusedConnection final : public NatsConnection {
 public:
  explicit RefusedConnection(bool first) : first_(first) {}
  ~RefusedConnection() override {
    if (!first_) return;
    ending = true;
    went_on = may_end.try_acquire_for(10s);
  }
  [[nodiscard]] bool is_connected() const override { return true; }
  [[nodiscard]] Result<void> subscribe(const std::string& /*subject*/) override {
    return first_ ? Result<void>(Error{ErrorKind::Network, "not this"}) : Result<void>();
  }
  [[nodiscard]] Result<void> send(const Bus::Message& /*message*/) override { return {}; }

 private:
  bool first_;
};

TEST(NatsBus, TheLoopGoesRoundWhileAConnectionEndsThatGotNoSubscription) {
  const test::KeptLog log;
  const NatsModule module{"",
                          [](const NatsServers&, const std::shared_ptr<NatsListener>&) {
                            return Result<std::unique_ptr<NatsConnection>>(
                                std::make_unique<RefusedConnection>(++opened == 1));
                          },
                          new_subject};
  asio::io_context io;
  const auto work = asio::make_work_guard(io);
  auto bus = open_nats_bus(io, module, {},
                           {[](const Bus::Message&) {}, [](const std::string&) {}, [] {}}, 1ms);
  ASSERT_TRUE(bus);
  (*bus)->subscribe("talk");
  EXPECT_TRUE(test::run_until(io, [] { return ending.load(); }));
  asio::post(io, [] { may_end.release(); });
  EXPECT_TRUE(test::run_until(io, [] { return opened == 2; }));
  EXPECT_TRUE(went_on);
  EXPECT_NE(log.said().find("no subscription to talk: not this; it is asked again in"),
            std::string::npos)
      << log.said();
}

TEST(NatsBus, TheEndOfAConnectionThatIsToldLateIsNotTheEndOfTheNext) {
  const test::QuietLog quiet;
  opened = 0;
  may_end.release();
  const NatsModule module{"",
                          [](const NatsServers&, const std::shared_ptr<NatsListener>& listener) {
                            if (opened == 0) library = listener;
                            listener->on_connected("hub " + std::to_string(++opened));
                            return Result<std::unique_ptr<NatsConnection>>(
                                std::make_unique<RefusedConnection>(opened == 1));
                          },
                          new_subject};
  asio::io_context io;
  const auto work = asio::make_work_guard(io);
  std::vector<std::string> told;
  auto bus = open_nats_bus(
      io, module, {},
      {[](const Bus::Message&) {}, [&told](const std::string& server) { told.push_back(server); },
       [&told] { told.emplace_back("lost"); }},
      1ms);
  ASSERT_TRUE(bus);
  ASSERT_TRUE(test::run_until(io, [&told] { return told.size() == 1; }));
  (*bus)->subscribe("talk");
  ASSERT_TRUE(test::run_until(io, [&told] { return told.size() == 3; }));
  library->on_disconnected();
  bool heard = false;
  asio::post(io, [&heard] { heard = true; });
  ASSERT_TRUE(test::run_until(io, [&heard] { return heard; }));
  EXPECT_EQ(told, (std::vector<std::string>{"hub 1", "lost", "hub 2"}));
}

TEST(NatsBus, WhatTheLibrarySaysAgainAndAgainIsLoggedOnce) {
  const test::KeptLog log;
  const NatsModule module{
      "",
      [](const NatsServers&, const std::shared_ptr<NatsListener>& listener) {
        library = listener;
        return Result<std::unique_ptr<NatsConnection>>(std::make_unique<OpenConnection>());
      },
      new_subject};
  asio::io_context io;
  const auto work = asio::make_work_guard(io);
  const auto bus = open_nats_bus(
      io, module, {}, {[](const Bus::Message&) {}, [](const std::string&) {}, [] {}}, 1ms);
  ASSERT_TRUE(bus);
  for (int i = 0; i < 100; ++i) library->on_error("no room " + std::to_string(i));
  bool heard = false;
  asio::post(io, [&heard] { heard = true; });
  ASSERT_TRUE(test::run_until(io, [&heard] { return heard; }));
  const std::string said = log.said();
  EXPECT_NE(said.find("NATS says: no room 0\n"), std::string::npos) << said;
  EXPECT_EQ(said.find("NATS says"), said.rfind("NATS says"));
}

}  // namespace
}  // namespace aucast::server

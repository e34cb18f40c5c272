// What follows a stream at an engine, and what it says, with a bus that the test holds.
#include "server/engine/engine_edge.h"

#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include <gtest/gtest.h>
#include <asio/io_context.hpp>

#include "protocol/engine_message.h"
#include "tests/support/kept_log.h"

namespace aucast::server {
namespace {

using protocol::EngineMessage;

class SilentBus final : public Bus {
 public:
  void subscribe(const std::string& /*subject*/) override {}
  void send(const Message& /*message*/) override {}
  [[nodiscard]] std::string own_subject() const override { return "mine"; }
  [[nodiscard]] std::uint64_t left_out() const override { return 0; }
};

/// Follows `talk`, which the test publishes as `org`.
class EngineEdgeTest : public ::testing::Test {
 protected:
  EngineEdgeTest() {
    EXPECT_TRUE(edge_.start());
    bus_.on_connected("a");
  }
  ~EngineEdgeTest() override { edge_.stop(); }

  void begin() {
    send("mine", EngineMessage::Kind::State, "{hello v=2 window=1 stream=talk live=1}{12C;40}");
  }
  void end() { send(batch_subject("talk"), EngineMessage::Kind::Batch, "{-2}"); }
  void send(const std::string& subject, EngineMessage::Kind kind, const std::string& packets) {
    bus_.on_message({subject, "", encode(EngineMessage{kind, "org", ++seq_, 0, 0, packets})});
  }

  const test::KeptLog log_;
  asio::io_context io_;
  Bus::Events bus_;
  std::uint64_t seq_ = 0;
  EngineEdge edge_{io_,
                   {.name = "talk", .id = "me"},
                   [this](Bus::Events events) {
                     bus_ = std::move(events);
                     return Result<std::unique_ptr<Bus>>(std::make_unique<SilentBus>());
                   },
                   [] {}};
};

TEST_F(EngineEdgeTest, SaysThatTheStreamHasEndedEachTimeThatItHasGoneOn) {
  begin();
  ASSERT_TRUE(edge_.reception().shared()->live()) << log_.said();
  end();
  const std::string first = log_.said();
  EXPECT_NE(first.find("talk: its stream has ended"), std::string::npos) << first;
  begin();
  EXPECT_TRUE(edge_.reception().connected());
  end();
  const std::string second = log_.said().substr(first.size());
  EXPECT_NE(second.find("talk: its stream has ended"), std::string::npos) << second;
}

}  // namespace
}  // namespace aucast::server

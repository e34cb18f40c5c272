// How a run ends, without a signal and without a socket: the test is all the peers.
#include "server/serve/shutdown.h"

#include <csignal>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/fake_link.h"
#include "tests/support/run_until.h"
#include "tests/unit/server/serve/talk_fixture.h"

namespace aucast::server {
namespace {

using namespace std::chrono_literals;
using test::FakeLink;
using Phase = Shutdown::Phase;

class ShutdownTest : public TalkFixture {
 protected:
  Shutdown& shutdown(Milliseconds drain_time = {}) {
    if (!shutdown_) {
      shutdown_.emplace(io_, drain_time, clients_,
                        Shutdown::Hooks{[this](Milliseconds at_most) { leaving_ = at_most; },
                                        [this] { happened_.emplace_back("stop"); },
                                        [this] { happened_.emplace_back("end"); }});
    }
    return *shutdown_;
  }
  std::shared_ptr<FakeLink> client(std::string_view says) {
    auto link = std::make_shared<FakeLink>();
    clients_.welcome({asio::ip::make_address("10.0.0.1"), 50000}, catalogue_,
                     [&link] { return link; });
    link->say(says);
    static_cast<void>(link->heard());
    return link;
  }
  /// Of level 2, in the middle of the stream.
  std::shared_ptr<FakeLink> viewer() { return client("{hello v=2}"); }
  std::shared_ptr<FakeLink> classic() { return client("1"); }

  asio::io_context io_;
  TransmitterOptions options_;
  Stats stats_;
  std::optional<Shutdown> shutdown_;
  ClientRegistry clients_{options_, stats_, [this] { shutdown_->on_empty(); }};
  std::optional<Milliseconds> leaving_;
  std::vector<std::string> happened_;
};

TEST_F(ShutdownTest, EndsAtOnceWhenNobodyIsThere) {
  EXPECT_EQ(shutdown(10s).phase(), Phase::Serving);
  shutdown().on_signal(SIGTERM);
  EXPECT_EQ(shutdown().phase(), Phase::Stopping);
  EXPECT_EQ(happened_, (std::vector<std::string>{"stop", "end"}));
  EXPECT_FALSE(leaving_) << "nobody is to be sent away";
}

TEST_F(ShutdownTest, TheLastClientThatLeavesIsTheEnd) {
  shutdown();
  const auto viewer = this->viewer();
  shutdown().stop("all sources have ended");
  EXPECT_EQ(happened_, (std::vector<std::string>{"stop"}));
  EXPECT_NE(viewer->heard().find("{-2}"), std::string::npos);
  shutdown().stop("the preview's reader has gone");
  EXPECT_EQ(happened_.size(), 1U) << "the streams end once";
  viewer->end({});
  EXPECT_EQ(happened_, (std::vector<std::string>{"stop", "end"}));
}

TEST_F(ShutdownTest, OneMoreSignalCutsOffWhoIsStillThere) {
  shutdown();
  const auto viewer = this->viewer();
  shutdown().on_signal(SIGINT);
  EXPECT_FALSE(viewer->closed());
  shutdown().on_signal(SIGINT);
  EXPECT_TRUE(viewer->closed());
  EXPECT_EQ(happened_.back(), "end");
}

TEST_F(ShutdownTest, WhoCannotGoOnElsewhereStaysUntilTheDrainIsOver) {
  shutdown(10s);
  const auto viewer = this->viewer();
  const auto classic = this->classic();
  EXPECT_EQ(clients_.count_movable(), 1U);
  shutdown().on_signal(SIGTERM);
  EXPECT_EQ(shutdown().phase(), Phase::Leaving);
  EXPECT_EQ(leaving_, 10s + kStopTimeMax);
  EXPECT_TRUE(happened_.empty()) << "the streams go on";
  shutdown().on_signal(SIGTERM);
  EXPECT_EQ(shutdown().phase(), Phase::Stopping);
  EXPECT_NE(classic->heard().find("{-2}"), std::string::npos);
}

TEST_F(ShutdownTest, WhoWasSentAwayIsNotCountedAmongThoseWhoseStreamEnds) {
  shutdown(1h);
  const auto first = this->viewer();
  const auto classic = this->classic();
  EXPECT_EQ(clients_.count_going_on(), 2U);
  clients_.send_away(1);
  EXPECT_EQ(clients_.came(), 2U) << "its connection is still closing";
  EXPECT_EQ(clients_.count_going_on(), 1U);
}

TEST_F(ShutdownTest, TheDrainIsOverWhenAllHaveGone) {
  shutdown(1h);
  const auto viewer = this->viewer();
  shutdown().on_signal(SIGTERM);
  viewer->end({});
  EXPECT_TRUE(happened_.empty()) << "not within what has told it";
  ASSERT_TRUE(test::run_until(io_, [this] { return !happened_.empty(); }));
  EXPECT_EQ(happened_, (std::vector<std::string>{"stop", "end"}));
}

TEST_F(ShutdownTest, MayEndWhileItsHandlerIsQueued) {
  shutdown(1h);
  const auto viewer = this->viewer();
  shutdown().on_signal(SIGTERM);
  asio::steady_timer first(io_);
  first.expires_at(std::chrono::steady_clock::now() - 1h);  // queued before the other
  first.async_wait([this](const std::error_code& /*error*/) { shutdown_.reset(); });
  viewer->end({});
  io_.run();
  EXPECT_TRUE(happened_.empty());
}

TEST_F(ShutdownTest, AServerThatWasDialledIsNeitherSentAwayNorWaitedFor) {
  shutdown(1h);
  const auto campus = std::make_shared<FakeLink>();
  clients_.serve("campus", catalogue_, campus, "{hello v=2}", [](const auto&, const auto&) {});
  const auto viewer = this->viewer();
  EXPECT_EQ(clients_.count_movable(), 1U);
  EXPECT_EQ(clients_.came(), 1U);
  shutdown().on_signal(SIGTERM);
  clients_.send_away(2);
  EXPECT_TRUE(viewer->finished());
  EXPECT_FALSE(campus->finished()) << "what is brought there goes on until the end";
  viewer->end({});
  ASSERT_TRUE(test::run_until(io_, [this] { return !happened_.empty(); }));
  EXPECT_EQ(happened_, (std::vector<std::string>{"stop"}));
  EXPECT_NE(campus->heard().find("{-2}"), std::string::npos);
  campus->end({});
  EXPECT_EQ(happened_, (std::vector<std::string>{"stop", "end"}));
}

TEST_F(ShutdownTest, TheDrainSendsAlsoThoseAwayThatBeganToPlayLater) {
  shutdown(20ms);
  const auto late = client("");
  EXPECT_EQ(clients_.count_movable(), 0U);
  shutdown().on_signal(SIGTERM);
  late->say("{hello v=2}");
  static_cast<void>(late->heard());
  ASSERT_TRUE(test::run_until(io_, [this] { return shutdown().phase() == Phase::Stopping; }));
  EXPECT_EQ(late->heard().find("{-2}"), std::string::npos);
  EXPECT_TRUE(late->finished());
}

}  // namespace
}  // namespace aucast::server

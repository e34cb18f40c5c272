#include "common/link/tcp_link.h"

#include <chrono>
#include <thread>

#include <gtest/gtest.h>
#include <asio/connect.hpp>
#include <asio/executor_work_guard.hpp>
#include <asio/io_context.hpp>
#include <asio/read.hpp>
#include <asio/write.hpp>

#include "tests/support/run_until.h"
#include "tests/unit/link/recording_user.h"

namespace aucast::link {
namespace {

using namespace std::chrono_literals;
using asio::ip::tcp;
using test::RecordingUser;
using Why = Ending::Why;

constexpr Limits kTcpLimits{10s, 200ms, 1000, 65536, 30s, 10s, 3, 60s};

/// A link and, at the other end of the connection, a socket of the test's.
class TcpLinkTest : public ::testing::Test {
 protected:
  TcpLinkTest() {
    tcp::acceptor acceptor(io_, tcp::endpoint(asio::ip::address_v4::loopback(), 0));
    peer_.connect(acceptor.local_endpoint());
    link_ = tcp_link(acceptor.accept(), kTcpLimits);
    link_->start(user_);
  }
  ~TcpLinkTest() override { link_->close(); }

  /// Lets the link work until the condition holds.
  template <typename Condition>
  [[nodiscard]] bool run_until(Condition condition) {
    return aucast::test::run_until(io_, condition);
  }
  [[nodiscard]] bool closed_as(Why why) {
    return run_until([&] { return user_.ending.has_value(); }) && user_.closed_as(why);
  }
  void say(const std::string& bytes) { asio::write(peer_, asio::buffer(bytes)); }
  /// All that the link has sent, to its end.
  std::string hear_all() {
    std::string all;
    std::error_code end;
    asio::read(peer_, asio::dynamic_buffer(all), end);
    EXPECT_EQ(end, asio::error::eof);
    return all;
  }

  asio::io_context io_{1};
  asio::executor_work_guard<asio::io_context::executor_type> work_{io_.get_executor()};
  tcp::socket peer_{io_};
  RecordingUser user_;
  std::shared_ptr<Link> link_;
};

TEST_F(TcpLinkTest, CarriesBytesBothWays) {
  EXPECT_TRUE(user_.opened);
  link_->write("{1}");
  EXPECT_EQ(link_->wire_bytes(), 3U) << "at once";
  say("1");
  EXPECT_TRUE(run_until([&] { return user_.heard == "1"; }));
  peer_.shutdown(tcp::socket::shutdown_send);
  EXPECT_TRUE(run_until([&] { return user_.peer_ended; }));
  EXPECT_FALSE(user_.ending);
}

TEST_F(TcpLinkTest, WhatIsNotTakenWaitsAndIsSentWhole) {
  const std::string much(16'000'000, 'x');
  link_->write(much);
  EXPECT_TRUE(link_->blocked());
  EXPECT_TRUE(link_->stuck_since());
  EXPECT_GT(link_->unsent_bytes(), 0U);
  std::string all(much.size(), '\0');
  std::size_t have = 0;
  peer_.non_blocking(true);
  EXPECT_TRUE(run_until([&] {
    std::error_code later;
    have += peer_.read_some(asio::buffer(all.data() + have, all.size() - have), later);
    return have == all.size();
  }));
  EXPECT_EQ(all, much);
  EXPECT_TRUE(run_until([&] { return user_.rooms == 1; }));
  EXPECT_FALSE(link_->blocked());
  EXPECT_FALSE(link_->stuck_since());
}

TEST_F(TcpLinkTest, WhoDoesNotReadIsNotHeard) {
  say("a");
  EXPECT_TRUE(run_until([&] { return user_.heard == "a"; }));
  link_->write(std::string(16'000'000, 'x'));
  say("b");
  EXPECT_TRUE(run_until([&] { return user_.heard == "ab"; })) << "the read under way";
  say("c");
  link_->wake_at(link_->now());
  EXPECT_TRUE(run_until([&] { return user_.times == 1; }));
  EXPECT_EQ(user_.heard, "ab");
}

TEST_F(TcpLinkTest, ReadsOnlyWhileItIsAskedTo) {
  link_->set_reading(false);
  say("a");
  EXPECT_TRUE(run_until([&] { return user_.heard == "a"; })) << "the read under way";
  say("b");
  link_->wake_at(link_->now());
  EXPECT_TRUE(run_until([&] { return user_.times == 1; }));
  io_.poll();
  EXPECT_EQ(user_.heard, "a");
  link_->set_reading(true);
  EXPECT_TRUE(run_until([&] { return user_.heard == "ab"; }));
}

TEST_F(TcpLinkTest, FinishSendsEverythingAndWaitsForThePeersEnd) {
  const std::string much(3'000'000, 'x');
  link_->write(much);
  link_->finish();
  link_->write("ignored");
  say("last words");
  std::thread peer([&] {
    EXPECT_EQ(hear_all(), much);
    peer_.shutdown(tcp::socket::shutdown_send);
  });
  EXPECT_TRUE(closed_as(Why::Finished));
  peer.join();
  EXPECT_EQ(user_.heard, "") << "what comes after finish() is dropped";
}

TEST_F(TcpLinkTest, DrainingEndsByTime) {
  link_->finish();
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_TRUE(closed_as(Why::Finished));
  EXPECT_GE(std::chrono::steady_clock::now() - begin, kTcpLimits.drain_time);
}

TEST_F(TcpLinkTest, DrainingEndsByBytes) {
  link_->finish();
  const auto begin = std::chrono::steady_clock::now();
  say(std::string(kTcpLimits.drain_bytes + 1, 'x'));
  EXPECT_TRUE(closed_as(Why::Finished));
  EXPECT_LT(std::chrono::steady_clock::now() - begin, kTcpLimits.drain_time);
}

TEST_F(TcpLinkTest, AResetIsALoss) {
  peer_.set_option(asio::socket_base::linger(true, 0));
  peer_.close();
  EXPECT_TRUE(closed_as(Why::Lost));
  EXPECT_FALSE(user_.ending->reason.empty());
}

TEST_F(TcpLinkTest, APeerThatVanishesAfterItsEndIsALossAlthoughNothingIsSent) {
  peer_.shutdown(tcp::socket::shutdown_send);
  ASSERT_TRUE(run_until([&] { return user_.peer_ended; }));
  EXPECT_FALSE(user_.ending);
  peer_.set_option(asio::socket_base::linger(true, 0));
  peer_.close();
  EXPECT_TRUE(closed_as(Why::Lost));
  EXPECT_FALSE(user_.ending->reason.empty());
}

TEST_F(TcpLinkTest, WritingToABrokenConnectionIsToldAfterTheCall) {
  peer_.set_option(asio::socket_base::linger(true, 0));
  peer_.close();
  for (int i = 0; i < 3; ++i) link_->write("x");
  EXPECT_FALSE(user_.ending);
  EXPECT_TRUE(closed_as(Why::Lost));
}

TEST_F(TcpLinkTest, ABrokenConnectionHasNoRoom) {
  link_->write(std::string(16'000'000, 'x'));
  ASSERT_TRUE(link_->blocked());
  peer_.set_option(asio::socket_base::linger(true, 0));
  peer_.close();
  EXPECT_TRUE(closed_as(Why::Lost));
  EXPECT_EQ(user_.rooms, 0);
}

TEST_F(TcpLinkTest, CloseTellsNothing) {
  link_->wake_at(link_->now());
  say("x");
  link_->close();
  io_.run_for(50ms);
  EXPECT_EQ(user_.times, 0);
  EXPECT_EQ(user_.heard, "");
  EXPECT_FALSE(user_.ending);
}

}  // namespace
}  // namespace aucast::link

#include "server/status/service_beat.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include <asio/buffer.hpp>
#include <asio/local/datagram_protocol.hpp>

#include "tests/support/run_until.h"
#include "tests/support/temp_folder.h"

namespace aucast::server {
namespace {

/// What a service manager hears, for as long as this lives.
class Heard {
 public:
  explicit Heard(asio::io_context& io) : socket_(io) {
    const std::string address = (folder_.path() / "notify").string();
    socket_.open();
    socket_.bind(address);
    ::setenv("NOTIFY_SOCKET", address.c_str(), 1);
    listen();
  }
  ~Heard() {
    ::unsetenv("NOTIFY_SOCKET");
    ::unsetenv("WATCHDOG_USEC");
  }
  Heard(const Heard&) = delete;
  Heard& operator=(const Heard&) = delete;

  [[nodiscard]] std::size_t times(std::string_view words) const {
    std::size_t count = 0;
    for (std::size_t at = 0; (at = all_.find(words, at)) != std::string::npos; ++at) ++count;
    return count;
  }

 private:
  void listen() {
    socket_.async_receive(asio::buffer(chunk_), [this](const std::error_code& error, auto bytes) {
      if (error) return;
      all_ += "|" + chunk_.substr(0, bytes);
      listen();
    });
  }

  aucast::test::TempFolder folder_;
  asio::local::datagram_protocol::socket socket_;
  std::string chunk_ = std::string(500, '\0');
  std::string all_;
};

TEST(ServiceBeat, TellsWhereTheRunIs) {
  asio::io_context io;
  const Heard heard(io);
  std::string summary = "3 clients";
  ServiceBeat service(io, [&summary] { return summary; });
  service.begin();
  EXPECT_TRUE(
      aucast::test::run_until(io, [&] { return heard.times("|READY=1\nSTATUS=3 clients") == 1; }));
  service.reloading();
  summary = "4 clients";
  service.reloaded();
  EXPECT_TRUE(
      aucast::test::run_until(io, [&] { return heard.times("|READY=1\nSTATUS=4 clients") == 1; }));
  EXPECT_EQ(heard.times("|RELOADING=1\n"), 1U);
  service.stopping(Milliseconds(2'000));
  EXPECT_TRUE(aucast::test::run_until(
      io, [&] { return heard.times("|STOPPING=1\nEXTEND_TIMEOUT_USEC=2000000") == 1; }));
  EXPECT_EQ(heard.times("WATCHDOG=1"), 0U) << "nobody waits for it";
}

TEST(ServiceBeat, SaysThatTheLoopGoesRoundAsOftenAsItIsWaitedFor) {
  asio::io_context io;
  const Heard heard(io);
  ::setenv("WATCHDOG_USEC", "20000", 1);
  ServiceBeat service(io, [] { return "well"; });
  service.begin();
  EXPECT_TRUE(aucast::test::run_until(io, [&] { return heard.times("|WATCHDOG=1") >= 3; }));
  EXPECT_GE(heard.times("|STATUS=well") + 1, heard.times("|WATCHDOG=1"));
}

TEST(ServiceBeat, IsSilentWhereNobodyListens) {
  asio::io_context io;
  ServiceBeat service(io, [] { return "well"; });
  service.begin();
  service.reloading();
  service.stopping({});
  EXPECT_EQ(io.run(), 0U) << "nothing is waited for";
}

}  // namespace
}  // namespace aucast::server

// The player's connection without a socket: the test is the server, the clock and who dials.
#include "client/net/server_connection.h"

#include <gtest/gtest.h>

#include "tests/support/fake_link.h"

namespace aucast::net {
namespace {

using namespace std::chrono_literals;
using link::Ending;
using playback::EndReason;
using test::FakeLink;

class PlayerConnection : public ::testing::Test {
 protected:
  void begin(AuReaderOptions options = {}) {
    options.peer = "server:4650";
    options.buffers = {2, 1, 100};
    reader_.emplace(std::move(options));
    connection_.emplace(*reader_, "server:4650", ServerConnection::Hooks{[this](Milliseconds wait) {
      waits_.push_back(wait);
    }},
                        ServerConnection::Events{[this] { over_ = true; }, [this] { ++changes_; }});
    dialled();
  }
  /// A new link for the connection.
  void dialled() {
    link_ = std::make_shared<FakeLink>();
    connection_->begin(link_);
  }
  std::string ask(std::string_view bytes) {
    link_->say(bytes);
    return link_->heard();
  }
  bool take() {
    return reader_->with([](AuReader& reader) { return reader.take().has_value(); });
  }
  [[nodiscard]] playback::SourceStatus status() {
    return reader_->with([](const AuReader& reader) { return reader.status(); });
  }

  std::optional<SharedReader> reader_;
  std::shared_ptr<FakeLink> link_;
  std::optional<ServerConnection> connection_;
  std::vector<Milliseconds> waits_;
  bool over_ = false;
  int changes_ = 0;
};

TEST_F(PlayerConnection, CarriesHelloAnswersAndTheEnd) {
  begin();
  EXPECT_EQ(link_->heard(), "{hello v=2 window=2 delta=1}");
  EXPECT_EQ(ask("{hello v=2 window=2}{1}{2}"), "11");
  EXPECT_GT(changes_, 0);
  EXPECT_EQ(ask("{-2}"), "");
  EXPECT_TRUE(over_);
  EXPECT_TRUE(link_->closed());
  EXPECT_EQ(status().bytes_sent, 30U);
}

TEST_F(PlayerConnection, ReadsNoFasterThanThePlayerMakesRoom) {
  begin();
  ask("{hello v=2 window=1}");
  ask("{1}{2}{3}{4}{5}{6}");
  EXPECT_FALSE(link_->reading());
  while (take()) {
    connection_->speak(link_->now());
  }
  EXPECT_TRUE(link_->reading());
  EXPECT_EQ(status().keyframes_received, 6U);
}

TEST_F(PlayerConnection, AnEndWaitsForWhatWasSaidBeforeIt) {
  begin();
  ask("{hello v=2 window=1}");
  ask("{1}{2}{3}{4}{5}{6}{-2}");
  link_->end_sending();
  EXPECT_FALSE(over_);
  while (take()) {
    connection_->speak(link_->now());
  }
  EXPECT_TRUE(over_);
  EXPECT_EQ(status().end, EndReason::EndOfStream);
}

TEST_F(PlayerConnection, SilenceHasItsTime) {
  begin();
  link_->advance(10s);
  EXPECT_TRUE(over_);
  EXPECT_EQ(status().end, EndReason::Unreachable);
}

TEST_F(PlayerConnection, DialsAgainWithoutAHelloAfterAClassicServerHungUp) {
  begin();
  ask("{1}");
  link_->end_sending();
  EXPECT_EQ(waits_, std::vector<Milliseconds>{0ms});
  EXPECT_TRUE(link_->closed());
  dialled();
  EXPECT_EQ(link_->heard(), "");
}

TEST_F(PlayerConnection, ALossIsTriedAgainLaterIfWanted) {
  AuReaderOptions options;
  options.reconnect = true;
  begin(options);
  ask("{hello v=2 window=1}{1}");
  link_->end({Ending::Why::Lost, "reset"});
  EXPECT_EQ(waits_, std::vector<Milliseconds>{1s});
  connection_->fail("Connection refused; is it there?", false);
  EXPECT_EQ(waits_, (std::vector<Milliseconds>{1s, 2s}));
  EXPECT_TRUE(status().detail.starts_with("cannot reach server:4650: Connection refused"));
  dialled();
  EXPECT_EQ(link_->heard(), "{hello v=2 window=2 delta=1 from=250}");
  EXPECT_FALSE(over_);
}

TEST_F(PlayerConnection, ALossSaysHowItCame) {
  begin();
  ask("{hello v=2 window=1}{1}");
  link_->end({Ending::Why::Lost, "Connection timed out"});
  EXPECT_TRUE(over_);
  EXPECT_NE(status().detail.find("before the end of the stream, {-2}: Connection timed out"),
            std::string::npos)
      << status().detail;
}

TEST_F(PlayerConnection, WhatIsFinalIsNotTriedAgain) {
  AuReaderOptions options;
  options.reconnect = true;
  begin(options);
  link_->end({Ending::Why::Untrusted, "the server's certificate has expired"});
  EXPECT_TRUE(over_);
  EXPECT_EQ(status().end, EndReason::Refused);
  EXPECT_EQ(status().detail, "server:4650: the server's certificate has expired");
}

TEST_F(PlayerConnection, AFailedHandshakeIsNoConnection) {
  begin();
  connection_.emplace(*reader_, "server:4650", ServerConnection::Hooks{[](Milliseconds) {}},
                      ServerConnection::Events{[this] { over_ = true; }, [] {}});
  link_ = std::make_shared<FakeLink>();
  link_->opens_at_once = false;
  connection_->begin(link_);
  link_->end({Ending::Why::TlsFailed, "no TLS handshake within 10 s"});
  EXPECT_EQ(status().end, EndReason::Unreachable);
  EXPECT_EQ(status().detail,
            "cannot reach server:4650: no TLS handshake within 10 s; does it speak TLS?");
}

TEST_F(PlayerConnection, LeavingSaysGoodbyeAndDrains) {
  begin();
  ask("{hello v=2 window=1}{1}");
  connection_->leave();
  EXPECT_EQ(link_->heard(), "-4");
  EXPECT_TRUE(link_->finished());
  EXPECT_FALSE(over_);
  link_->end({});
  EXPECT_TRUE(over_);
}

TEST_F(PlayerConnection, LeavingALostLinkWhoseBytesStillWaitEndsAtOnce) {
  begin();
  ask("{hello v=2 window=1}");
  ask("{1}{2}{3}{4}{5}{6}");
  EXPECT_FALSE(link_->reading());
  link_->end({Ending::Why::Lost, "reset"});
  EXPECT_FALSE(over_) << "what came before waits for room";
  connection_->leave();
  EXPECT_TRUE(over_) << "a closed link tells of no end";
}

TEST_F(PlayerConnection, LeavingWhileNoLinkIsThereEndsAtOnce) {
  AuReaderOptions options;
  options.reconnect = true;
  begin(options);
  link_->end({Ending::Why::Lost, "reset"});
  EXPECT_FALSE(over_);
  connection_->leave();
  EXPECT_TRUE(over_);
}

}  // namespace
}  // namespace aucast::net

// One client of the server, without a socket: the test is the peer and the clock.
#include "server/serve/client_connection.h"

#include <gtest/gtest.h>

#include "protocol/limits.h"
#include "protocol/live_replay.h"
#include "tests/support/fake_link.h"
#include "tests/unit/protocol/packets.h"
#include "tests/unit/server/serve/talk_fixture.h"

namespace aucast::server {
namespace {

using namespace std::chrono_literals;
using link::Ending;
using test::FakeLink;

class ConnectionTest : public TalkFixture {
 protected:
  ConnectionTest() {
    settings_.number = 1;
    settings_.peer = "127.0.0.1:50000";
    settings_.log = &log_;
  }

  /// All clients are served live from now on.
  void go_live() {
    live_ = std::make_shared<protocol::LiveReplay>(stream_, true, link_->now());
    live_->advance(link_->now());
    catalogue_->streams = {{"talk", live_}};
  }
  void beat() {
    link_->advance(100ms);
    live_->advance(link_->now());
    connection_->on_moment();
  }
  void start() {
    connection_ = std::make_shared<ClientConnection>(
        link_, catalogue_, settings_, [this](const ClientRecord& record, const std::string&) {
          record_ = record;
          connection_.reset();
        });
    connection_->start();
  }
  std::string ask(std::string_view bytes) {
    link_->say(bytes);
    return link_->heard();
  }
  [[nodiscard]] std::string end_reason() const {
    return record_ ? std::string(name(record_->end_reason)) : "(open)";
  }

  ClientLog log_;
  std::shared_ptr<protocol::LiveReplay> live_;
  ClientConnection::Settings settings_;
  std::shared_ptr<FakeLink> link_ = std::make_shared<FakeLink>();
  std::shared_ptr<ClientConnection> connection_;
  std::optional<ClientRecord> record_;
};

TEST_F(ConnectionTest, ServesAStreamAndDrains) {
  start();
  link_->advance(100ms);
  EXPECT_EQ(link_->heard(), "{1}") << "the grace is over";
  EXPECT_EQ(ask("1"), "{2}");
  link_->advance(1s);
  EXPECT_EQ(ask("1"), "{3}");
  EXPECT_FALSE(link_->finished());
  EXPECT_EQ(ask("1"), "{-2}");
  EXPECT_TRUE(link_->finished());
  EXPECT_EQ(end_reason(), "(open)");
  link_->end({});
  EXPECT_EQ(end_reason(), "finished");
  EXPECT_EQ(record_->sent.keyframes, 3U);
  EXPECT_EQ(record_->sent.payload_bytes, 9U);
  EXPECT_EQ(record_->bytes_total, 13U);
  EXPECT_EQ(record_->send_time, 1s);
}

TEST_F(ConnectionTest, TheGraceBeginsWhenTheLinkOpens) {
  link_->opens_at_once = false;
  start();
  link_->advance(5s);
  link_->open();
  EXPECT_EQ(link_->heard(), "");
  EXPECT_EQ(ask("{hello v=2}"), "{hello v=2 window=1 stream=talk keyframe=250}{1}");
}

TEST_F(ConnectionTest, ALossIsAPeerGone) {
  start();
  link_->end({Ending::Why::Lost, "reset"});
  EXPECT_EQ(end_reason(), "peer gone");
}

TEST_F(ConnectionTest, FailedTlsIsSaid) {
  link_->opens_at_once = false;
  start();
  const Ending failure{Ending::Why::NotTls, "the client does not speak TLS"};
  link_->fail(failure);
  connection_->stop();
  link_->end(failure);
  EXPECT_EQ(end_reason(), "tls failed");
}

TEST_F(ConnectionTest, GarbageFinishesWhatWasBegun) {
  start();
  ask("1");
  link_->say("x");
  EXPECT_TRUE(link_->finished());
  link_->end({});
  EXPECT_EQ(end_reason(), "protocol error");
}

TEST_F(ConnectionTest, StopSaysTheEndAndAbortDoesNotWait) {
  start();
  ask("1");
  connection_->stop();
  EXPECT_EQ(link_->heard(), "{-2}");
  EXPECT_TRUE(link_->finished());
  connection_->abort();
  EXPECT_TRUE(link_->closed());
  EXPECT_EQ(end_reason(), "stopped");
}

TEST_F(ConnectionTest, StopWithinTheHandshakeCloses) {
  link_->opens_at_once = false;
  start();
  connection_->stop();
  EXPECT_TRUE(link_->closed());
  EXPECT_EQ(end_reason(), "stopped");
}

TEST_F(ConnectionTest, AnAnswerThatIsOwedHasItsTime) {
  settings_.client_timeout = 3s;
  start();
  ask("1");
  link_->advance(2s);
  ask("1");
  link_->advance(2'999ms);
  EXPECT_FALSE(link_->finished());
  link_->advance(1ms);
  EXPECT_TRUE(link_->finished());
  link_->end({});
  EXPECT_EQ(end_reason(), "timed out");
}

TEST_F(ConnectionTest, APausedClientOwesNothing) {
  settings_.client_timeout = 3s;
  start();
  ask("{hello v=2 window=1}");
  ask("-1");
  link_->advance(60s);
  EXPECT_FALSE(link_->finished());
}

TEST_F(ConnectionTest, OfALiveStreamWhatIsNotTakenIsReplacedByTheNewest) {
  go_live();
  start();
  EXPECT_NE(ask("{hello v=2 window=0}").find("{1}"), std::string::npos);
  link_->take(1);
  beat();
  EXPECT_EQ(link_->heard(), "{") << "half a packet";
  beat();
  beat();
  EXPECT_EQ(link_->heard(), "");
  link_->take(1000);
  EXPECT_EQ(link_->heard(), "2}{1}") << "the third was left out";
  EXPECT_EQ(connection_->so_far().sent.keyframes_merged, 1U);
}

TEST_F(ConnectionTest, WhoReadsNothingIsKeptNoMoreThanItsShare) {
  const std::string packet = '{' + std::string(998, '1') + '}';
  protocol::EncodedStream stream;
  stream.classic = stream.negotiated = test::packets({packet, packet});
  catalogue_->streams = {
      {"talk", protocol::RecordedStream{
                   std::make_shared<const protocol::EncodedStream>(std::move(stream))}}};
  catalogue_->loop = true;
  settings_.client_timeout = 3s;
  start();
  ask("{hello v=2 window=1}");
  link_->take(0);
  link_->say("-1" + std::string(1000, '1') + "-3");
  EXPECT_LE(link_->unsent_bytes(), protocol::kOutputBytesMax + packet.size());
  link_->take(1 << 20);
  EXPECT_EQ(connection_->so_far().sent.keyframes, 1001U) << "all that was asked for";

  link_->take(0);
  link_->say("-1" + std::string(1000, '1') + "-3");
  link_->advance(3s);
  EXPECT_TRUE(link_->finished()) << "nothing was taken";
}

TEST_F(ConnectionTest, ALiveClientThatTakesNothingHasItsTime) {
  settings_.client_timeout = 3s;
  go_live();
  start();
  ask("{hello v=2 window=0}");
  link_->take(1);
  beat();
  EXPECT_TRUE(connection_->unsent_since());
  link_->advance(2'900ms);
  EXPECT_FALSE(link_->finished());
  link_->advance(100ms);
  EXPECT_TRUE(link_->finished());
}

TEST_F(ConnectionTest, SmallWritesAreGatheredAfterTheFirst) {
  settings_.batch = 250ms;
  go_live();
  start();
  EXPECT_NE(ask("{hello v=2 window=0}").find("{1}"), std::string::npos) << "is waited for";
  beat();
  beat();
  EXPECT_EQ(link_->heard(), "");
  EXPECT_EQ(connection_->output_bytes(), 6U);
  link_->advance(50ms);
  EXPECT_EQ(link_->heard(), "");
  beat();
  EXPECT_EQ(link_->heard(), "{2}{3}");
  connection_->stop();
  EXPECT_EQ(link_->heard(), "{1}{-2}") << "the last words do not wait";
}

}  // namespace
}  // namespace aucast::server

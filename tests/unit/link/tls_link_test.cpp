#include "common/link/tls_link.h"

#include <memory>

#include <gtest/gtest.h>

#include "tests/support/certificates.h"
#include "tests/support/fake_link.h"
#include "tests/unit/link/recording_user.h"

namespace aucast::link {
namespace {

using namespace std::chrono_literals;
using aucast::test::Authority;
using aucast::test::FakeLink;
using test::RecordingUser;
using Why = Ending::Why;

constexpr Limits kTlsLimits{10s, 2s, 65536, 65536, 30s, 10s, 3, 60s};

/// The server's and the client's link, with two fake ones below that the test joins.
class TlsLinkTest : public ::testing::Test {
 protected:
  explicit TlsLinkTest(const std::string& host = "localhost") {
    const auto certificate = authority_.issue("server", "DNS:localhost");
    const auto serving = tls::Context::for_server({certificate.file, certificate.key, {}});
    const auto asking = tls::Context::for_client({{}, {}, authority_.file()});
    server_ = tls_link(server_below_, tls::Layer(*serving), kTlsLimits, "TLS only");
    client_ = tls_link(client_below_, tls::Layer(*asking, host), kTlsLimits);
    client_says_.when_open = [this] { client_->write("hello"); };
  }
  ~TlsLinkTest() override {
    server_->close();
    client_->close();
  }

  void start() {
    server_->start(server_says_);
    client_->start(client_says_);
  }
  /// Carries the wire's bytes to and fro until there are none.
  void settle() {
    for (int i = 0; i < 10; ++i) {
      pass(*client_below_, *server_below_);
      pass(*server_below_, *client_below_);
    }
  }
  static void pass(FakeLink& from, FakeLink& to) {
    const std::string wire = from.heard();
    if (!wire.empty() && !to.finished() && !to.closed()) to.say(wire);
  }

  Authority authority_;
  std::shared_ptr<FakeLink> server_below_ = std::make_shared<FakeLink>();
  std::shared_ptr<FakeLink> client_below_ = std::make_shared<FakeLink>();
  RecordingUser server_says_;
  RecordingUser client_says_;
  std::shared_ptr<Link> server_;
  std::shared_ptr<Link> client_;
};

TEST_F(TlsLinkTest, OpensAfterTheHandshakeAndCarriesBytesBothWays) {
  start();
  EXPECT_FALSE(server_says_.opened || client_says_.opened);
  settle();
  EXPECT_TRUE(server_says_.opened && client_says_.opened);
  EXPECT_EQ(server_says_.heard, "hello");
  server_->write("{1}");
  settle();
  EXPECT_EQ(client_says_.heard, "{1}");
}

TEST_F(TlsLinkTest, FinishIsThePeersEnd) {
  start();
  settle();
  server_->write("{-2}");
  server_->finish();
  EXPECT_TRUE(server_below_->finished());
  settle();
  EXPECT_EQ(client_says_.heard, "{-2}");
  EXPECT_TRUE(client_says_.peer_ended);
  server_below_->end({});
  EXPECT_TRUE(server_says_.closed_as(Why::Finished));
}

TEST_F(TlsLinkTest, APeerWithoutTlsIsAnsweredWithoutIt) {
  server_->start(server_says_);
  server_below_->say("{hello v=2}");
  EXPECT_EQ(server_below_->heard(), "TLS only");
  EXPECT_TRUE(server_below_->finished());
  EXPECT_TRUE(server_says_.failure);
  EXPECT_FALSE(server_says_.ending) << "the answer is drained first";
  server_below_->end({});
  EXPECT_TRUE(server_says_.closed_as(Why::NotTls));
  EXPECT_FALSE(server_says_.opened);
}

TEST_F(TlsLinkTest, ASilentPeerHasSoMuchTimeForTheHandshake) {
  server_->start(server_says_);
  server_below_->advance(9'999ms);
  EXPECT_FALSE(server_below_->finished());
  server_below_->advance(1ms);
  EXPECT_EQ(server_below_->heard(), "TLS only");
  server_below_->end({});
  EXPECT_TRUE(server_says_.closed_as(Why::TlsFailed));
  EXPECT_EQ(server_says_.ending->reason, "no TLS handshake within 10 s");
  EXPECT_EQ(server_says_.times, 0);
}

TEST_F(TlsLinkTest, TheUsersTimeBeginsWhenItIsOpen) {
  server_->wake_at(server_->now());
  start();
  server_below_->advance(1s);
  EXPECT_EQ(server_says_.times, 0);
  settle();
  server_below_->advance(1s);
  EXPECT_EQ(server_says_.times, 1);
  server_below_->advance(20s);
  EXPECT_EQ(server_says_.times, 1);
}

TEST_F(TlsLinkTest, APeerThatLeavesWithinTheHandshakeIsSaid) {
  server_->start(server_says_);
  server_below_->end_sending();
  server_below_->end({});
  EXPECT_TRUE(server_says_.closed_as(Why::TlsFailed));
  EXPECT_FALSE(server_says_.peer_ended);
}

TEST_F(TlsLinkTest, ALossIsTold) {
  start();
  settle();
  client_below_->end({Why::Lost, "reset"});
  EXPECT_TRUE(client_says_.closed_as(Why::Lost));
  EXPECT_EQ(client_says_.ending->reason, "reset");
}

TEST_F(TlsLinkTest, TheUserMayLetGoWhileItIsTold) {
  client_says_.when_open = [this] {
    client_->close();
    client_.reset();
  };
  start();
  settle();
  EXPECT_TRUE(client_below_->closed());
  client_ =
      tls_link(std::make_shared<FakeLink>(),
               tls::Layer(*tls::Context::for_client({{}, {}, authority_.file()}), "x"), kTlsLimits);
}

class ForeignCertificate : public TlsLinkTest {
 protected:
  ForeignCertificate() : TlsLinkTest("example.org") {}
};

TEST_F(ForeignCertificate, IsNotAcceptedAndTheServerHearsWhy) {
  start();
  settle();
  EXPECT_TRUE(client_below_->finished()) << "the alert is drained";
  client_below_->end({});
  EXPECT_TRUE(client_says_.closed_as(Why::Untrusted));
  EXPECT_NE(client_says_.ending->reason.find("is for localhost, not for example.org"),
            std::string::npos)
      << client_says_.ending->reason;
  server_below_->end({});
  EXPECT_TRUE(server_says_.closed_as(Why::Untrusted));
  EXPECT_EQ(server_says_.heard, "");
}

}  // namespace
}  // namespace aucast::link

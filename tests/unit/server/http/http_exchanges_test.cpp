#include "server/http/http_exchanges.h"

#include <gtest/gtest.h>

#include "server/settings/limits.h"
#include "tests/support/fake_link.h"

namespace aucast::server {
namespace {

using namespace std::chrono_literals;
using test::FakeLink;

constexpr const char* kGet = "GET / HTTP/1.1\r\nHost: a\r\n\r\n";

class HttpExchangesTest : public ::testing::Test {
 protected:
  std::shared_ptr<FakeLink> connect() {
    auto link = std::make_shared<FakeLink>();
    exchanges_.begin(link, {});
    return link;
  }

  SharedBytes file_ = std::make_shared<const std::string>(100'000, 'x');
  HttpExchanges exchanges_{2,
                           {4096,
                            [this](HttpExchange& exchange, const web::HttpRequest&) {
                              exchange.reply({{}, file_});
                            },
                            [](HttpExchange& exchange, const web::HttpReply& why) {
                              exchange.reply({why, nullptr});
                            }}};
};

TEST_F(HttpExchangesTest, WhoTakesSomeOfAFileNowAndThenGetsAllOfIt) {
  const auto link = connect();
  link->take(1000);
  link->say(kGet);
  std::string heard;
  for (int i = 0; i < 100 && !link->finished(); ++i) {
    link->advance(kWebStallTimeMax - 1ms);
    link->take(20'000);
    heard += link->heard();
  }
  EXPECT_TRUE(link->finished());
  EXPECT_TRUE(heard.ends_with("\r\n\r\n" + *file_));
}

TEST_F(HttpExchangesTest, WhoTakesNothingOfAFileIsLeft) {
  const auto link = connect();
  link->take(1000);
  link->say(kGet);
  link->advance(kWebStallTimeMax - 1ms);
  EXPECT_FALSE(link->closed());
  link->advance(1ms);
  EXPECT_TRUE(link->closed());
}

TEST_F(HttpExchangesTest, WhoAsksForNothingIsLeft) {
  const auto link = connect();
  link->say("GET / HT");
  link->advance(kHttpTimeMax);
  EXPECT_TRUE(link->closed());
}

TEST_F(HttpExchangesTest, OfTooManyTheOldestThatAsksForNothingGoes) {
  const auto asks = connect();
  asks->take(1000);
  asks->say(kGet);
  const auto silent = connect();
  const auto next = connect();
  EXPECT_TRUE(silent->closed());
  EXPECT_FALSE(asks->closed());
  next->take(1000);
  next->say(kGet);
  connect();
  EXPECT_TRUE(asks->closed()) << "where all have asked, the oldest";
}

TEST_F(HttpExchangesTest, BytesThatAreNoRequestAreRefused) {
  const auto link = connect();
  link->say("{hello v=2}\r\n\r\n");
  EXPECT_TRUE(link->heard().starts_with("HTTP/1.1 400 "));
  EXPECT_TRUE(link->finished());
}

}  // namespace
}  // namespace aucast::server

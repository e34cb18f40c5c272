// Streams that are brought to a server, which is the test.
#include "server/push/pushers.h"

#include <string>
#include <system_error>
#include <vector>

#include <gtest/gtest.h>
#include <asio/ip/tcp.hpp>

#include "tests/support/quiet_log.h"
#include "tests/support/run_until.h"

namespace aucast::server {
namespace {

using asio::ip::tcp;

class PushersTest : public ::testing::Test {
 protected:
  PushSettings to(std::vector<std::string> addresses) {
    PushSettings settings;
    settings.addresses = std::move(addresses);
    return settings;
  }
  [[nodiscard]] std::string here() const {
    return "aucast://127.0.0.1:" + std::to_string(acceptor_.local_endpoint().port()) + "/one";
  }
  /// Whether somebody has connected.
  [[nodiscard]] bool knocked() {
    acceptor_.non_blocking(true);
    std::error_code error;
    static_cast<void>(acceptor_.accept(error));
    return !error;
  }
  /// Until it was looked so many times whether there is something to bring.
  [[nodiscard]] bool runs_until_asked(int times) {
    const int until = asked_ + times;
    return test::run_until(io_, [&] { return asked_ >= until; });
  }
  const test::QuietLog quiet_;
  asio::io_context io_;
  tcp::acceptor acceptor_{io_, {asio::ip::address_v4::loopback(), 0}};
  int asked_ = 0;
  Pushers pushers_{io_,
                   {[this](const std::string&) {
                      ++asked_;
                      return nullptr;
                    },
                    {}}};
};

TEST_F(PushersTest, EachAddressHasAConnectionOfItsOwn) {
  ASSERT_TRUE(
      pushers_.open(to({"aucast://a.example/one", "aucast://b.example:4651/two"}), "id", 0));
  Status status;
  pushers_.describe(status);
  ASSERT_EQ(status.pushes.size(), 2U);
  EXPECT_EQ(status.pushes[0].stream, "one");
  EXPECT_EQ(status.pushes[0].server, "a.example:4650");
  EXPECT_EQ(status.pushes[1].stream, "two");
  EXPECT_EQ(status.pushes[1].server, "b.example:4651");
  EXPECT_FALSE(status.pushes[1].sending);
}

TEST_F(PushersTest, AnAddressThatIsNoneIsAUsageError) {
  const auto opened = pushers_.open(to({"aucast://"}), "id", 0);
  ASSERT_FALSE(opened.has_value());
  EXPECT_EQ(opened.error().kind, ErrorKind::Usage);
}

TEST_F(PushersTest, NobodyIsDialledWhileThereIsNothingToBring) {
  ASSERT_TRUE(pushers_.open(to({here()}), "id", 0));
  pushers_.start();
  EXPECT_TRUE(runs_until_asked(2));
  EXPECT_FALSE(knocked());
}

TEST_F(PushersTest, WithoutAddressesNothingIsWaitedFor) {
  ASSERT_TRUE(pushers_.open(to({}), "id", 0));
  pushers_.start();
  EXPECT_EQ(io_.run(), 0U);
}

}  // namespace
}  // namespace aucast::server

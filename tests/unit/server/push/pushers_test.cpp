#include "server/push/pushers.h"

#include <gtest/gtest.h>

namespace aucast::server {
namespace {

class PushersTest : public ::testing::Test {
 protected:
  PushSettings to(std::vector<std::string> addresses) {
    PushSettings settings;
    settings.addresses = std::move(addresses);
    return settings;
  }

  asio::io_context io_;
  Pushers pushers_{io_, {[](const std::string&) { return nullptr; }, {}}};
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
  ASSERT_TRUE(pushers_.open(to({"aucast://a.example/one"}), "id", 0));
  pushers_.start();
  EXPECT_GT(io_.run_one(), 0U) << "asks again whether there is";
  Status status;
  pushers_.describe(status);
  EXPECT_EQ(status.pushes.at(0).connects, 0U);
  pushers_.stop();
  io_.run();
}

TEST_F(PushersTest, WithoutAddressesNothingIsWaitedFor) {
  ASSERT_TRUE(pushers_.open(to({}), "id", 0));
  pushers_.start();
  EXPECT_EQ(io_.run(), 0U);
}

}  // namespace
}  // namespace aucast::server

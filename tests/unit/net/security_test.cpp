#include "client/net/security.h"

#include <gtest/gtest.h>

#include "tests/support/temp_folder.h"

namespace aucast::net {
namespace {

TEST(Security, ShowsNoTokenToWhoeverIsOnTheWay) {
  const aucast::test::TempFolder folder;
  SecurityOptions options;
  options.token = folder.write("token", "word\n");
  EXPECT_EQ(load_security(options, "127.0.0.1")->token, "word");
  EXPECT_EQ(load_security(options, "")->token, "word") << "no host yet: it is looked at later";
  const auto refused = load_security(options, "example.org");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::Usage);
  EXPECT_EQ(refused.error().message.find("word"), std::string::npos);
  options.insecure_token = true;
  EXPECT_TRUE(load_security(options, "example.org"));
  options.insecure_token = false;
  options.tls = true;
  EXPECT_TRUE(load_security(options, "example.org"));
  options.token = "/nowhere";
  EXPECT_EQ(load_security(options, "example.org").error().kind, ErrorKind::Unreadable);
}

}  // namespace
}  // namespace aucast::net

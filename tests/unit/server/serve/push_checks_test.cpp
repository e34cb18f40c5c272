#include "server/serve/push_checks.h"

#include <gtest/gtest.h>

#include "tests/support/kept_log.h"
#include "tests/support/temp_folder.h"

namespace aucast::server {
namespace {

TEST(PushChecks, SaysHowManyPublishersThereAre) {
  const test::TempFolder folder;
  TransmitterOptions options;
  const auto nothing = check_pushes(options);
  ASSERT_TRUE(nothing);
  EXPECT_EQ(*nothing, "");
  options.credentials.publishers = folder.write("p", "0123456789abcdef talk\nfedcba9876543210\n");
  const auto two = check_pushes(options);
  ASSERT_TRUE(two) << two.error().message;
  EXPECT_EQ(*two,
            options.credentials.publishers.string() + ": 2 publishers, 1 of them for any stream\n");
  options.credentials.publishers = folder.path() / "none";
  const auto missing = check_pushes(options);
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().kind, ErrorKind::Unreadable);
}

TEST(PushChecks, AnAddressOrATokenThatWillNotDoIsAnError) {
  const test::TempFolder folder;
  TransmitterOptions options;
  options.push.addresses = {"aucasts://campus/talk"};
  EXPECT_TRUE(check_pushes(options));
  options.push.token = folder.path() / "none";
  EXPECT_FALSE(check_pushes(options));
  options.push.token = folder.write("token", "0123456789abcdef\n");
  EXPECT_TRUE(check_pushes(options));
  options.push.addresses.emplace_back("aucast://campus/talk");
  EXPECT_FALSE(check_pushes(options)) << "everybody on the way could read the token";
  options.push = {};
  options.push.addresses = {"http://campus"};
  EXPECT_FALSE(check_pushes(options));
}

TEST(PushChecks, ShortTokensOfOneFileAreWarnedOfOnce) {
  const test::TempFolder folder;
  const test::KeptLog log;
  TransmitterOptions options;
  options.credentials.publishers = folder.write("publishers", "one\ntwo\n0123456789abcdef\n");
  ASSERT_TRUE(check_pushes(options));
  const std::string said = log.said();
  const std::string warning = "publishers: 2 tokens of fewer than 16 characters may be guessed";
  ASSERT_NE(said.find(warning), std::string::npos) << said;
  EXPECT_EQ(said.find("may be guessed", said.find(warning) + warning.size()), std::string::npos);
}

}  // namespace
}  // namespace aucast::server

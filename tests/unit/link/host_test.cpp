#include "common/link/host.h"

#include <gtest/gtest.h>

#include "common/link/name_lookup.h"

namespace aucast::link {
namespace {

using namespace std::chrono_literals;

TEST(Host, LocalhostNeedsNoResolver) {
  const Addresses found = known_addresses("au.localhost", 4650);
  ASSERT_EQ(found.size(), 2U);
  for (const auto& address : found) {
    EXPECT_TRUE(address.address().is_loopback());
    EXPECT_EQ(address.port(), 4650);
  }
}

TEST(Host, AddressInNumbersNeedsNoResolver) {
  EXPECT_EQ(known_addresses("10.1.2.3", 1).size(), 1U);
  EXPECT_EQ(known_addresses("fe80::1", 1).size(), 1U);
  EXPECT_TRUE(known_addresses("example.org", 1).empty());
}

TEST(Host, MessagesNameHostAndPort) {
  EXPECT_EQ(host_and_port("example.org", 4650), "example.org:4650");
  EXPECT_EQ(host_and_port("::1", 80), "[::1]:80");
  EXPECT_EQ(host_and_port("[::1]", 80), "[::1]:80");
  EXPECT_EQ(host_and_port("a\x1b[0m", 1), "a\\x1b[0m:1");
}

TEST(Host, TimesInMessages) {
  EXPECT_EQ(time_text(10s), "10 s");
  EXPECT_EQ(time_text(250ms), "250 ms");
}

}  // namespace
}  // namespace aucast::link

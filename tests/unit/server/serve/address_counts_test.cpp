#include "server/serve/address_counts.h"

#include <gtest/gtest.h>

namespace aucast::server {
namespace {

AddressKey key(const char* address) {
  return address_key(asio::ip::make_address(address));
}

TEST(AddressCounts, CountsByAddressAndForgets) {
  AddressCounts counts;
  for (const char* address :
       {"10.0.0.1", "::ffff:10.0.0.1", "10.0.0.2", "2001:db8:1:2::5", "2001:db8:1:2:9::1"}) {
    counts.add(key(address));
  }
  EXPECT_EQ(counts.count(key("10.0.0.1")), 2U);
  EXPECT_EQ(counts.count(key("10.0.0.3")), 0U);
  EXPECT_EQ(counts.count(key("2001:db8:1:2::")), 2U);
  EXPECT_EQ(counts.count(key("2001:db8:1:3::")), 0U);
  counts.remove(key("10.0.0.1"));
  EXPECT_EQ(counts.count(key("10.0.0.1")), 1U);
  counts.remove(key("10.0.0.1"));
  EXPECT_EQ(counts.count(key("10.0.0.1")), 0U);
}

}  // namespace
}  // namespace aucast::server

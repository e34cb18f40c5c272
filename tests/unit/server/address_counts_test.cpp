#include "server/serve/address_counts.h"

#include <gtest/gtest.h>

namespace aucast::server {
namespace {

using asio::ip::make_address;

TEST(AddressCounts, CountsByAddressAndForgets) {
  AddressCounts counts;
  counts.add(1, make_address("10.0.0.1"));
  counts.add(2, make_address("::ffff:10.0.0.1"));
  counts.add(3, make_address("10.0.0.2"));
  counts.add(4, make_address("2001:db8:1:2::5"));
  counts.add(5, make_address("2001:db8:1:2:9::1"));
  EXPECT_EQ(counts.count(make_address("10.0.0.1")), 2U);
  EXPECT_EQ(counts.count(make_address("10.0.0.3")), 0U);
  EXPECT_EQ(counts.count(make_address("2001:db8:1:2::")), 2U);
  EXPECT_EQ(counts.count(make_address("2001:db8:1:3::")), 0U);
  counts.remove(1);
  counts.remove(1);
  counts.remove(99);
  EXPECT_EQ(counts.count(make_address("10.0.0.1")), 1U);
}

}  // namespace
}  // namespace aucast::server

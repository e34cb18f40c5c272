#include "protocol/server_chain.h"

#include <gtest/gtest.h>

#include "protocol/limits.h"

namespace aucast::protocol {
namespace {

TEST(ServerChain, NamesTheServersInTheirOrder) {
  std::string chain;
  EXPECT_EQ(servers_in(chain), 0U);
  for (const char* id : {"origin", "north", "south"}) chain = chained(std::move(chain), id);
  EXPECT_EQ(chain, "origin,north,south");
  EXPECT_EQ(servers_in(chain), 3U);
}

TEST(ServerChain, KnowsAServerByItsWholeId) {
  EXPECT_TRUE(passes_through("origin,north,south", "origin"));
  EXPECT_TRUE(passes_through("origin,north,south", "south"));
  EXPECT_FALSE(passes_through("origin,north,south", "nor"));
  EXPECT_FALSE(passes_through("origin,north,south", "north,south"));
  EXPECT_FALSE(passes_through("origin,north,south", "North"));
  EXPECT_FALSE(passes_through("", "north"));
}

TEST(ServerChain, HasAsManyIdsAsThereMayBeRelays) {
  std::string chain;
  for (std::size_t i = 0; i < kRelayHopsMax; ++i) {
    chain = chained(std::move(chain), "r" + std::to_string(i));
    EXPECT_TRUE(is_server_chain(chain)) << chain;
  }
  EXPECT_FALSE(is_server_chain(chained(std::move(chain), "more")));
}

TEST(ServerChain, IsNoneWithAnIdThatIsNone) {
  for (const char* wrong :
       {"", ",", "a,", ",a", "a,,b", "a b", "a,b c", "a;b", "a,\x80", "a={b}"}) {
    EXPECT_FALSE(is_server_chain(wrong)) << wrong;
  }
  const std::string longest(kServerIdBytesMax, 'x');
  EXPECT_TRUE(is_server_id(longest));
  EXPECT_TRUE(is_server_chain("a," + longest));
  EXPECT_FALSE(is_server_id(longest + 'x'));
  EXPECT_FALSE(is_server_chain("a," + longest + 'x'));
}

}  // namespace
}  // namespace aucast::protocol

#include "common/own_computer.h"

#include <gtest/gtest.h>

namespace aucast {
namespace {

TEST(OwnComputer, LocalhostIsEveryNameThatRfc6761KeepsForIt) {
  for (const char* host :
       {"localhost", "LocalHost", "localhost.", "au.localhost", "a.b.Localhost."})
    EXPECT_TRUE(is_localhost(host)) << host;
  for (const char* host : {"", ".", "localhost.example.org", "notlocalhost", "local", "127.0.0.1"})
    EXPECT_FALSE(is_localhost(host)) << host;
}

TEST(OwnComputer, IsLocalhostOrTheLoopback) {
  for (const char* host : {"localhost", "au.localhost", "127.0.0.1", "127.9.9.9", "::1"})
    EXPECT_TRUE(is_own_computer(host)) << host;
  for (const char* host : {"localhost.example.org", "10.0.0.1", "0.0.0.0", "", "example.org"})
    EXPECT_FALSE(is_own_computer(host)) << host;
}

}  // namespace
}  // namespace aucast

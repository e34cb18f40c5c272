#include "common/web/origin.h"

#include <gtest/gtest.h>

namespace aucast::web {
namespace {

const std::vector<std::string> kNames = {"Monitor.example", "*.campus.example"};

TEST(IsOwnHost, TakesAddressesLocalhostAndItsNames) {
  for (const char* own : {"127.0.0.1", "127.0.0.1:9464", "192.168.1.7", "[::1]", "[::1]:9464",
                          "localhost", "LocalHost:80", "localhost.", "monitor.example:9464",
                          "au.campus.example", "AU.Campus.Example.:443", ""}) {
    EXPECT_TRUE(is_own_host(own, kNames)) << own;
  }
  for (const char* other :
       {"evil.example", "evil.example:9464", "localhost.evil.example", "[evil]", "campus.example",
        "127.0.0.1.evil.example", "1", "::1x", "[::1", " ", ".campus.example", "a.b.campus.example",
        "au.campus.example.evil.example"}) {
    EXPECT_FALSE(is_own_host(other, kNames)) << other;
  }
}

TEST(IsOwnOrigin, TakesTheSameHostTheOwnComputerAndItsNames) {
  for (const char* own : {"", "http://10.0.0.7:8080", "https://10.0.0.7", "http://localhost:3000",
                          "http://127.0.0.1", "http://[::1]:80", "http://au.localhost:3000",
                          "https://Monitor.example", "https://course.campus.example:444"}) {
    EXPECT_TRUE(is_own_origin(own, "10.0.0.7:8080", kNames)) << own;
  }
  for (const char* other :
       {"null", "https://evil.example", "http://10.0.0.8:8080", "http://6.6.6.6", "10.0.0.7:8080",
        "http://10.0.0.7.evil.example", "http://127.evil.example", "http://", "://", "file://",
        "https://evil.example:10.0.0.7"}) {
    EXPECT_FALSE(is_own_origin(other, "10.0.0.7:8080", kNames)) << other;
  }
}

}  // namespace
}  // namespace aucast::web

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "client/net/remote_source.h"

namespace aucast::net {
namespace {

void expect_endpoint(std::string_view text, const std::string& host, std::uint16_t port) {
  SCOPED_TRACE(text);
  const auto endpoint = parse_endpoint(text);
  ASSERT_TRUE(endpoint) << endpoint.error().message;
  EXPECT_EQ(endpoint->host, host);
  EXPECT_EQ(endpoint->port, port);
}

TEST(Endpoint, IsAHostWithTheDefaultPort) {
  expect_endpoint("localhost", "localhost", 4650);
  expect_endpoint("192.168.1.7", "192.168.1.7", 4650);
  expect_endpoint("face-1.example.org", "face-1.example.org", 4650);
}

TEST(Endpoint, IsAHostWithAPort) {
  expect_endpoint("localhost:4651", "localhost", 4651);
  expect_endpoint("127.0.0.1:1", "127.0.0.1", 1);
  expect_endpoint("h:65535", "h", 65535);
}

TEST(Endpoint, IsAnIpv6AddressInBracketsOrAlone) {
  expect_endpoint("[::1]:4651", "::1", 4651);
  expect_endpoint("[2001:db8::7]", "2001:db8::7", 4650);
  expect_endpoint("::1", "::1", 4650);
  expect_endpoint("fe80::1%eth0", "fe80::1%eth0", 4650);
  expect_endpoint("[fe80::1%eth0]:80", "fe80::1%eth0", 80);
}

TEST(Endpoint, SaysWhatIsWrong) {
  struct Wrong {
    std::string text;
    std::string reason;
  };
  const std::vector<Wrong> all{
      {"", "there is no host"},
      {":4650", "there is no host"},
      {"host:", "the port must be a number from 1 to 65535"},
      {"host:0", "the port must be a number from 1 to 65535"},
      {"host:65536", "the port must be a number from 1 to 65535"},
      {"host:-1", "the port must be a number from 1 to 65535"},
      {"host:12x", "the port must be a number from 1 to 65535"},
      {"host: 12", "the port must be a number from 1 to 65535"},
      {"host:99999999999999999999", "the port must be a number from 1 to 65535"},
      {"[::1", "the bracket is not closed"},
      {"[]:4650", "an IPv6 address must stand in the brackets"},
      {"[localhost]:4650", "an IPv6 address must stand in the brackets"},
      {"[::1]4650", "only :PORT may follow the bracket"},
      {"[::1]:", "the port must be a number from 1 to 65535"},
      {"a:b:c", "an IPv6 address with a port needs brackets"},
      {"::1::2", "an IPv6 address with a port needs brackets"},
      {"my host", "a host has no blanks, brackets or special bytes"},
      {"host]", "a host has no blanks, brackets or special bytes"},
      {"host\n:1", "a host has no blanks, brackets or special bytes"},
  };
  for (const Wrong& wrong : all) {
    SCOPED_TRACE(wrong.text);
    const auto endpoint = parse_endpoint(wrong.text);
    ASSERT_FALSE(endpoint);
    EXPECT_EQ(endpoint.error().kind, ErrorKind::Usage);
    EXPECT_NE(endpoint.error().message.find(wrong.reason), std::string::npos)
        << endpoint.error().message;
    EXPECT_NE(endpoint.error().message.find("use HOST, HOST:PORT or [IPV6]:PORT"),
              std::string::npos);
  }
}

TEST(Endpoint, EscapesWhatItCannotRead) {
  const auto endpoint = parse_endpoint("ho\x1bst");
  ASSERT_FALSE(endpoint);
  EXPECT_NE(endpoint.error().message.find("'ho\\x1bst'"), std::string::npos)
      << endpoint.error().message;
}

}  // namespace
}  // namespace aucast::net

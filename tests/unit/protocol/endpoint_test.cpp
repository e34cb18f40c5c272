#include "protocol/endpoint.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace aucast::protocol {
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
      {"my host", "a host has no blanks, brackets, quotes, backslashes or special bytes"},
      {"host]", "a host has no blanks, brackets, quotes, backslashes or special bytes"},
      {"a\"b", "a host has no blanks, brackets, quotes, backslashes or special bytes"},
      {"b\\c:9", "a host has no blanks, brackets, quotes, backslashes or special bytes"},
      {"host\n:1", "a host has no blanks, brackets, quotes, backslashes or special bytes"},
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

TEST(StreamAddress, IsAHostAndAStream) {
  const auto address = parse_stream_address("aucast://origin.example.org/talk");
  ASSERT_TRUE(address) << address.error().message;
  EXPECT_EQ(*address, (StreamAddress{{{"origin.example.org", 4650}}, false, "talk"}));
}

TEST(StreamAddress, NamesSeveralHostsInTheirOrder) {
  const auto address = parse_stream_address("aucasts://a:1,[::1]:2,b/smile.v2");
  ASSERT_TRUE(address) << address.error().message;
  EXPECT_EQ(*address, (StreamAddress{{{"a", 1}, {"::1", 2}, {"b", 4650}}, true, "smile.v2"}));
}

TEST(StreamAddress, MayLeaveTheStreamToTheServer) {
  for (const char* text : {"aucast://a", "aucast://a/"}) {
    const auto address = parse_stream_address(text);
    ASSERT_TRUE(address) << address.error().message;
    EXPECT_EQ(address->stream, "") << text;
  }
}

TEST(StreamAddress, IsToldFromAFileByItsBeginning) {
  EXPECT_TRUE(is_stream_address("aucast://"));
  EXPECT_TRUE(is_stream_address("aucasts://a"));
  for (const char* text : {"aucast", "aucast:/a", "talk.txt", "http://a/b", "", "xaucast://a"}) {
    EXPECT_FALSE(is_stream_address(text)) << text;
  }
}

TEST(StreamAddress, SaysWhatIsWrongWithIt) {
  const struct {
    const char* text;
    const char* reason;
  } wrongs[] = {
      {"aucast://", "there is no host"},
      {"aucast:///talk", "there is no host"},
      {"aucast://a,/talk", "there is no host"},
      {"aucast://a:0/talk", "the port must be a number"},
      {"aucast://a/b/c", "a stream's name has"},
      {"aucast://a/t lk", "a stream's name has"},
      {"aucast://a b/talk", "a host has no blanks"},
      {"aucast://[::1/talk", "the bracket is not closed"},
      {"talk.txt", "it begins with neither"},
  };
  for (const auto& wrong : wrongs) {
    SCOPED_TRACE(wrong.text);
    const auto address = parse_stream_address(wrong.text);
    ASSERT_FALSE(address);
    EXPECT_EQ(address.error().kind, ErrorKind::Usage);
    EXPECT_NE(address.error().message.find(wrong.reason), std::string::npos)
        << address.error().message;
    EXPECT_NE(address.error().message.find("use aucast://HOST"), std::string::npos);
  }
}

TEST(EngineAddress, NamesServersAndAlwaysAStream) {
  const auto address = parse_engine_address("nats://hub1,hub2:4333,[::1]/talk");
  ASSERT_TRUE(address) << address.error().message;
  EXPECT_EQ(*address,
            (StreamAddress{{{"hub1", 4222}, {"hub2", 4333}, {"::1", 4222}}, false, "talk"}));
  EXPECT_TRUE(parse_engine_address("natss://hub/smile.v2")->tls);
  EXPECT_TRUE(is_engine_address("natss://"));
  EXPECT_FALSE(is_engine_address("aucast://a/talk"));
  EXPECT_FALSE(is_stream_address("nats://a/talk"));
}

TEST(EngineAddress, SaysWhatIsWrongWithIt) {
  const struct {
    const char* text;
    const char* reason;
  } wrongs[] = {
      {"nats://hub", "it names no stream"},
      {"nats://hub/", "it names no stream"},
      {"nats://user@hub/talk", "secrets are read from files"},
      {"nats://hub/.talk", "before and after each '.'"},
      {"nats://hub/talk..2", "before and after each '.'"},
      {"nats://hub/ta*k", "a stream's name has"},
      {"nats:///talk", "there is no host"},
      {"aucast://hub/talk", "it begins with neither"},
  };
  for (const auto& wrong : wrongs) {
    SCOPED_TRACE(wrong.text);
    const auto address = parse_engine_address(wrong.text);
    ASSERT_FALSE(address);
    EXPECT_EQ(address.error().kind, ErrorKind::Usage);
    EXPECT_NE(address.error().message.find(wrong.reason), std::string::npos)
        << address.error().message;
    EXPECT_NE(address.error().message.find("use nats://HOST"), std::string::npos);
  }
}

}  // namespace
}  // namespace aucast::protocol

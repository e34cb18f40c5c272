#include "server/web/web_gate.h"

#include <gtest/gtest.h>

namespace aucast::server {
namespace {

web::HttpRequest upgrade(const std::string& host, const std::string& origin) {
  return {.path = "/aucast",
          .version_1_1 = true,
          .fields = {{"host", host},
                     {"origin", origin},
                     {"upgrade", "websocket"},
                     {"connection", "Upgrade"},
                     {"sec-websocket-version", "13"},
                     {"sec-websocket-key", "dGhlIHNhbXBsZSBub25jZQ=="}}};
}

TEST(WebGate, OtherHostsAndPagesOfOthersAreRefusedWithTheRemedy) {
  const std::vector<std::string> names = {"au.example"};
  EXPECT_FALSE(refuse_host(upgrade("au.example:8080", ""), names));
  const auto host = refuse_host(upgrade("evil.example", ""), names);
  ASSERT_TRUE(host);
  EXPECT_EQ(host->status, 421);
  EXPECT_NE(host->body.find("--web-host NAME"), std::string::npos);
  EXPECT_FALSE(refuse_web_socket(upgrade("10.0.0.7", "https://au.example"), names));
  const auto origin = refuse_web_socket(upgrade("10.0.0.7", "https://evil.example"), names);
  ASSERT_TRUE(origin);
  EXPECT_EQ(origin->status, 403);
  EXPECT_NE(origin->body.find("--web-host"), std::string::npos);
  web::HttpRequest plain = upgrade("10.0.0.7", "");
  plain.fields.erase("upgrade");
  EXPECT_EQ(refuse_web_socket(plain, names)->status, 426);
}

/// Who asks, by what is in X-Forwarded-For.
std::string who(const std::string& forwarded, const std::string& peer = "10.0.0.1",
                const std::vector<std::string>& proxies = {"10.0.0.1", "10.0.0.2"}) {
  web::HttpRequest request;
  if (!forwarded.empty()) request.fields["x-forwarded-for"] = forwarded;
  const Asker from = asker(request, asio::ip::make_address(peer), proxies);
  return from.address.to_string() + (from.unread.empty() ? "" : " not " + from.unread);
}

TEST(WebGate, OnlyATrustedProxySaysWhoAsks) {
  EXPECT_EQ(who("1.2.3.4", "10.0.0.3"), "10.0.0.3");
  EXPECT_EQ(who("1.2.3.4", "10.0.0.1", {}), "10.0.0.1");
  EXPECT_EQ(who("1.2.3.4"), "1.2.3.4");
  EXPECT_EQ(who("1.2.3.4", "::ffff:10.0.0.1"), "1.2.3.4");
  EXPECT_EQ(who("::ffff:1.2.3.4"), "1.2.3.4");
  EXPECT_EQ(who("2001:db8::7"), "2001:db8::7");
}

TEST(WebGate, WhatTheProxyHeardFromOthersIsNotBelieved) {
  EXPECT_EQ(who("6.6.6.6, 1.2.3.4"), "1.2.3.4");
  EXPECT_EQ(who("6.6.6.6, 1.2.3.4, 10.0.0.2"), "1.2.3.4") << "by way of the other proxy";
  EXPECT_EQ(who(""), "10.0.0.1");
  EXPECT_EQ(who("unknown"), "10.0.0.1 not unknown");
  EXPECT_EQ(who("1.2.3.4, unknown"), "10.0.0.1 not unknown");
  EXPECT_EQ(who("unknown", "10.0.0.3"), "10.0.0.3") << "nobody asked";
}

TEST(WebGate, AProxyMayAddThePortAndBrackets) {
  EXPECT_EQ(who("1.2.3.4:5000"), "1.2.3.4");
  EXPECT_EQ(who("[2001:db8::1]"), "2001:db8::1");
  EXPECT_EQ(who("6.6.6.6, [2001:db8::1]:443"), "2001:db8::1");
  EXPECT_EQ(who("1.2.3.4:443, 10.0.0.2:80"), "1.2.3.4");
}

}  // namespace
}  // namespace aucast::server

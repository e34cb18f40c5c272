#include "client/gui/model/remote_settings.h"

#include <gtest/gtest.h>

namespace aucast::gui {
namespace {

std::string problem_of(void (*change)(RemoteSettings&)) {
  RemoteSettings settings;
  change(settings);
  return problem(settings).value_or("");
}

TEST(RemoteSettings, TheDefaultsCanBeUsed) {
  EXPECT_EQ(problem(RemoteSettings{}), std::nullopt);
}

TEST(RemoteSettings, TheLimitsCanBeUsed) {
  EXPECT_EQ(problem(RemoteSettings{"h", 1, 1, 1, 1, 0}), std::nullopt);
  EXPECT_EQ(problem(RemoteSettings{"2001:db8::1", 65535, 10'000, 10'000, 100, 1000}), std::nullopt);
}

TEST(RemoteSettings, SayWhatIsWrongAndWhatIsRight) {
  EXPECT_EQ(problem_of([](RemoteSettings& s) { s.address.clear(); }),
            "enter the address of an au-transmitter");
  EXPECT_EQ(problem_of([](RemoteSettings& s) { s.address = "a b"; }),
            "an address has no blanks and only ASCII characters");
  EXPECT_EQ(problem_of([](RemoteSettings& s) { s.address = "h\xc3\xb6rst"; }),
            "an address has no blanks and only ASCII characters");
  EXPECT_EQ(problem_of([](RemoteSettings& s) { s.address.assign(254, 'a'); }),
            "this address is too long");
  EXPECT_EQ(problem_of([](RemoteSettings& s) { s.port = 0; }), "the port must be 1 to 65535");
  EXPECT_EQ(problem_of([](RemoteSettings& s) { s.port = 65536; }), "the port must be 1 to 65535");
  EXPECT_EQ(problem_of([](RemoteSettings& s) { s.buffer = 10'001; }),
            "the buffer must be 1 to 10000");
  EXPECT_EQ(problem_of([](RemoteSettings& s) { s.playout = 0; }),
            "the playout buffer must be 1 to 10000");
  EXPECT_EQ(problem_of([](RemoteSettings& s) { s.playout = s.buffer + 1; }),
            "the playout buffer must not be larger than the buffer");
  EXPECT_EQ(problem_of([](RemoteSettings& s) { s.threshold_percent = 101; }),
            "the threshold must be 1 to 100");
  EXPECT_EQ(problem_of([](RemoteSettings& s) { s.speed_ms = 1001; }),
            "the speed must be 0 to 1000");
  EXPECT_EQ(problem_of([](RemoteSettings& s) { s.speed_ms = -1; }), "the speed must be 0 to 1000");
}

TEST(RemoteSettings, AnAddressIsWrittenAndReadAlike) {
  for (const char* text :
       {"example.org", "example.org:4651", "[::1]", "[fe80::1]:9", "10.0.0.7",
        "aucast://example.org/lecture", "aucasts://[::1]:9/a.b", "aucasts://example.org",
        "aucast://one.example,[::1]:9/talk", "aucasts://a,b,c:4651"}) {
    RemoteSettings settings;
    ASSERT_EQ(take_address(text, settings), std::nullopt) << text;
    EXPECT_EQ(address_text(settings), text);
    EXPECT_EQ(problem(settings), std::nullopt);
  }
}

TEST(RemoteSettings, AnAddressIsReadAsPeopleWriteIt) {
  RemoteSettings settings;
  ASSERT_EQ(take_address(" example.org:4777/lecture ", settings), std::nullopt);
  EXPECT_EQ(settings.address, "example.org");
  EXPECT_EQ(settings.port, 4777);
  EXPECT_EQ(settings.stream, "lecture");
  ASSERT_EQ(take_address("aucasts://example.org", settings), std::nullopt);
  EXPECT_EQ(settings.port, 4650);
  EXPECT_TRUE(settings.stream.empty()) << "that was another server's";
  EXPECT_TRUE(settings.tls);
  ASSERT_EQ(take_address("example.org", settings), std::nullopt);
  EXPECT_FALSE(settings.tls);
  ASSERT_EQ(take_address("a,b:7/talk", settings), std::nullopt);
  EXPECT_EQ(settings.address, "a");
  EXPECT_EQ(settings.others, (std::vector<protocol::Endpoint>{{"b", 7}}));
  EXPECT_EQ(settings.stream, "talk");
  ASSERT_EQ(take_address("a", settings), std::nullopt);
  EXPECT_TRUE(settings.others.empty()) << "those belonged to the address before";
}

TEST(RemoteSettings, WhatIsNoAddressChangesNothingAndIsSaid) {
  RemoteSettings settings;
  for (const char* text : {"", " ", ":1", "a:", "a:b", "[::1", "[::1]x", "[::1]:", "a:99999999999",
                           "http://a", "a b", "aucast://", "aucast://a/b/c", "aucast://a,/s"}) {
    EXPECT_NE(take_address(text, settings), std::nullopt) << text;
  }
  EXPECT_EQ(settings, RemoteSettings{});
  EXPECT_EQ(take_address("a:b", settings),
            "this is no address: use HOST, HOST:PORT or aucast://HOST/STREAM");
}

}  // namespace
}  // namespace aucast::gui

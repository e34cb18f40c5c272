#include "client/gui/remote_settings.h"

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
  EXPECT_EQ(problem({"h", 1, 1, 1, 1, 0}), std::nullopt);
  EXPECT_EQ(problem({"2001:db8::1", 65535, 10'000, 10'000, 100, 1000}), std::nullopt);
}

TEST(RemoteSettings, SayWhatIsWrongAndWhatIsRight) {
  EXPECT_EQ(problem_of([](RemoteSettings& s) { s.address.clear(); }),
            "enter the address of an au-transmitter");
  EXPECT_EQ(problem_of([](RemoteSettings& s) { s.address = "a b"; }),
            "an address has no blanks and only plain letters");
  EXPECT_EQ(problem_of([](RemoteSettings& s) { s.address = "h\xc3\xb6rst"; }),
            "an address has no blanks and only plain letters");
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

}  // namespace
}  // namespace aucast::gui

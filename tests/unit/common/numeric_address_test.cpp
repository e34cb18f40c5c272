#include "common/numeric_address.h"

#include <gtest/gtest.h>

namespace aucast {
namespace {

using namespace std::string_literals;

TEST(NumericAddress, IsFourBytesOrSixteen) {
  EXPECT_EQ(numeric_address("10.0.255.1"), "\x0a\x00\xff\x01"s);
  EXPECT_EQ(numeric_address("::1"), std::string(15, '\0') + '\x01');
  EXPECT_EQ(numeric_address("fe80::a").size(), 16U);
}

TEST(NumericAddress, IsNothingElse) {
  for (const char* text : {"", "localhost", "10.0.1", "10.0.0.256", "1", " ::1", "[::1]", "::1%lo",
                           "10.0.0.1:80", "0x7f.0.0.1"})
    EXPECT_EQ(numeric_address(text), "") << text;
}

}  // namespace
}  // namespace aucast

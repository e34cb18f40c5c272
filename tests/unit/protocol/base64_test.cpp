#include "protocol/base64.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/support/seeded.h"

namespace aucast::protocol {
namespace {

/// The vectors of RFC 4648 section 10, which pads.
struct Vector {
  std::string_view bytes;
  std::string_view text;
};
constexpr Vector kVectors[] = {
    {"", ""},           {"f", "Zg"},          {"fo", "Zm8"},         {"foo", "Zm9v"},
    {"foob", "Zm9vYg"}, {"fooba", "Zm9vYmE"}, {"foobar", "Zm9vYmFy"}};

TEST(Base64, IsThatOfTheStandardWithoutPadding) {
  for (const auto& [bytes, text] : kVectors) {
    EXPECT_EQ(to_base64(bytes), text);
    EXPECT_EQ(from_base64(text), bytes);
  }
  EXPECT_EQ(to_base64("\xfb\xef\xff"), "++//");
}

TEST(Base64, AnyBytesComeBack) {
  test::Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  for (int length = 0; length < 200; ++length) {
    std::string bytes;
    for (int i = 0; i < length; ++i) bytes += static_cast<char>(seeded.integer(0, 255));
    const std::string text = to_base64(bytes);
    EXPECT_EQ(text.size(), (bytes.size() * 4 + 2) / 3);
    EXPECT_EQ(text.find_first_of("= \n"), std::string::npos);
    EXPECT_EQ(from_base64(text), bytes);
  }
}

TEST(Base64, EachByteStringHasOneSpellingOnly) {
  // One character alone holds no byte; the bits that two and three leave over are 0.
  for (const char* wrong : {"Z", "Zm9vY", "Zh", "Zm9", "Zm9vYh"}) {
    EXPECT_FALSE(from_base64(wrong)) << wrong;
  }
  int readable = 0;
  for (char first = '\x21'; first < '\x7f'; ++first) {
    for (char second = '\x21'; second < '\x7f'; ++second) {
      const std::string text{first, second};
      const auto bytes = from_base64(text);
      if (!bytes) continue;
      ++readable;
      EXPECT_EQ(to_base64(*bytes), text);
    }
  }
  EXPECT_EQ(readable, 256);
}

TEST(Base64, WhatIsOutsideTheAlphabetIsNone) {
  for (const char* wrong : {"Zg==", "Zm 9v", "Zm9v\n", "-_-_", "Zm\x80v", "{m9v"}) {
    EXPECT_FALSE(from_base64(wrong)) << wrong;
  }
  EXPECT_FALSE(from_base64(std::string("Zm\0v", 4)));
}

}  // namespace
}  // namespace aucast::protocol

#include "protocol/caption.h"

#include <gtest/gtest.h>

#include <string>

#include "protocol/base64.h"
#include "protocol/codec.h"
#include "protocol/limits.h"

namespace aucast::protocol {
namespace {

/// The packet's inside, as parse_caption() is given it.
std::string inside(const std::string& packet) {
  return packet.substr(1, packet.size() - 2);
}

CaptionData parsed(const std::string& text) {
  const auto caption = parse_caption(text);
  EXPECT_TRUE(std::holds_alternative<CaptionData>(caption)) << text;
  return std::holds_alternative<CaptionData>(caption) ? std::get<CaptionData>(caption)
                                                      : CaptionData{};
}

/// "POSITION: REASON" of the fault.
std::string fault_of(const std::string& text) {
  const auto caption = parse_caption(text);
  const auto* fault = std::get_if<FieldFault>(&caption);
  return fault == nullptr ? "none" : std::to_string(fault->position) + ": " + fault->reason;
}

TEST(Caption, ComesBackAsItWasSent) {
  for (const std::string text : {"", "Hello", "two\nlines", "\xc3\xa9t\xc3\xa9", "{braces} = 1"}) {
    const CaptionData caption{1500, text};
    EXPECT_EQ(parsed(inside(encode(caption))), caption);
  }
  EXPECT_EQ(encode(CaptionData{0, ""}), "{t@0}");
  EXPECT_EQ(encode(CaptionData{40, "foo"}), "{t@40 Zm9v}");
}

TEST(Caption, TheLongestFitsIntoOnePacketWithTheLatestPlace) {
  std::string longest;
  while (is_caption(longest + 'x')) longest += 'x';
  const std::string packet = encode(CaptionData{kPlaceMsMax, longest});
  EXPECT_LE(packet.size(), kCaptionBytesMax);
  EXPECT_GT(packet.size() + 4, kCaptionBytesMax) << "more would fit";
  EXPECT_EQ(parsed(inside(packet)).text, longest);
}

TEST(Caption, OneThatFitsOnlyWithItsPlaceIsRead) {
  const std::string text(759, 'x');
  EXPECT_FALSE(is_caption(text));
  const std::string packet = encode(CaptionData{0, text});
  ASSERT_LE(packet.size(), kCaptionBytesMax);
  EXPECT_EQ(parsed(inside(packet)).text, text);
}

TEST(Caption, IsUtf8WithoutControlCharactersButLineFeeds) {
  EXPECT_TRUE(is_caption("a\nb"));
  for (const char* wrong : {"a\tb", "a\rb", "\x1b[1m", "\x7f", "\xc2\x85", "\x80", "\xc3",
                            "\xed\xa0\x80", "\xf5\x80\x80\x80", "\xc0\xaf"}) {
    EXPECT_FALSE(is_caption(wrong));
    EXPECT_FALSE(is_title(wrong));
    EXPECT_EQ(fault_of("t@5 " + to_base64(wrong)),
              "5: a caption is UTF-8 without control characters");
  }
  EXPECT_FALSE(is_caption(std::string("a\0b", 3)));
}

TEST(Caption, ATitleIsOneShortLine) {
  EXPECT_TRUE(is_title(""));
  EXPECT_TRUE(is_title("Le\xc3\xa7on 1"));
  EXPECT_FALSE(is_title("two\nlines"));
  EXPECT_TRUE(is_title(std::string(kTitleBytesMax, 'x')));
  EXPECT_FALSE(is_title(std::string(kTitleBytesMax + 1, 'x')));
}

TEST(Caption, HasAPlace) {
  EXPECT_EQ(fault_of("t Zm9v"), "3: a caption has a place: {t@PLACE DATA}");
  EXPECT_EQ(fault_of("t"), "2: a caption has a place: {t@PLACE DATA}");
  EXPECT_EQ(parsed("t@1000000000000").place_ms, 1'000'000'000'000U);
  for (const std::string place : {"", "x", "-1", "+1", "1000000000001", "00000000000001"}) {
    EXPECT_EQ(fault_of("t@" + place + " Zm9v"),
              "3: a place is a number of 0-1000000000000, found '" + place + "'");
  }
}

TEST(Caption, ItsTextIsBase64) {
  EXPECT_EQ(fault_of("t@12 Zm9"), "6: 'Zm9' is no base64 without padding");
  EXPECT_EQ(fault_of("t@12 Zg=="), "6: 'Zg==' is no base64 without padding");
  EXPECT_EQ(fault_of("t@12  Zg"), "6: ' Zg' is no base64 without padding");
}

}  // namespace
}  // namespace aucast::protocol

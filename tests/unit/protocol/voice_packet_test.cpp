#include "protocol/voice_packet.h"
#include "protocol/base64.h"

#include <gtest/gtest.h>

#include <random>

namespace aucast::protocol {
namespace {

TEST(OpusDuration, IsWhatTheTocByteSays) {
  EXPECT_EQ(opus_duration("\x48"), Milliseconds(20));      // SILK wideband 20 ms
  EXPECT_EQ(opus_duration("\x58"), Milliseconds(60));      // SILK wideband 60 ms
  EXPECT_EQ(opus_duration("\x49"), Milliseconds(40));      // two frames of 20 ms
  EXPECT_EQ(opus_duration("\x68"), Milliseconds(20));      // hybrid
  EXPECT_EQ(opus_duration("\x4b\x03"), Milliseconds(60));  // three frames of 20 ms
}

TEST(OpusDuration, IsOneOfTheFourThatTheProtocolCarries) {
  EXPECT_EQ(opus_duration("\xf0"), Milliseconds(10));  // CELT 10 ms
  EXPECT_EQ(opus_duration("\xf8"), Milliseconds(20));
  EXPECT_EQ(opus_duration("\xf9"), Milliseconds(40));
  EXPECT_EQ(opus_duration("\xfb\x03"), Milliseconds(60));
  EXPECT_FALSE(opus_duration("\xe8"));  // 5 ms
  for (const int frames : {3, 5, 7, 8, 9, 10, 11, 12}) {
    const std::string tens{'\xf3', static_cast<char>(frames)};
    EXPECT_FALSE(opus_duration(tens)) << 10 * frames << " ms";
  }
  EXPECT_TRUE(std::holds_alternative<FieldFault>(parse_voice_data("0 " + to_base64("\xf3\x03"))));
}

TEST(OpusDuration, IsNothingForWhatIsNoPacket) {
  EXPECT_FALSE(opus_duration(""));
  EXPECT_FALSE(opus_duration("\x4b"));                           // count is missing
  EXPECT_FALSE(opus_duration(std::string_view("\x4b\x00", 2)));  // no frames
  EXPECT_FALSE(opus_duration("\x4b\x3f"));                       // 1260 ms
  EXPECT_FALSE(opus_duration("\x80"));                           // CELT 2.5 ms: no whole ms
}

TEST(Base64, HasTheVectorsOfRfc4648WithoutPadding) {
  EXPECT_EQ(to_base64(""), "");
  EXPECT_EQ(to_base64("f"), "Zg");
  EXPECT_EQ(to_base64("fo"), "Zm8");
  EXPECT_EQ(to_base64("foo"), "Zm9v");
  EXPECT_EQ(to_base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(from_base64("Zm8"), "fo");
}

TEST(Base64, ComesBackForAnyBytes) {
  std::mt19937 random(4650);
  for (std::size_t length = 0; length < 200; ++length) {
    std::string bytes;
    while (bytes.size() < length) bytes += static_cast<char>(random() & 0xFFU);
    EXPECT_EQ(from_base64(to_base64(bytes)), bytes);
  }
}

TEST(Base64, EachByteStringHasOneSpellingOnly) {
  for (const char* text : {"Z", "Zh", "Zm9", "Zg==", "Zm8=", "Zm 8", "Zm\n8", "Zm-_", "ZgA=B"}) {
    EXPECT_FALSE(from_base64(text)) << text;
  }
}

}  // namespace
}  // namespace aucast::protocol

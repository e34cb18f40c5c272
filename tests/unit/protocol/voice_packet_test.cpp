#include "protocol/voice_packet.h"

#include <gtest/gtest.h>

#include "protocol/base64.h"

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

}  // namespace
}  // namespace aucast::protocol

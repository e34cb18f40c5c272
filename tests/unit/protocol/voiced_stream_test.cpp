#include "protocol/voiced_stream.h"

#include <gtest/gtest.h>

#include <numeric>

#include "tests/unit/protocol/session_text.h"

namespace aucast::protocol {
namespace {

using namespace std::chrono_literals;

EncodedStream stream_of(std::initializer_list<std::string_view> packets) {
  std::vector<Keyframe> keyframes;
  for (const std::string_view packet : packets) {
    Keyframe keyframe;
    EXPECT_FALSE(parse_keyframe(packet, TermSyntax::Wire, keyframe));
    keyframes.push_back(std::move(keyframe));
  }
  return encode_stream(keyframes, 250, 20);
}

std::string packets_of(const PacketList& list) {
  std::string text;
  for (std::size_t i = 0; i < list.size(); ++i) text += list[i];
  return text;
}

TEST(VoicedStream, IsTheStreamItselfWhereNothingLastsLong) {
  EXPECT_EQ(voiced_stream(stream_of({"1;250", "2", "0;40"}), 790ms, 250, 20), nullptr);
}

TEST(VoicedStream, LongKeyframesAreCutOnTheStraightLine) {
  const auto voiced = voiced_stream(stream_of({"12:80;40@40", "0;750@790"}), 0ms, 250, 20);
  ASSERT_NE(voiced, nullptr);
  EXPECT_EQ(packets_of(voiced->negotiated),
            "{12:80;40@40}{12:53;250@290}{12:27;250@540}{0;250@790}");
  EXPECT_EQ(voiced->duration_ms, 790U);
}

TEST(VoicedStream, PiecesOfAnOddTimeAddUp) {
  const auto voiced = voiced_stream(stream_of({"1;901"}), 0ms, 250, 20);
  ASSERT_NE(voiced, nullptr);
  EXPECT_EQ(voiced->times.size(), 4U);
  EXPECT_EQ(std::accumulate(voiced->times.begin(), voiced->times.end(), KeyframeTime(0)), 901ms);
}

TEST(VoicedStream, TheLastFaceIsHeldWhileTheVoiceGoesOn) {
  const auto voiced = voiced_stream(stream_of({"12;200"}), 600ms, 250, 20);
  ASSERT_NE(voiced, nullptr);
  EXPECT_EQ(packets_of(voiced->negotiated), "{12;200}{12;200}{12;200}");
  EXPECT_EQ(packets_of(voiced->classic), "{12}{12}{12}");
}

}  // namespace
}  // namespace aucast::protocol

#include "protocol/spoken_stream.h"

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

TEST(SpokenStream, IsTheStreamItselfWhereNothingLastsLong) {
  EXPECT_EQ(spoken_stream(stream_of({"1;1000", "2", "0;40"}), 2s, 250, 20), nullptr);
}

TEST(SpokenStream, LongKeyframesAreCutOnTheStraightLine) {
  const auto spoken = spoken_stream(stream_of({"12:80;40@40", "0;3000@3040"}), 0ms, 250, 20);
  ASSERT_NE(spoken, nullptr);
  EXPECT_EQ(packets_of(spoken->negotiated),
            "{12:80;40@40}{12:53;1000@1040}{12:27;1000@2040}{0;1000@3040}");
  EXPECT_EQ(spoken->duration_ms, 3040U);
}

TEST(SpokenStream, PiecesOfAnOddTimeAddUp) {
  const auto spoken = spoken_stream(stream_of({"1;3601"}), 0ms, 250, 20);
  ASSERT_NE(spoken, nullptr);
  EXPECT_EQ(spoken->times.size(), 4U);
  EXPECT_EQ(std::accumulate(spoken->times.begin(), spoken->times.end(), KeyframeTime(0)), 3601ms);
}

TEST(SpokenStream, TheLastFaceIsHeldWhileTheVoiceGoesOn) {
  const auto spoken = spoken_stream(stream_of({"12;500"}), 2s, 250, 20);
  ASSERT_NE(spoken, nullptr);
  EXPECT_EQ(packets_of(spoken->negotiated), "{12;500}{12;750}{12;750}");
  EXPECT_EQ(packets_of(spoken->classic), "{12}{12}{12}");
}

}  // namespace
}  // namespace aucast::protocol

#include "protocol/engine_message.h"

#include <gtest/gtest.h>

#include <string>

namespace aucast::protocol {
namespace {

using Kind = EngineMessage::Kind;

TEST(EngineMessage, IsALineAndPackets) {
  const EngineMessage batch{Kind::Batch, "5e1c0a7b", 17, 680, 0, "{a@680 SHVo}{~12:31;40}"};
  EXPECT_EQ(encode(batch), "batch origin=5e1c0a7b seq=17 place=680\n{a@680 SHVo}{~12:31;40}");
  const EngineMessage since{Kind::Since, "5e1c0a7b", 17, 640, 15, "{12}"};
  EXPECT_EQ(encode(since), "since origin=5e1c0a7b seq=17 place=640 after=15\n{12}");
}

TEST(EngineMessage, ReadsWhatItWrites) {
  for (const EngineMessage& message :
       {EngineMessage{Kind::Batch, "a", 1, 0, 0, ""},
        EngineMessage{Kind::Batch, "a-2", 9007199254740991, 1, 0, "{0}"},
        EngineMessage{Kind::State, "A.b_c", 0, 40, 0, "{hello AUSP/2}{12}"},
        EngineMessage{Kind::Since, "a", 5, 7, 5, ""}}) {
    const auto read = parse_engine_message(encode(message));
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(*read, message);
  }
}

TEST(EngineMessage, LetsLaterVersionsSayMore) {
  const auto read = parse_engine_message("batch flag origin=a new=1 seq=2 place=3 seq=9\n{1}");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->seq, 2U);
}

TEST(EngineMessage, SaysWhatIsWrong) {
  const std::string long_line(kEngineLineBytesMax + 1, 'x');
  const struct {
    std::string bytes;
    const char* reason;
  } wrongs[] = {
      {"", "none of batch, state and since"},
      {"{12}", "none of batch, state and since"},
      {std::string("\0\xff\n", 3), "none of batch, state and since"},
      {"batch seq=1 place=0\n", "no origin="},
      {"batch origin= seq=1 place=0\n", "no ID"},
      {"batch origin=a\xff seq=1 place=0\n", "no ID"},
      {"batch origin=0123456789abcdefg seq=1 place=0\n", "no ID"},
      {"batch origin=a place=0\n", "no seq="},
      {"batch origin=a seq=-1 place=0\n", "seq= is no number"},
      {"batch origin=a seq=9007199254740992 place=0\n", "seq= is no number"},
      {"batch origin=a seq=1\n", "no place="},
      {"since origin=a seq=1 place=0\n", "no after="},
      {"since origin=a seq=1 place=0 after=2\n", "after= is greater than"},
      {"batch origin=a seq=1 place=0\n{12", "no whole packets"},
      {"batch origin=a seq=1 place=0\n12}", "no whole packets"},
      {"state origin=a seq=1 place=0\n{12}", "without a hello"},
      {long_line, "a short line"},
      {std::string(kEngineBytesMax + 1, 'x'), "at most 65536"},
  };
  for (const auto& wrong : wrongs) {
    const auto read = parse_engine_message(wrong.bytes);
    ASSERT_FALSE(read) << wrong.bytes.substr(0, 80);
    EXPECT_NE(read.error().message.find(wrong.reason), std::string::npos) << read.error().message;
  }
}

TEST(EngineJoin, ReadsWhatItWrites) {
  EXPECT_EQ(encode(EngineJoin{}), "join");
  EXPECT_EQ(encode(EngineJoin{"a", 7}), "join origin=a after=7");
  for (const EngineJoin& join :
       {EngineJoin{}, EngineJoin{"a", {}}, EngineJoin{"", 0}, EngineJoin{"a", 7}}) {
    const auto read = parse_engine_join(encode(join));
    ASSERT_TRUE(read);
    EXPECT_EQ(*read, join);
  }
  for (const char* wrong : {"", "jo", "join origin=", "join after=x", "{join}"}) {
    EXPECT_FALSE(parse_engine_join(wrong)) << wrong;
  }
}

TEST(EnginePlaces, CountFromWhereSomebodyBegan) {
  EXPECT_EQ(with_places_earlier("{a@700 SHVo}{t@720 SHVo}{~12:31;40@9000}{a@760 SHVo}", 680),
            "{a@20 SHVo}{t@40 SHVo}{~12:31;40@9000}{a@80 SHVo}");
}

TEST(EnginePlaces, LeaveOutVoiceFromBeforeAndKeepTheCaptionThatStands) {
  EXPECT_EQ(with_places_earlier("{a@679 SHVo}{a SHVo}{a@ SHVo}{a@x}{t@100 SHVo}{t@100}{0}", 680),
            "{t@0 SHVo}{t@0}{0}");
}

TEST(EnginePlaces, StandInNoOtherPacket) {
  for (const char* packets : {"", "{-2}", "{12@680}", "no packet at all", "{hello AUSP/2}{1}"}) {
    EXPECT_EQ(with_places_earlier(packets, 680), packets);
  }
}

TEST(EnginePackets, AreTakenOneByOne) {
  EXPECT_EQ(first_packet("{1}{2}"), "{1}");
  EXPECT_EQ(first_packet("{1"), "{1");
  EXPECT_EQ(first_packet(""), "");
}

}  // namespace
}  // namespace aucast::protocol

#include "protocol/codec.h"

#include <gtest/gtest.h>

#include "protocol/limits.h"

namespace aucast::protocol {
namespace {

Keyframe of(std::vector<AuTerm> terms) {
  Keyframe keyframe;
  keyframe.terms = std::move(terms);
  return keyframe;
}

AuTerm au(int number, Side side = Side::Both, int percent = 100) {
  return {static_cast<std::uint8_t>(number), side, static_cast<std::uint8_t>(percent)};
}

std::vector<AuTerm> plain(std::initializer_list<int> numbers) {
  std::vector<AuTerm> terms;
  for (const int number : numbers) terms.push_back(au(number));
  return terms;
}

TEST(EncodeClassic, HasTheByteCountsOfTable55) {
  const std::pair<std::vector<AuTerm>, std::size_t> rows[] = {
      {plain({1, 2, 5, 15, 16, 20, 26}), 19},
      {plain({1, 2, 4, 5, 15, 20, 26}), 18},
      {plain({2, 4, 9, 15, 17}), 13},
      {plain({2, 4, 7, 9, 10, 20, 26}), 18},
      {plain({1, 6, 12, 14}), 11},
      {plain({1, 4, 15, 23}), 11},
  };
  for (const auto& [terms, bytes] : rows) {
    EXPECT_EQ(encode_classic(of(terms), 20).size(), bytes) << encode_classic(of(terms), 20);
    EXPECT_EQ(encode(of(terms)).size(), bytes);
  }
  EXPECT_EQ(encode_classic(of(plain({1, 6, 12, 14})), 20), "{1,6,12,14}");
}

TEST(EncodeClassic, DropsSidesIntensitiesAndTiming) {
  Keyframe keyframe = of({au(14, Side::Right, 50), au(12, Side::Left), au(4, Side::Both, 30)});
  keyframe.time_ms = 40;
  keyframe.place_ms = 800;
  EXPECT_EQ(encode_classic(keyframe, 20), "{4,12,14}");
}

TEST(EncodeClassic, GoesByTheLargerSideAgainstTheMinimum) {
  const Keyframe keyframe = of({au(1, Side::Left, 10), au(1, Side::Right, 20),
                                au(2, Side::Both, 19), au(4, Side::Both, 20)});
  EXPECT_EQ(encode_classic(keyframe, 20), "{1,4}");
  EXPECT_EQ(encode_classic(keyframe, 0), "{1,2,4}");
  EXPECT_EQ(encode_classic(keyframe, 100), "{0}");
}

TEST(EncodeClassic, NeverNamesAnAbsentAuAndIsNeutralWhenNothingIsLeft) {
  EXPECT_EQ(encode_classic(of({au(12, Side::Both, 0)}), 0), "{0}");
  EXPECT_EQ(encode_classic(of({au(0)}), 20), "{0}");
}

TEST(EncodeKeyframe, IsAscendingJoinedAndOmitsHundred) {
  EXPECT_EQ(encode(of({au(14, Side::Left, 80), au(12, Side::Right, 80), au(1, Side::Both, 30)})),
            "{1:30,R12:80,L14:80}");
  EXPECT_EQ(encode(of({au(12, Side::Right, 80), au(12, Side::Left, 80)})), "{12:80}");
  EXPECT_EQ(encode(of({au(12, Side::Left, 80), au(12, Side::Right)})), "{L12:80,R12}");
  EXPECT_EQ(encode(of({au(12), au(12, Side::Both, 40)})), "{12:40}") << "the last wins";
  EXPECT_EQ(encode(of({au(12), au(12, Side::Left, 0)})), "{R12}");
  EXPECT_EQ(encode(of({au(0), au(6)})), "{6}");
  EXPECT_EQ(encode(of({au(6, Side::Both, 0)})), "{0}");
}

TEST(EncodeKeyframe, CarriesTiming) {
  Keyframe keyframe = of({au(1, Side::Both, 30), au(12, Side::Both, 80)});
  keyframe.time_ms = 40;
  EXPECT_EQ(encode(keyframe), "{1:30,12:80;40}");
  keyframe.place_ms = 73400;
  EXPECT_EQ(encode(keyframe), "{1:30,12:80;40@73400}");
}

TEST(EncodeKeyframe, KeepsZerosOfTheChangesOnlyForm) {
  Keyframe keyframe = of({au(12, Side::Both, 80), au(6, Side::Both, 0), au(4, Side::Left, 0)});
  keyframe.changes_only = true;
  keyframe.time_ms = 33;
  EXPECT_EQ(encode(keyframe), "{~L4:0,6:0,12:80;33}");
  keyframe.terms.clear();
  EXPECT_EQ(encode(keyframe), "{~;33}");
  keyframe.terms = {au(0)};
  keyframe.time_ms.reset();
  EXPECT_EQ(encode(keyframe), "{~}");
}

TEST(EncodeKeyframe, TheLongestOneFitsThePacketLimit) {
  Keyframe keyframe;
  for (int number = 1; number <= kAuNumberMax; ++number) {
    keyframe.terms.push_back(au(number, Side::Left, 98));
    keyframe.terms.push_back(au(number, Side::Right, 99));
  }
  keyframe.time_ms = kKeyframeTimeMsMax;
  keyframe.place_ms = kPlaceMsMax;
  EXPECT_LT(encode(keyframe).size(), kPacketBytesMax);
}

TEST(EncodeHello, NamesWhatIsNotTheDefault) {
  HelloAsked asked;
  EXPECT_EQ(encode(asked), "{hello v=2 window=1}");
  asked = {2, 64, "talk", "secret", true, 5000};
  EXPECT_EQ(encode(asked), "{hello v=2 window=64 stream=talk token=secret delta=1 from=5000}");
  HelloGranted granted;
  EXPECT_EQ(encode(granted), "{hello v=2 window=1 keyframe=250}");
  granted = {2, 64, true, "talk", true, 120000, 40};
  EXPECT_EQ(encode(granted),
            "{hello v=2 window=64 delta=1 stream=talk live=1 duration=120000 keyframe=40}");
}

TEST(EncodeHello, LeavesOutWhatCannotStandInAField) {
  HelloAsked asked;
  asked.stream = "my talk";
  asked.token = "a}b";
  EXPECT_EQ(encode(asked), "{hello v=2 window=1}");
  asked.token = "a b";
  EXPECT_EQ(encode(asked), "{hello v=2 window=1}");
  HelloGranted granted;
  granted.stream = "../x";
  EXPECT_EQ(encode(granted), "{hello v=2 window=1 keyframe=250}");
}

TEST(EncodeError, IsOneSafePacketWhateverTheText) {
  EXPECT_EQ(encode(ErrorReply{404, "there is no stream 'x' here"}),
            "{error 404 there is no stream 'x' here}");
  EXPECT_EQ(encode(ErrorReply{400, "a}{b\n\x1b"}), "{error 400 a)(b\\x0a\\x1b}");
  const std::string longest = encode(ErrorReply{400, std::string(5000, '\n')});
  EXPECT_LE(longest.size(), kHelloBytesMax);
  EXPECT_TRUE(longest.ends_with("...}"));
}

TEST(EncodeStreams, ListsLegalNamesWithinThePacketLimit) {
  EXPECT_EQ(encode(StreamsAsked{}), "{streams}");
  EXPECT_EQ(encode(StreamsAsked{"word", true}), "{streams token=word details=1}");
  EXPECT_EQ(encode(StreamList{}), "{streams}");
  EXPECT_EQ(encode(StreamList{{{"talk"}, {"bad name"}, {"a.b_c-1"}}}), "{streams talk a.b_c-1}");
  const StreamList many{std::vector<ListedStream>(100, {std::string(64, 'x')})};
  EXPECT_LE(encode(many).size(), kPacketBytesMax);
  EXPECT_GT(encode(many).size(), kPacketBytesMax - 66);
}

TEST(EncodeStreams, SaysWhatIsKnownOfEach) {
  const StreamList list{{{"talk", false, 60'000, "A talk"},
                         {"bad name", true},
                         {"hall", true},
                         {"later"},
                         {"turns", false}}};
  EXPECT_EQ(encode(list),
            "{streams stream=talk live=0 duration=60000 title=QSB0YWxr stream=hall live=1 "
            "stream=later stream=turns live=0}");
  EXPECT_EQ(encode(StreamList{{{"bad name", true}, {"later"}}}), "{streams later}")
      << "nothing is known of what is listed";
  EXPECT_EQ(encode(StreamList{{{"talk", std::nullopt, std::nullopt, "a\nb"}}}),
            "{streams stream=talk}")
      << "which is no title";
}

/// So many streams, each with a name of nine bytes and a title of 120.
StreamList titled(std::size_t count) {
  StreamList list;
  for (std::size_t i = 0; i < count; ++i) {
    list.streams.push_back({"stream" + std::to_string(100 + i), false, 1'000'000'000'000,
                            std::string(kTitleBytesMax, 't')});
  }
  return list;
}

std::size_t places_of(const std::string& text, std::string_view part) {
  std::size_t count = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; ++at) ++count;
  return count;
}

TEST(EncodeStreams, DetailsCostNoNames) {
  // Each takes 213 bytes with its title and 47 without, or ten as a name.
  const std::string all = encode(titled(19));
  EXPECT_EQ(places_of(all, " stream="), 19U);
  EXPECT_EQ(places_of(all, " title="), 19U);
  const std::string untitled = encode(titled(20));
  EXPECT_EQ(places_of(untitled, " stream="), 20U);
  EXPECT_EQ(places_of(untitled, " duration="), 20U);
  EXPECT_EQ(places_of(untitled, " title="), 0U);
  EXPECT_EQ(places_of(encode(titled(86)), " stream="), 86U);
  const std::string names = encode(titled(87));
  EXPECT_EQ(names.find('='), std::string::npos);
  EXPECT_EQ(places_of(names, " stream"), 87U);
  EXPECT_EQ(places_of(encode(titled(1000)), " stream"), (kPacketBytesMax - 9) / 10)
      << "the list ends early";
}

TEST(EncodeStreams, APacketMayBeFullToTheLastByte) {
  StreamList list;
  while (list.streams.size() < 42) list.streams.push_back({std::string(64, 'n'), true, 100'000});
  list.streams.push_back({"n", true, kPlaceMsMax});
  const std::size_t left = kPacketBytesMax - encode(list).size();
  ASSERT_LT(left, 63U) << "the last name takes them";
  list.streams.back().name.resize(1 + left, 'n');
  EXPECT_EQ(encode(list).size(), kPacketBytesMax);
  EXPECT_EQ(places_of(encode(list), " live=1"), 43U);
  list.streams.back().name += 'n';
  EXPECT_EQ(encode(list).find('='), std::string::npos);
}

TEST(EncodeCode, IsWhatTheThesisWrites) {
  EXPECT_EQ(encode(Code::Received), "1");
  EXPECT_EQ(encode(Code::Pause), "-1");
  EXPECT_EQ(encode(Code::Resume), "-3");
  EXPECT_EQ(encode(Code::Stop), "-4");
  EXPECT_EQ(encode(End{}), "{-2}");
}

TEST(StreamName, IsLettersDigitsAndThreeMarks) {
  EXPECT_TRUE(is_stream_name("a"));
  EXPECT_TRUE(is_stream_name("Talk_1.b-c"));
  EXPECT_TRUE(is_stream_name(std::string(64, 'x')));
  EXPECT_FALSE(is_stream_name(""));
  EXPECT_FALSE(is_stream_name(std::string(65, 'x')));
  EXPECT_FALSE(is_stream_name("a/b"));
  EXPECT_FALSE(is_stream_name("a b"));
  EXPECT_FALSE(is_stream_name("gr\xc3\xbc\xc3\x9f"));
}

}  // namespace
}  // namespace aucast::protocol

#include <gtest/gtest.h>

#include "protocol/codec.h"
#include "protocol/encoded_stream.h"
#include "protocol/limits.h"
#include "tests/support/seeded.h"
#include "tests/unit/protocol/packets.h"

namespace aucast::protocol {
namespace {

using test::Seeded;

Keyframe keyframe(std::string_view text) {
  Keyframe parsed;
  const auto error = parse_keyframe(text, TermSyntax::Wire, parsed);
  EXPECT_FALSE(error.has_value()) << text;
  return parsed;
}

/// Of `to` after `from`; AUs 91-98, which both have, make the full form the longer one.
std::string changes(std::string_view from, std::string_view to) {
  constexpr std::string_view kMore = "91,92,93,94,95,96,97,98,";
  KeyframeEncoder encoder(250, 0);
  static_cast<void>(encoder.next(keyframe(std::string(kMore).append(from))));
  return encoder.next(keyframe(std::string(kMore).append(to))).changes;
}

std::vector<std::string> changes_of(const std::vector<Keyframe>& keyframes) {
  KeyframeEncoder encoder(250, 0);
  std::vector<std::string> packets;
  for (const Keyframe& one : keyframes) packets.push_back(encoder.next(one).changes);
  return packets;
}

std::vector<std::string> encoded(const std::vector<std::string>& texts) {
  std::vector<Keyframe> keyframes;
  for (const std::string& text : texts) keyframes.push_back(keyframe(text));
  return changes_of(keyframes);
}

TEST(ChangesBetween, NamesWhatIsNewGoneAndOther) {
  EXPECT_EQ(changes("1,6", "1,12"), "{~6:0,12}");
  EXPECT_EQ(changes("1:30", "1:31"), "{~1:31}");
  EXPECT_EQ(changes("1,6", "0"), "{~1:0,6:0}");
  EXPECT_EQ(changes("0", "4"), "{~4}");
}

TEST(ChangesBetween, NamesNothingWhenNothingChanged) {
  EXPECT_EQ(changes("1,6", "6,1"), "{~}");
  EXPECT_EQ(changes("12", "L12,R12;40@80"), "{~;40@80}");
}

TEST(ChangesBetween, SpeaksOfOneSideWhereTheOtherStays) {
  EXPECT_EQ(changes("12", "L12:40,R12"), "{~L12:40}");
  EXPECT_EQ(changes("12", "R12"), "{~L12:0}");
  EXPECT_EQ(changes("46", "L46:50,R46:50"), "{~L46:50,R46:50}") << "no side would be the right one";
  EXPECT_EQ(changes("L46,R46", "0"), "{~L46:0,R46:0}");
}

TEST(ChangesBetween, NamesBothSidesInOneTermWhereTheyMeet) {
  EXPECT_EQ(changes("L12:40,R12", "12"), "{~12}");
  EXPECT_EQ(changes("L12:40", "0"), "{~12:0}");
}

TEST(ChangesBetween, KeepsTheTimingOfTheLaterOne) {
  EXPECT_EQ(changes("1;100@100", "2;33@133"), "{~1:0,2;33@133}");
  EXPECT_EQ(changes("1;100", "2"), "{~1:0,2}");
}

TEST(EncodeChanges, BeginsWithAFullOne) {
  EXPECT_EQ(encoded({"1,6,12;40"}), std::vector<std::string>{"{1,6,12;40}"});
  EXPECT_TRUE(encoded({}).empty());
}

TEST(EncodeChanges, TakesTheShorterForm) {
  EXPECT_EQ(encoded({"1,6,12:50", "1,6,12:60", "14", "14"}),
            (std::vector<std::string>{"{1,6,12:50}", "{~12:60}", "{14}", "{~}"}));
}

TEST(EncodeChanges, IsFullAtLeastEveryTenSeconds) {
  std::vector<std::string> texts(100, "1,2,4,5");
  const auto packets = encoded(texts);  // untimed: 250 ms each
  for (std::size_t i = 0; i < packets.size(); ++i) {
    EXPECT_EQ(packets[i], i % 40 == 0 ? "{1,2,4,5}" : "{~}") << i;
  }
  EXPECT_EQ(encoded({"1,2;3000", "1,2;10000", "1,2;10001", "1,2;1"}),
            (std::vector<std::string>{"{1,2;3000}", "{1,2;10000}", "{1,2;10001}", "{1,2;1}"}));
}

TEST(EncodeStream, HasNoChangesWhereAllIsPlain) {
  const auto granted = [](std::vector<std::string> texts) {
    std::vector<Keyframe> keyframes;
    for (const std::string& text : texts) keyframes.push_back(keyframe(text));
    return !encode_stream(keyframes, 250, 20).changes.empty();
  };
  EXPECT_FALSE(granted({"1,6", "0", "L1,R1", "1,6:0"}));
  for (const char* beyond : {"1:30", "L1", "1;40", "1:10"}) EXPECT_TRUE(granted({"1,6", beyond}));
}

TEST(EncodeStream, KnowsHowLongItTakesWithoutItsTimes) {
  const auto length = [](const char* text) {
    const std::vector<Keyframe> keyframes(3, keyframe(text));
    return classic_length(encode_stream(keyframes, 250, 20));
  };
  EXPECT_EQ(length("1;33"), Milliseconds(750));
  EXPECT_EQ(length("1"), std::nullopt) << "250 ms anyway";
}

TEST(EncodeStream, SumsTheTimes) {
  const std::vector<Keyframe> keyframes{keyframe("1:10"), keyframe("R2;40")};
  const EncodedStream stream = encode_stream(keyframes, 250, 20);
  EXPECT_EQ(stream.duration_ms, 290U);
  EXPECT_EQ(stream.classic, test::packets({"{0}", "{2}"}));
  EXPECT_EQ(stream.negotiated, test::packets({"{1:10}", "{R2;40}"}));
}

TEST(StreamEncoder, HoldsPacketsAndTimesOnly) {
  StreamEncoder encoder(250, 20);
  for (int i = 0; i < 1000; ++i) encoder.add(keyframe("1"));
  EXPECT_EQ(encoder.keyframes(), 1000U);
  EXPECT_LE(encoder.bytes(), 64'000U);
  const EncodedStream stream = encoder.finish();
  EXPECT_EQ(stream.classic[999], "{1}");
  EXPECT_EQ(stream.times[999], KeyframeTime(250));
  EXPECT_EQ(stream.duration_ms, 250'000U);
}

TEST(EncodeChanges, GivesBackEveryStateInOrder) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  for (int run = 0; run < 300; ++run) {
    std::vector<Keyframe> keyframes(static_cast<std::size_t>(seeded.integer(1, 60)));
    for (Keyframe& one : keyframes) {
      for (int count = seeded.integer(0, 6); count >= 0; --count) {
        one.terms.push_back({static_cast<std::uint8_t>(seeded.integer(0, 12)),
                             static_cast<Side>(seeded.integer(0, 2)),
                             static_cast<std::uint8_t>(seeded.integer(0, 100))});
      }
      if (seeded.chance(0.5)) one.time_ms = seeded.integer(0, 3000);
    }
    const auto packets = changes_of(keyframes);
    ASSERT_EQ(packets.size(), keyframes.size());
    AuFrame running;
    std::uint64_t since_full = 0;
    for (std::size_t i = 0; i < packets.size(); ++i) {
      const Keyframe read = keyframe(std::string_view(packets[i]).substr(1, packets[i].size() - 2));
      if (!read.changes_only) {
        running = {};
        since_full = 0;
      }
      apply_terms(running, read.terms);
      ASSERT_EQ(running, frame_from_terms(keyframes[i].terms)) << packets[i];
      EXPECT_EQ(read.time_ms, keyframes[i].time_ms);
      EXPECT_LE(packets[i].size(), encode(keyframes[i]).size());
      EXPECT_LE(since_full, static_cast<std::uint64_t>(kFullKeyframeEvery.count()));
      since_full += keyframes[i].time_ms.value_or(250);
    }
  }
}

}  // namespace
}  // namespace aucast::protocol

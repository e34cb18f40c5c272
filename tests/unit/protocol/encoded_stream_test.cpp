#include "protocol/encoded_stream.h"

#include <gtest/gtest.h>

#include <vector>

#include "protocol/limits.h"
#include "tests/support/seeded.h"
#include "tests/unit/protocol/packets.h"

namespace aucast::protocol {
namespace {

Keyframe smile(std::uint8_t percent, std::optional<std::uint32_t> ms = {}) {
  Keyframe keyframe;
  keyframe.terms = {{12, Side::Both, percent}};
  keyframe.time_ms = ms;
  return keyframe;
}

EncodedStream of_times(std::initializer_list<std::uint32_t> times) {
  StreamEncoder encoder(250, 20);
  std::uint8_t percent = 30;
  for (const std::uint32_t ms : times) encoder.add(smile(++percent, ms));
  return encoder.finish();
}

std::string entry(const EncodedStream& stream, std::uint64_t from_ms, bool loop = false) {
  const Entry found = entry_at(stream, from_ms, loop);
  return std::to_string(found.keyframe) + " at " + std::to_string(found.begin_ms);
}

TEST(EncodedStream, HasEachKeyframeInEveryForm) {
  StreamEncoder encoder(250, 20);
  Keyframe open = smile(40);
  open.terms.push_back({25, Side::Both, 70});
  encoder.add(open);
  open.terms.front().percent = 10;
  open.time_ms = 33;
  encoder.add(open);
  EXPECT_EQ(encoder.keyframes(), 2U);
  const EncodedStream stream = encoder.finish();
  EXPECT_EQ(stream.classic, test::packets({"{12,25}", "{25}"})) << "what is faint is left out";
  EXPECT_EQ(stream.negotiated, test::packets({"{12:40,25:70}", "{12:10,25:70;33}"}));
  EXPECT_EQ(stream.changes, test::packets({"{12:40,25:70}", "{~12:10;33}"}));
  EXPECT_EQ(stream.times, (std::vector<KeyframeTime>{KeyframeTime(250), KeyframeTime(33)}));
  EXPECT_EQ(stream.duration_ms, 283U);
  EXPECT_EQ(stream.extent, Extent::Whole);
  EXPECT_EQ(length_of(stream), Milliseconds(283));
}

TEST(EncodedStream, OfPlainNumbersHasNoChangesOnlyForm) {
  const std::vector<Keyframe> plain{smile(100), smile(100)};
  const EncodedStream stream = encode_stream(plain, 250, 20);
  EXPECT_EQ(stream.negotiated, test::packets({"{12}", "{12}"}));
  EXPECT_TRUE(stream.changes.empty());
}

TEST(EncodedStream, GivesBackTheKeyframesOfItsPackets) {
  const std::vector<Keyframe> keyframes{smile(40), smile(100, 0), smile(0, 3'600'000)};
  const EncodedStream stream = encode_stream(keyframes, 250, 20);
  ASSERT_EQ(stream.negotiated.size(), keyframes.size());
  for (std::size_t i = 0; i < keyframes.size(); ++i) {
    EXPECT_EQ(keyframe_of(stream.negotiated[i]).time_ms, keyframes[i].time_ms);
  }
  EXPECT_EQ(keyframe_of(stream.negotiated[0]), keyframes[0]);
}

TEST(EncodedStream, CountsTheMemoryThatItTakes) {
  StreamEncoder encoder(250, 20);
  EXPECT_EQ(encoder.bytes(), 0U);
  encoder.add(smile(40));
  // {12}, {12:40} twice, and four bytes for each of three ends and a time.
  EXPECT_EQ(encoder.bytes(), 4U + 7U + 7U + 4U * sizeof(std::uint32_t));
  EXPECT_EQ(held_bytes(encoder.finish()), 4U + 7U + 7U + 4U * sizeof(std::uint32_t));
}

TEST(EncodedStream, IsEnteredAtTheFirstKeyframeThatEndsLater) {
  const EncodedStream stream = of_times({100, 50, 200});
  EXPECT_EQ(entry(stream, 0), "0 at 0");
  EXPECT_EQ(entry(stream, 99), "0 at 0");
  EXPECT_EQ(entry(stream, 100), "1 at 100");
  EXPECT_EQ(entry(stream, 149), "1 at 100");
  EXPECT_EQ(entry(stream, 150), "2 at 150");
  EXPECT_EQ(entry(stream, 350), "3 at 350") << "behind its end";
  EXPECT_EQ(entry(stream, 1'000'000), "3 at 350");
  EXPECT_EQ(entry(EncodedStream{}, 0), "0 at 0");
}

TEST(EncodedStream, IsEnteredAtAKeyframeWithoutTimeWhereItStands) {
  const EncodedStream stream = of_times({100, 0, 0, 50});
  EXPECT_EQ(entry(stream, 100), "1 at 100");
  EXPECT_EQ(entry(stream, 101), "3 at 100");
}

TEST(EncodedStream, InALoopIsEnteredTurnAfterTurn) {
  const EncodedStream stream = of_times({100, 50, 200});
  EXPECT_EQ(entry(stream, 350, true), "0 at 0");
  EXPECT_EQ(entry(stream, 350 * 7 + 120, true), "1 at 100");
  EXPECT_EQ(entry(of_times({0, 0}), 5, true), "0 at 0") << "a turn that takes no time";
  EncodedStream growing = of_times({100, 50});
  growing.duration_ms = 350;
  EXPECT_EQ(entry(growing, 350 + 120, true), "1 at 100") << "a turn is as long as it will be";
  EXPECT_EQ(entry(growing, 200, true), "2 at 150") << "not there yet";
  growing.duration_ms.reset();
  EXPECT_EQ(entry(growing, 150 + 120, true), "1 at 100") << "a turn is as long as it is";
}

TEST(EncodedStream, WhateverIsEnteredEndsAfterThePlaceAndNothingBeforeItDoes) {
  test::Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  for (int round = 0; round < 200; ++round) {
    StreamEncoder encoder(250, 20);
    const int count = seeded.integer(0, 12);
    for (int i = 0; i < count; ++i) {
      encoder.add(smile(50, static_cast<std::uint32_t>(seeded.integer(0, 3) * 10)));
    }
    const EncodedStream stream = encoder.finish();
    const auto from = static_cast<std::uint64_t>(seeded.integer(0, 400));
    const Entry found = entry_at(stream, from, false);
    std::uint64_t begin = 0;
    for (std::size_t i = 0; i < found.keyframe; ++i) {
      begin += stream.times[i].count();
      EXPECT_LE(begin, from);
    }
    EXPECT_EQ(found.begin_ms, begin);
    if (found.keyframe == stream.times.size()) continue;
    const std::uint64_t end = begin + stream.times[found.keyframe].count();
    EXPECT_TRUE(end > from || (end == begin && begin == from));
  }
}

TEST(EncodedStream, TakesAClassicPlayerItsOwnTime) {
  EXPECT_EQ(classic_length(of_times({250, 250})), std::nullopt) << "the same";
  EXPECT_EQ(classic_length(of_times({40, 40, 40})), kDefaultKeyframeTime * 3);
  EncodedStream growing = of_times({40});
  growing.extent = Extent::Growing;
  EXPECT_EQ(classic_length(growing), std::nullopt) << "not known yet";
}

}  // namespace
}  // namespace aucast::protocol

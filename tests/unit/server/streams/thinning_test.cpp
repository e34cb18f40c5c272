#include "server/streams/thinning.h"

#include <gtest/gtest.h>

#include "protocol/codec.h"
#include "tests/support/seeded.h"

namespace aucast::server {
namespace {

using protocol::Keyframe;

/// Keyframe `number` of a stream that fills a link: 60 AUs, each percent from its number.
Keyframe full_of(int number, std::optional<std::uint32_t> time_ms) {
  Keyframe keyframe;
  for (int au = 1; au <= 60; ++au) {
    keyframe.terms.push_back({static_cast<std::uint8_t>(au), Side::Both,
                              static_cast<std::uint8_t>(10 + (number + au) % 80)});
  }
  keyframe.time_ms = time_ms;
  return keyframe;
}

std::uint64_t time_of(const std::vector<Keyframe>& keyframes, std::uint32_t untimed) {
  std::uint64_t sum = 0;
  for (const Keyframe& keyframe : keyframes) sum += keyframe.time_ms.value_or(untimed);
  return sum;
}

TEST(Thinning, LeavesWhatFitsAsItIs) {
  std::vector<Keyframe> stream;
  for (int i = 0; i < 100; ++i) stream.push_back(full_of(i, std::nullopt));
  EXPECT_EQ(thinned(stream, 250, 1000), stream);
}

TEST(Thinning, MergesIntoTheNewestWhichTakesTheTimeOfAll) {
  std::vector<Keyframe> stream;
  for (int i = 0; i < 1000; ++i) stream.push_back(full_of(i, 40));
  const auto kept = thinned(stream, 250, 32);
  ASSERT_LT(kept.size(), 450U);
  ASSERT_GT(kept.size(), 350U) << "no more is left out than needed";
  EXPECT_EQ(time_of(kept, 250), 40'000U);
  EXPECT_EQ(kept.back().terms, stream.back().terms);
  std::uint64_t at = 0;
  for (const Keyframe& keyframe : kept) {
    at += *keyframe.time_ms;
    ASSERT_EQ(at % 40, 0U);
    EXPECT_EQ(keyframe.terms, stream[at / 40 - 1].terms) << "the face is right when it gets there";
  }
}

/// Whatever the stream, up to any place it needs no more than its time's bits and a second's
/// beside.
TEST(Thinning, KeepsToTheBitrate) {
  test::Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  for (int run = 0; run < 100; ++run) {
    const auto kbits = static_cast<std::uint32_t>(seeded.integer(4, 200));
    std::vector<Keyframe> stream;
    const int count = seeded.integer(1, 400);
    for (int i = 0; i < count; ++i) {
      Keyframe keyframe = full_of(i, std::nullopt);
      keyframe.terms.resize(static_cast<std::size_t>(seeded.integer(1, 60)));
      if (seeded.chance(0.8)) {
        keyframe.time_ms = static_cast<std::uint32_t>(seeded.integer(0, 300));
      }
      stream.push_back(std::move(keyframe));
    }
    const auto kept = thinned(stream, 250, kbits);
    EXPECT_EQ(time_of(kept, 250), time_of(stream, 250));
    double bits = 0;
    double time_ms = 0;
    // The last one is sent in any case.
    for (std::size_t i = 0; i + 1 < kept.size(); ++i) {
      time_ms += kept[i].time_ms.value_or(250);
      bits += static_cast<double>((encode(kept[i]).size() + kHeaderBytes) * 8);
      EXPECT_LE(bits, kbits * (time_ms + 1000) + 1);
    }
  }
}

}  // namespace
}  // namespace aucast::server

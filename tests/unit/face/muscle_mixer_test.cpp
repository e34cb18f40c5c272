#include "client/face/muscle_mixer.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "tests/support/allocations.h"
#include "tests/support/seeded.h"
#include "tests/unit/face/small_face.h"

namespace aucast::face {
namespace {

/// Muscles named left_*, right_* or neither, without geometry: the mixer looks at channels only.
Face face_with(const std::vector<std::pair<std::string, Side>>& channels) {
  Face face;
  for (const auto& [name, side] : channels) face.channels.push_back({name, side, 2});
  return face;
}

void record(Face& face, int number, std::vector<float> activation) {
  face.recordings[number] = {number, std::move(activation), ""};
}

AuFrame frame_of(std::initializer_list<AuTerm> terms) {
  return frame_from_terms(std::vector<AuTerm>(terms));
}

std::vector<float> mixed(const Face& face, const AuFrame& frame, Mixer mixer) {
  std::vector<float> activations(face.channels.size(), -1.0F);
  mix(face, frame, mixer, activations);
  return activations;
}

/// Tables 5.1 and 5.2 of the thesis: AUs a, b and c as 1, 2 and 3.
Face table_face() {
  Face face = face_with({{"left_zygomatic_major", Side::Left},
                         {"left_angular_depressor", Side::Left},
                         {"left_frontalis_inner", Side::Left}});
  record(face, 1, {1.2F, 0.8F, 0.0F});
  record(face, 2, {0.0F, 0.2F, 0.0F});
  record(face, 3, {0.6F, 1.4F, 0.9F});
  return face;
}

const AuFrame kAllThree = frame_of({{1}, {2}, {3}});

void expect_near(const std::vector<float>& actual, const std::vector<float>& expected) {
  ASSERT_EQ(actual.size(), expected.size());
  for (std::size_t i = 0; i < actual.size(); ++i) {
    EXPECT_NEAR(actual[i], expected[i], 1e-6F) << "channel " << i;
  }
}

TEST(Mixer, AverageIsTable51) {
  expect_near(mixed(table_face(), kAllThree, Mixer::Average), {0.9F, 0.8F, 0.9F});
}

TEST(Mixer, MaximumIsTable52) {
  expect_near(mixed(table_face(), kAllThree, Mixer::Maximum), {1.2F, 1.4F, 0.9F});
}

TEST(Mixer, IntensityScalesTheRecording) {
  const AuFrame half = frame_of({{1, Side::Both, 50}});
  expect_near(mixed(table_face(), half, Mixer::Maximum), {0.6F, 0.4F, 0.0F});
  expect_near(mixed(table_face(), half, Mixer::Average), {0.6F, 0.4F, 0.0F});
}

TEST(Mixer, AverageWeighsByIntensityAndKeepsTheLargest) {
  const AuFrame frame = frame_of({{1, Side::Both, 80}, {2, Side::Both, 20}, {3, Side::Both, 40}});
  // sum(i a) / sum(i) x max(i); AU2 does not use the first muscle.
  const float first = (0.8F * 1.2F + 0.4F * 0.6F) / 1.2F * 0.8F;
  const float second = (0.8F * 0.8F + 0.2F * 0.2F + 0.4F * 1.4F) / 1.4F * 0.8F;
  const float third = 0.4F * 0.9F;
  expect_near(mixed(table_face(), frame, Mixer::Average), {first, second, third});
}

TEST(Mixer, SidesGoToTheirOwnMusclesAndTheLargerToCentralOnes) {
  Face face = face_with({{"a", Side::Left}, {"b", Side::Right}, {"c", Side::Both}});
  record(face, 12, {1.0F, 1.0F, 1.0F});
  const AuFrame frame = frame_of({{12, Side::Left, 30}, {12, Side::Right, 70}});
  for (const Mixer mixer : {Mixer::Maximum, Mixer::Average}) {
    expect_near(mixed(face, frame, mixer), {0.3F, 0.7F, 0.7F});
  }
}

TEST(Mixer, AWinkWithoutSideIsTheRightEyes) {
  Face face = face_with({{"left_lid_close", Side::Left}, {"right_lid_close", Side::Right}});
  record(face, 46, {1.0F, 1.0F});
  record(face, 45, {1.0F, 1.0F});
  expect_near(mixed(face, frame_of({{46}}), Mixer::Maximum), {0.0F, 1.0F});
  expect_near(mixed(face, frame_of({{46, Side::Left, 100}}), Mixer::Maximum), {1.0F, 0.0F});
  expect_near(mixed(face, frame_of({{46, Side::Right, 60}}), Mixer::Maximum), {0.0F, 0.6F});
  expect_near(mixed(face, frame_of({{45}}), Mixer::Maximum), {1.0F, 1.0F});
}

TEST(NotShown, NamesWhatTheFaceHasNoRecordingOf) {
  Face face = face_with({{"left_lid_close", Side::Left}});
  record(face, 46, {1.0F});
  EXPECT_EQ(not_shown(face, frame_of({{46}})), "");
  EXPECT_EQ(not_shown(face, frame_of({{46}, {50}, {84, Side::Left, 10}, {99}})),
            "50 Speech, 84 Head Shake Back and Forth, 99");
}

TEST(Mixer, TheJawGoesToOneSide) {
  Face face = face_with({{"left_jaw_sideways", Side::Left}, {"right_jaw_sideways", Side::Right}});
  record(face, 30, {1.0F, 1.0F});
  expect_near(mixed(face, frame_of({{30}}), Mixer::Maximum), {0.0F, 1.0F});
  expect_near(mixed(face, frame_of({{30, Side::Left, 100}}), Mixer::Average), {1.0F, 0.0F});
  expect_near(
      mixed(face, frame_of({{30, Side::Left, 100}, {30, Side::Right, 100}}), Mixer::Maximum),
      {1.0F, 1.0F});
}

TEST(Mixer, LidsCloseAsFarAsTheLargestDemandUnderBothMixers) {
  const Face face = test::small_face();
  const AuFrame frame = frame_of({{6}, {43}});
  for (const Mixer mixer : {Mixer::Maximum, Mixer::Average}) {
    const auto activations = mixed(face, frame, mixer);
    EXPECT_FLOAT_EQ(activations[*face.channel_index("left_lid_close")], 1.0F);
    EXPECT_FLOAT_EQ(activations[*face.channel_index("right_lid_close")], 1.0F);
  }
}

TEST(Mixer, AnAuWithoutRecordingAndNeutralDoNothing) {
  expect_near(mixed(table_face(), frame_of({{77}, {0}}), Mixer::Average), {0, 0, 0});
  expect_near(mixed(table_face(), AuFrame{}, Mixer::Maximum), {0, 0, 0});
}

TEST(Mixer, StaysBetweenSmallestAndLargestDemand) {
  aucast::test::Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  for (int run = 0; run < 500; ++run) {
    Face face = face_with({{"a", Side::Left}});
    AuFrame frame;
    float largest = 0;
    for (int number = 1; number <= 6; ++number) {
      const float activation = seeded.chance(0.3) ? 0.0F : static_cast<float>(seeded.real(0.01, 2));
      const float intensity = seeded.chance(0.3) ? 0.0F : static_cast<float>(seeded.real(0.01, 1));
      record(face, number, {activation});
      frame.left[static_cast<std::size_t>(number)] = intensity;
      largest = std::max(largest, intensity * activation);
    }
    const float maximum = mixed(face, frame, Mixer::Maximum)[0];
    EXPECT_FLOAT_EQ(maximum, largest);
    const float average = mixed(face, frame, Mixer::Average)[0];
    EXPECT_GE(average, 0.0F);
    EXPECT_LE(average, 2.0F);
    EXPECT_EQ(average == 0, maximum == 0);
  }
}

/// Some AUs of the face at some intensities, other ones on each side.
AuFrame some_aus(const Face& face, aucast::test::Seeded& seeded) {
  AuFrame frame;
  for (const auto& [number, recording] : face.recordings) {
    const auto at = static_cast<std::size_t>(number);
    if (seeded.chance(0.5)) frame.left[at] = static_cast<float>(seeded.real(0, 1));
    if (seeded.chance(0.5)) frame.right[at] = static_cast<float>(seeded.real(0, 1));
  }
  return frame;
}

TEST(Mixer, ExchangedSidesMoveTheMusclesOfTheOtherSide) {
  aucast::test::Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  for (int run = 0; run < 100; ++run) {
    Face face =
        face_with({{"left_a", Side::Left}, {"right_a", Side::Right}, {"middle", Side::Both}});
    for (int number = 1; number <= 6; ++number) {
      const auto pair = static_cast<float>(seeded.real(0, 2));
      record(face, number, {pair, pair, static_cast<float>(seeded.real(0, 2))});
    }
    const AuFrame frame = some_aus(face, seeded);
    AuFrame exchanged = frame;
    std::swap(exchanged.left, exchanged.right);
    for (const Mixer mixer : {Mixer::Maximum, Mixer::Average}) {
      const auto here = mixed(face, frame, mixer);
      const auto there = mixed(face, exchanged, mixer);
      EXPECT_EQ(there, (std::vector<float>{here[1], here[0], here[2]}));
    }
  }
}

TEST(Mixer, AtMaximumOneMoreAuTakesNothingAway) {
  const Face face = test::small_face();
  aucast::test::Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  for (int run = 0; run < 100; ++run) {
    const AuFrame frame = some_aus(face, seeded);
    const auto before = mixed(face, frame, Mixer::Maximum);
    for (const auto& [number, recording] : face.recordings) {
      AuFrame more = frame;
      more.left[static_cast<std::size_t>(number)] = 1;
      const auto after = mixed(face, more, Mixer::Maximum);
      for (std::size_t i = 0; i < before.size(); ++i) ASSERT_GE(after[i], before[i]) << number;
    }
  }
}

TEST(Mixer, AllocatesNothing) {
  const Face face = test::small_face();
  aucast::test::Seeded seeded;
  const AuFrame frame = some_aus(face, seeded);
  std::vector<float> activations(face.channels.size());
  const std::size_t before = aucast::test::allocations();
  mix(face, frame, Mixer::Maximum, activations);
  mix(face, frame, Mixer::Average, activations);
  EXPECT_EQ(aucast::test::allocations(), before);
}

}  // namespace
}  // namespace aucast::face

#include "client/pipeline/face_pipeline.h"

#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/allocations.h"
#include "tests/support/seeded.h"

namespace aucast::pipeline {
namespace {

using aucast::test::Seeded;
using Activations = std::vector<float>;

/// A face of three channels: left and right cheek, and a jaw that AU 26 opens.
face::Face small_face() {
  face::Face face;
  face.name = "small";
  face.channels = {{"left_cheek", Side::Left, 2}, {"right_cheek", Side::Right, 2}, {"jaw"}};
  face.channels[2].activation_max = 4;
  face.recordings[6] = {6, {0.5F, 0.5F, 0}, ""};
  face.recordings[12] = {12, {1.5F, 1.5F, 0}, ""};
  face.recordings[26] = {26, {0, 0, 3}, ""};
  return face;
}

/// AU 12 makes AU 26 impossible (no rule of FACS: one that is easy to see).
face::RuleSet closing_rules() {
  face::Rule rule;
  rule.kind = face::RuleKind::Dominance;
  rule.sources = {12};
  rule.targets = {26};
  face::RuleSet rules;
  rules.name = "closing";
  rules.rules = {rule};
  return rules;
}

AuFrame aus(std::vector<AuTerm> terms) {
  return frame_from_terms(terms);
}

AuMapping mapping_of(const face::Face& face, face::RuleSet rules = {},
                     face::Mixer mixer = face::Mixer::Maximum) {
  return {face, face.recordings, std::move(rules), mixer};
}

FaceState state_at(const FacePipeline& pipeline, double mu) {
  FaceState state = pipeline.neutral();
  pipeline.at(mu, state);
  return state;
}

Activations at(const FacePipeline& pipeline, double mu) {
  return state_at(pipeline, mu).activations;
}

constexpr auto kLinear = playback::Interpolation::Linear;
constexpr auto kCosine = playback::Interpolation::Cosine;

TEST(FacePipeline, IsNeutralBeforeTheFirstKeyframe) {
  const face::Face face = small_face();
  const AuMapping mapping = mapping_of(face);
  FacePipeline pipeline(mapping, kLinear);
  for (const double mu : {0.0, 0.5, 1.0}) EXPECT_EQ(at(pipeline, mu), (Activations{0, 0, 0}));
  EXPECT_EQ(pipeline.received(), AuFrame{});
}

TEST(FacePipeline, ReachesTheMixOfTheBlendedSet) {
  const face::Face face = small_face();
  const AuMapping mapping = mapping_of(face, closing_rules());
  FacePipeline pipeline(mapping, kLinear);
  pipeline.begin_keyframe(aus({{12}, {26}}), pipeline.neutral());
  EXPECT_EQ(at(pipeline, 0), (Activations{0, 0, 0}));
  EXPECT_EQ(at(pipeline, 0.5), (Activations{0.75F, 0.75F, 0}));
  EXPECT_EQ(at(pipeline, 1), (Activations{1.5F, 1.5F, 0})) << "the rules act before the mixer";
  EXPECT_EQ(pipeline.received(), aus({{12}, {26}}));
}

TEST(FacePipeline, GoesWithoutRulesByTheMixerAlone) {
  const face::Face face = small_face();
  const AuMapping mapping = mapping_of(face);
  FacePipeline pipeline(mapping, kLinear);
  pipeline.begin_keyframe(aus({{12, Side::Left, 50}, {26}}), pipeline.neutral());
  EXPECT_EQ(at(pipeline, 1), (Activations{0.75F, 0, 3}));
}

TEST(FacePipeline, ChoosesTheMixer) {
  const face::Face face = small_face();
  const AuMapping largest = mapping_of(face, {}, face::Mixer::Maximum);
  const AuMapping mean = mapping_of(face, {}, face::Mixer::Average);
  FacePipeline maximum(largest, kLinear);
  FacePipeline average(mean, kLinear);
  maximum.begin_keyframe(aus({{6}, {12}}), maximum.neutral());
  average.begin_keyframe(aus({{6}, {12}}), average.neutral());
  EXPECT_EQ(at(maximum, 1), (Activations{1.5F, 1.5F, 0}));
  EXPECT_EQ(at(average, 1), (Activations{1, 1, 0}));
}

TEST(FacePipeline, GoesFromTheFaceThatIsHandedInToTheEndFrame) {
  const face::Face face = small_face();
  const AuMapping mapping = mapping_of(face);
  FacePipeline pipeline(mapping, kLinear);
  pipeline.begin_keyframe(aus({{12, Side::Both, 37}}), pipeline.neutral());
  const FaceState end = state_at(pipeline, 1);
  pipeline.begin_keyframe(aus({{26}}), end);
  EXPECT_EQ(at(pipeline, 0), end.activations) << "bit for bit";
  EXPECT_EQ(at(pipeline, 1), (Activations{0, 0, 3}));
  const FaceState on_the_way = state_at(pipeline, 0.3);
  pipeline.begin_keyframe(aus({{0}}), on_the_way);
  EXPECT_EQ(at(pipeline, 0), on_the_way.activations);
  EXPECT_EQ(at(pipeline, 1), (Activations{0, 0, 0}));
}

TEST(FacePipeline, SaysWhichAusTheFaceShowsOnTheWay) {
  const face::Face face = small_face();
  const AuMapping mapping = mapping_of(face, closing_rules());
  FacePipeline pipeline(mapping, kLinear);
  pipeline.begin_keyframe(aus({{26}}), pipeline.neutral());
  pipeline.begin_keyframe(aus({{12}, {26}}), state_at(pipeline, 1));
  EXPECT_EQ(state_at(pipeline, 0).aus, aus({{26}}));
  EXPECT_EQ(state_at(pipeline, 0.25).aus, aus({{12, Side::Both, 25}, {26, Side::Both, 75}}));
  EXPECT_EQ(state_at(pipeline, 1).aus, aus({{12}}));
}

TEST(FacePipeline, SaysWhichRulesFired) {
  const face::Face face = small_face();
  const AuMapping mapping = mapping_of(face, closing_rules());
  FacePipeline pipeline(mapping, kLinear);
  pipeline.begin_keyframe(aus({{12}, {26}}), pipeline.neutral());
  const auto explained = face::explain(pipeline.fired());
  ASSERT_EQ(explained.size(), 1U);
  EXPECT_EQ(explained[0].before, (std::vector<face::AuShare>{{12, 100}, {26, 100}}));
  EXPECT_EQ(explained[0].after, (std::vector<face::AuShare>{{26, 0}}));
  pipeline.begin_keyframe(aus({{26}}), pipeline.neutral());
  EXPECT_TRUE(pipeline.fired().empty());
}

TEST(FacePipeline, AnotherMappingCountsFromRemakeOn) {
  const face::Face face = small_face();
  AuMapping mapping = mapping_of(face, closing_rules());
  FacePipeline pipeline(mapping, kLinear);
  pipeline.begin_keyframe(aus({{12}, {26}}), pipeline.neutral());
  mapping.rules = {};
  EXPECT_EQ(at(pipeline, 1)[2], 0);
  pipeline.remake();
  EXPECT_EQ(at(pipeline, 1)[2], 3);
  mapping.recordings[26].activation[2] = 1;
  pipeline.remake();
  EXPECT_EQ(at(pipeline, 1)[2], 1);
}

TEST(FacePipeline, AllocatesNothing) {
  const face::Face face = small_face();
  const AuMapping mapping = mapping_of(face, closing_rules());
  FacePipeline pipeline(mapping, kLinear);
  FaceState state = pipeline.neutral();
  const std::array<AuFrame, 2> keyframes = {aus({{12}, {26}}), aus({{6}})};
  const std::size_t before = test::allocations();
  for (int i = 0; i < 10; ++i) {
    pipeline.begin_keyframe(keyframes[static_cast<std::size_t>(i % 2)], state);
    pipeline.at(0.5, state);
  }
  EXPECT_EQ(test::allocations(), before);
  EXPECT_GT(state.activations[0], 0);
}

TEST(FacePipeline, InterpolatesAsChosen) {
  const face::Face face = small_face();
  const AuMapping mapping = mapping_of(face);
  FacePipeline pipeline(mapping, kCosine);
  pipeline.begin_keyframe(aus({{26}}), pipeline.neutral());
  EXPECT_FLOAT_EQ(at(pipeline, 1.0 / 3)[2], 0.75F);
  pipeline.set_interpolation(kLinear);
  EXPECT_FLOAT_EQ(at(pipeline, 1.0 / 3)[2], 1);
}

TEST(FacePipeline, TheSameKeyframeTwiceHoldsStill) {
  const face::Face face = small_face();
  const AuMapping mapping = mapping_of(face);
  FacePipeline pipeline(mapping, kLinear);
  pipeline.begin_keyframe(aus({{12, Side::Both, 37}}), pipeline.neutral());
  const FaceState end = state_at(pipeline, 1);
  pipeline.begin_keyframe(aus({{12, Side::Both, 37}}), end);
  for (int k = 1; k <= 50; ++k) EXPECT_EQ(at(pipeline, k / 50.0), end.activations);
}

// Whatever comes: inside the channels' ranges, no jump from one position to the next.
TEST(FacePipeline, IsContinuousAndBounded) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  const face::Face face = small_face();
  const AuMapping mapping = mapping_of(face, closing_rules());
  FacePipeline pipeline(mapping, kLinear);
  constexpr std::array<std::uint8_t, 4> kNumbers{6, 12, 26, 99};
  FaceState now = pipeline.neutral();
  Activations before = now.activations;
  for (int keyframe = 0; keyframe < 200; ++keyframe) {
    std::vector<AuTerm> terms;
    for (const std::uint8_t number : kNumbers) {
      if (seeded.chance(0.5)) continue;
      terms.push_back({number, static_cast<Side>(seeded.integer(0, 2)),
                       static_cast<std::uint8_t>(seeded.integer(0, 100))});
    }
    const auto kind =
        seeded.chance(0.5) ? playback::Interpolation::Linear : playback::Interpolation::Cosine;
    pipeline.set_interpolation(kind);
    pipeline.begin_keyframe(aus(terms), now);
    const int last = seeded.chance(0.8) ? 50 : seeded.integer(0, 50);
    for (int k = 0; k <= last; ++k) {
      pipeline.at(k / 50.0, now);
      for (std::size_t i = 0; i < before.size(); ++i) {
        const float value = now.activations[i];
        ASSERT_GE(value, 0);
        ASSERT_LE(value, face.channels[i].activation_max);
        ASSERT_LE(std::abs(value - before[i]), face.channels[i].activation_max / 25);
      }
      before = now.activations;
    }
  }
}

}  // namespace
}  // namespace aucast::pipeline

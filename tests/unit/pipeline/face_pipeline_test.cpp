#include "client/pipeline/face_pipeline.h"

#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

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

TEST(FacePipeline, IsNeutralBeforeTheFirstKeyframe) {
  const face::Face face = small_face();
  const face::RuleSet rules;
  FacePipeline pipeline(face, rules, {});
  for (const double mu : {0.0, 0.5, 1.0}) EXPECT_EQ(pipeline.at(mu), (Activations{0, 0, 0}));
  EXPECT_EQ(pipeline.received(), AuFrame{});
}

TEST(FacePipeline, ReachesTheMixOfTheBlendedSet) {
  const face::Face face = small_face();
  const face::RuleSet rules = closing_rules();
  FacePipeline pipeline(face, rules, {});
  pipeline.begin_keyframe(aus({{12}, {26}}));
  EXPECT_EQ(pipeline.at(0), (Activations{0, 0, 0}));
  EXPECT_EQ(pipeline.at(0.5), (Activations{0.75F, 0.75F, 0}));
  EXPECT_EQ(pipeline.at(1), (Activations{1.5F, 1.5F, 0})) << "the rules act before the mixer";
  EXPECT_EQ(pipeline.received(), aus({{12}, {26}}));
  EXPECT_EQ(pipeline.blended(), aus({{12}}));
}

TEST(FacePipeline, GoesWithoutRulesByTheMixerAlone) {
  const face::Face face = small_face();
  const face::RuleSet rules;
  FacePipeline pipeline(face, rules, {});
  pipeline.begin_keyframe(aus({{12, Side::Left, 50}, {26}}));
  EXPECT_EQ(pipeline.at(1), (Activations{0.75F, 0, 3}));
}

TEST(FacePipeline, ChoosesTheMixer) {
  const face::Face face = small_face();
  const face::RuleSet rules;
  FacePipeline maximum(face, rules, {.mixer = face::Mixer::Maximum});
  FacePipeline average(face, rules, {.mixer = face::Mixer::Average});
  maximum.begin_keyframe(aus({{6}, {12}}));
  average.begin_keyframe(aus({{6}, {12}}));
  EXPECT_EQ(maximum.at(1), (Activations{1.5F, 1.5F, 0}));
  EXPECT_EQ(average.at(1), (Activations{1, 1, 0}));
}

TEST(FacePipeline, TheEndFrameBecomesTheStartFrame) {
  const face::Face face = small_face();
  const face::RuleSet rules;
  FacePipeline pipeline(face, rules, {});
  pipeline.begin_keyframe(aus({{12, Side::Both, 37}}));
  const Activations end = pipeline.at(1);
  pipeline.begin_keyframe(aus({{26}}));
  EXPECT_EQ(pipeline.at(0), end) << "bit for bit";
  EXPECT_EQ(pipeline.at(1), (Activations{0, 0, 3}));
}

TEST(FacePipeline, StartsFromTheFaceLastShown) {
  const face::Face face = small_face();
  const face::RuleSet rules;
  FacePipeline pipeline(face, rules, {});
  pipeline.begin_keyframe(aus({{12}}));
  const Activations shown = pipeline.at(0.3);
  pipeline.begin_keyframe(aus({{26}}));
  EXPECT_EQ(pipeline.at(0), shown);
  pipeline.begin_keyframe(aus({{0}}));
  EXPECT_EQ(pipeline.at(0), shown);
  EXPECT_EQ(pipeline.at(1), (Activations{0, 0, 0}));
}

TEST(FacePipeline, InterpolatesAsChosen) {
  const face::Face face = small_face();
  const face::RuleSet rules;
  FacePipeline pipeline(face, rules, {.interpolation = playback::Interpolation::Cosine});
  pipeline.begin_keyframe(aus({{26}}));
  EXPECT_FLOAT_EQ(pipeline.at(1.0 / 3)[2], 0.75F);
  pipeline.set_options({.interpolation = playback::Interpolation::Linear});
  EXPECT_FLOAT_EQ(pipeline.at(1.0 / 3)[2], 1);
}

TEST(FacePipeline, TheSameKeyframeTwiceHoldsStill) {
  const face::Face face = small_face();
  const face::RuleSet rules;
  FacePipeline pipeline(face, rules, {});
  pipeline.begin_keyframe(aus({{12, Side::Both, 37}}));
  const Activations end = pipeline.at(1);
  pipeline.begin_keyframe(aus({{12, Side::Both, 37}}));
  for (int k = 1; k <= 50; ++k) EXPECT_EQ(pipeline.at(k / 50.0), end);
}

// Whatever comes: inside the channels' ranges, no jump from one position to the next, one buffer.
TEST(FacePipeline, IsContinuousAndBounded) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  const face::Face face = small_face();
  const face::RuleSet rules = closing_rules();
  FacePipeline pipeline(face, rules, {});
  constexpr std::array<std::uint8_t, 4> kNumbers{6, 12, 26, 99};
  const float* const buffer = pipeline.at(0).data();
  Activations before = pipeline.at(0);
  for (int keyframe = 0; keyframe < 200; ++keyframe) {
    std::vector<AuTerm> terms;
    for (const std::uint8_t number : kNumbers) {
      if (seeded.chance(0.5)) continue;
      terms.push_back({number, static_cast<Side>(seeded.integer(0, 2)),
                       static_cast<std::uint8_t>(seeded.integer(0, 100))});
    }
    const auto kind =
        seeded.chance(0.5) ? playback::Interpolation::Linear : playback::Interpolation::Cosine;
    pipeline.set_options({.interpolation = kind});
    pipeline.begin_keyframe(aus(terms));
    const int last = seeded.chance(0.8) ? 50 : seeded.integer(0, 50);
    for (int k = 0; k <= last; ++k) {
      const Activations& now = pipeline.at(k / 50.0);
      ASSERT_EQ(now.data(), buffer);
      for (std::size_t i = 0; i < now.size(); ++i) {
        ASSERT_GE(now[i], 0);
        ASSERT_LE(now[i], face.channels[i].activation_max);
        ASSERT_LE(std::abs(now[i] - before[i]), face.channels[i].activation_max / 25);
      }
      before = now;
    }
  }
}

}  // namespace
}  // namespace aucast::pipeline

#include "client/pipeline/expression_muscles.h"

#include <vector>

#include <gtest/gtest.h>

namespace aucast::pipeline {
namespace {

TEST(ApplyMuscles, TakesTheLargerAndCutsToTheRange) {
  face::Face face;
  face.name = "f";
  face.channels = {{"left_pull", Side::Left, 2, false}, {"right_pull", Side::Right, 2, false}};
  Expression expression;
  expression.name = "e";
  expression.muscles = {{"pull", {}, 3.0F, 0.5F}};
  std::vector<float> activations{0, 1};
  ASSERT_TRUE(apply_muscles(face, expression, activations).has_value());
  EXPECT_EQ(activations, (std::vector<float>{2, 1}));
  expression.muscles[0].name = "push";
  const auto refused = apply_muscles(face, expression, activations);
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().kind, ErrorKind::BadData);
  EXPECT_NE(refused.error().message.find("no muscle 'push'"), std::string::npos);
}

TEST(ApplyMuscles, FindsTheSpellingsOfAClassicFolderBySide) {
  face::Face face;
  // Waters calls x < 0 left: the subject's right.
  face.channels = {{"Left_Zygomatic_Major", Side::Right, 4, false},
                   {"Right_Zygomatic_Major", Side::Left, 4, false}};
  Expression expression;
  expression.muscles = {{"zygomaticus_major", {"Zygomatic_Major"}, 1.0F, 1.1F}};
  std::vector<float> activations{0, 0};
  ASSERT_TRUE(apply_muscles(face, expression, activations).has_value());
  EXPECT_EQ(activations, (std::vector<float>{1.1F, 1.0F}));
}

}  // namespace
}  // namespace aucast::pipeline

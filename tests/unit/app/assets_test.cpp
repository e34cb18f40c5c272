#include "client/app/assets.h"

#include <gtest/gtest.h>

#include "protocol/codec.h"
#include "tests/support/process.h"

namespace aucast::app {
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

TEST(ShippedAssets, LoadAndNameTheirExpressions) {
  FaceOptions options;
  options.data = test::program("data");
  const auto assets = load_assets(options);
  ASSERT_TRUE(assets.has_value()) << assets.error().message;
  EXPECT_EQ(protocol::format_au_set(find_expression(**assets, "thesis-happiness")->aus),
            "1,6,12,14");
  EXPECT_EQ(describe(**assets, find_expression(**assets, "thesis-fear")->aus), "Fear");
  EXPECT_EQ(describe(**assets, *protocol::parse_au_set("12:33")), "12:33");
  const auto typo = find_expression(**assets, "hapiness");
  ASSERT_FALSE(typo.has_value());
  EXPECT_NE(typo.error().message.find("did you mean happiness?"), std::string::npos);
}

TEST(ShippedAssets, AMissingFaceIsUnreadable) {
  FaceOptions options;
  options.data = test::program("data");
  options.face = "/no/such/face";
  const auto assets = load_assets(options);
  ASSERT_FALSE(assets.has_value());
  EXPECT_EQ(assets.error().kind, ErrorKind::Unreadable);
}

}  // namespace
}  // namespace aucast::app

#include "client/gui/model/emotion_pad.h"

#include <cmath>

#include <gtest/gtest.h>

namespace aucast::gui {
namespace {

AuFrame one_au(std::uint8_t number, std::uint8_t percent) {
  const AuTerm term{number, Side::Both, percent};
  return frame_from_terms({&term, 1});
}

class EmotionPad : public testing::Test {
 protected:
  std::vector<PadPoint> points_ = {{"Happiness", 0.8F, 0, one_au(12, 100)},
                                   {"Surprise", 0, 1, one_au(26, 80)},
                                   {"Sadness", -0.5F, -0.5F, one_au(15, 40)}};
};

TEST_F(EmotionPad, TheMiddleIsNeutral) {
  EXPECT_EQ(pad_face(points_, 0, 0), AuFrame());
  EXPECT_EQ(pad_face({}, 0.5F, 0.5F), AuFrame());
}

TEST_F(EmotionPad, APrototypeIsItselfAtItsPlaceAndBehindIt) {
  for (const PadPoint& point : points_) {
    EXPECT_EQ(pad_face(points_, point.x, point.y), point.aus) << point.label;
    EXPECT_EQ(pad_face(points_, 1.2F * point.x, 1.2F * point.y), point.aus) << point.label;
  }
}

TEST_F(EmotionPad, HalfWayFromTheMiddleIsHalfOfIt) {
  EXPECT_EQ(pad_face(points_, 0.4F, 0), one_au(12, 50));
  EXPECT_EQ(pad_face(points_, -0.25F, -0.25F), one_au(15, 20));
}

TEST_F(EmotionPad, BetweenTwoPrototypesItIsOfBoth) {
  const AuFrame face = pad_face(points_, 0.9F, 0.9F);
  EXPECT_FLOAT_EQ(face.left[12], 0.5F);
  EXPECT_FLOAT_EQ(face.right[26], 0.4F);
  EXPECT_EQ(face.left[15], 0);
}

TEST_F(EmotionPad, GoingRoundNeverJumps) {
  AuFrame last = pad_face(points_, 1, 0);
  for (int degree = 1; degree <= 360; ++degree) {
    const float angle = static_cast<float>(degree) * 3.14159265F / 180;
    const AuFrame face = pad_face(points_, std::cos(angle), std::sin(angle));
    for (std::size_t i = 0; i < face.left.size(); ++i) {
      EXPECT_NEAR(face.left[i], last.left[i], 0.05F) << degree << " degrees, AU " << i;
    }
    last = face;
  }
}

TEST_F(EmotionPad, ALonelyPrototypeIsEverywhere) {
  points_.resize(1);
  EXPECT_EQ(pad_face(points_, -1, 0.5F), one_au(12, 100));
  EXPECT_EQ(pad_face(points_, 0, -0.4F), one_au(12, 50));
}

}  // namespace
}  // namespace aucast::gui

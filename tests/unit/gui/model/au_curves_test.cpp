#include "client/gui/model/au_curves.h"

#include <gtest/gtest.h>

namespace aucast::gui {
namespace {

std::vector<playback::Keyframe> keyframes(std::initializer_list<std::vector<AuTerm>> sets) {
  std::vector<playback::Keyframe> made;
  for (const std::vector<AuTerm>& terms : sets) made.push_back({frame_from_terms(terms), {}});
  return made;
}

const std::vector<Duration> kEnds = {Milliseconds(100), Milliseconds(300), Milliseconds(300),
                                     Milliseconds(400)};

TEST(AuCurves, ThereIsOneForEachAuThatOccurs) {
  const AuCurves curves = curves_of(
      keyframes({{{12, Side::Both, 80}}, {{12, Side::Left, 20}, {14, Side::Right, 50}}, {}}));
  ASSERT_EQ(curves.size(), 2U);
  EXPECT_EQ(curves[0].number, 12);
  EXPECT_EQ(curves[0].values, (std::vector<float>{0.8F, 0.2F, 0}));
  EXPECT_EQ(curves[1].values, (std::vector<float>{0, 0.5F, 0})) << "of the stronger side";
  EXPECT_TRUE(curves_of({}).empty());
}

TEST(AuCurves, AValueIsReadAnywhere) {
  const AuCurve curve{12, {0.8F, 0.4F, 1, 0}};
  const auto at = [&](int ms) { return value_at(curve, kEnds, Milliseconds(ms)); };
  EXPECT_FLOAT_EQ(at(-50), 0);
  EXPECT_FLOAT_EQ(at(0), 0);
  EXPECT_FLOAT_EQ(at(50), 0.4F);
  EXPECT_FLOAT_EQ(at(100), 0.8F);
  EXPECT_FLOAT_EQ(at(200), 0.6F);
  EXPECT_FLOAT_EQ(at(350), 0.5F) << "from the one that takes no time";
  EXPECT_FLOAT_EQ(at(9999), 0);
  EXPECT_FLOAT_EQ(value_at({}, {}, Milliseconds(1)), 0);
}

TEST(AuCurves, AnOutlineLosesNoPeak) {
  const AuCurve curve{12, {0.8F, 0.4F, 1, 0}};
  const std::vector<float> outline = outline_of(curve, kEnds, 3);
  ASSERT_EQ(outline.size(), 3U);
  EXPECT_FLOAT_EQ(outline[0], 0);
  EXPECT_FLOAT_EQ(outline[1], 0.8F);
  EXPECT_FLOAT_EQ(outline[2], 1) << "between two columns";
  EXPECT_EQ(outline_of({12, {}}, {}, 2), (std::vector<float>{0, 0}));
}

}  // namespace
}  // namespace aucast::gui

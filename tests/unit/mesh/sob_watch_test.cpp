#include "common/mesh/sob_watch.h"

#include <gtest/gtest.h>

#include <cmath>

#include "common/au_numbers.h"

namespace aucast::mesh {
namespace {

constexpr double kClose = 1e-6;

/// A broad mouth that is read as a smile of 0.8 and a stretch of 0.1 on the left.
AuFrame broad_mouth(float inner_brow, float outer_brow, float cheek) {
  AuFrame frame;
  for (auto* side : {&frame.left, &frame.right}) {
    (*side)[kInnerBrowRaiser] = inner_brow;
    (*side)[kOuterBrowRaiser] = outer_brow;
    (*side)[kCheekRaiser] = cheek;
  }
  frame.left[kLipCornerPuller] = 0.8F;
  frame.left[kLipStretcher] = 0.1F;
  return frame;
}

double smile_of(const AuFrame& frame) {
  return double{frame.left[kLipCornerPuller]};
}
double stretch_of(const AuFrame& frame) {
  return double{frame.left[kLipStretcher]};
}

TEST(SobWatch, ABroadMouthBelowRaisedInnerBrowsIsNoSmile) {
  SobWatch sobs;
  AuFrame frame = broad_mouth(0.6F, 0.1F, 0.1F);
  sobs.watch(0, frame);
  EXPECT_NEAR(smile_of(frame), 0, kClose);
  EXPECT_NEAR(stretch_of(frame), 0.8, kClose);
}

TEST(SobWatch, ABroadMouthInAnyOtherFaceIsASmile) {
  for (AuFrame frame :
       {broad_mouth(0, 0, 0), broad_mouth(0.6F, 0.6F, 0.1F), broad_mouth(0.6F, 0.1F, 0.6F)}) {
    SobWatch sobs;
    sobs.watch(0, frame);
    EXPECT_NEAR(smile_of(frame), 0.8, kClose);
    EXPECT_NEAR(stretch_of(frame), 0.1, kClose);
  }
}

TEST(SobWatch, ASobEndsSlowly) {
  SobWatch sobs;
  AuFrame sob = broad_mouth(0.6F, 0.1F, 0.1F);
  sobs.watch(1, sob);
  AuFrame at_once = broad_mouth(0, 0, 0);
  sobs.watch(1 + SobWatch::kFadeSeconds, at_once);
  EXPECT_NEAR(smile_of(at_once), 0.8 * (1 - std::exp(-1.0)), 1e-5);
  EXPECT_NEAR(stretch_of(at_once), 0.8 * std::exp(-1.0), 1e-5);
  AuFrame later = broad_mouth(0, 0, 0);
  sobs.watch(1 + 20 * SobWatch::kFadeSeconds, later);
  EXPECT_NEAR(smile_of(later), 0.8, 1e-5);
}

TEST(SobWatch, ASobBeginsAtOnce) {
  SobWatch sobs;
  AuFrame smile = broad_mouth(0, 0, 0.6F);
  sobs.watch(1, smile);
  AuFrame sob = broad_mouth(0.6F, 0.1F, 0.1F);
  sobs.watch(1.1, sob);
  EXPECT_NEAR(smile_of(sob), 0, kClose);
}

}  // namespace
}  // namespace aucast::mesh

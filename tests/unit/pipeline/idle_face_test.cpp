#include "client/pipeline/idle_face.h"

#include <gtest/gtest.h>

#include <vector>

namespace aucast::pipeline {
namespace {

face::Face moving_face() {
  face::Face face;
  for (const char* name :
       {"left_lid_close", "right_lid_close", "left_gaze_left", "left_gaze_right", "left_gaze_up",
        "left_gaze_down", "right_gaze_left", "right_gaze_right", "right_gaze_up", "right_gaze_down",
        "head_up", "head_down", "head_forward", "head_back"}) {
    face.channels.push_back({name, Side::Both, 1});
  }
  face.eyes = {{"left_eye", {2, 3, 6}, 28, 22}, {"right_eye", {-2, 3, 6}, 28, 22}};
  face.head = face::HeadPose{};
  return face;
}

class Idle : public ::testing::Test {
 protected:
  float& at(const char* channel) { return activations_[*face_.channel_index(channel)]; }

  face::Face face_ = moving_face();
  IdleFace idle_{face_};
  std::vector<float> activations_ = std::vector<float>(face_.channels.size(), 0.0F);
};

TEST_F(Idle, BlinkClosesAtLeastSoFar) {
  at("left_lid_close") = 0.8F;
  idle_.blink(0.5F, activations_);
  EXPECT_EQ(at("left_lid_close"), 0.8F);
  EXPECT_EQ(at("right_lid_close"), 0.5F);
}

TEST_F(Idle, NothingLeavesTheFaceAsItIs) {
  at("left_gaze_left") = 0.3F;
  at("left_gaze_right") = 0.1F;
  const std::vector<float> before = activations_;
  idle_.move({}, activations_);
  EXPECT_EQ(activations_, before);
}

TEST_F(Idle, GazeIsAddedInDegreesToWhereTheEyesLook) {
  at("right_gaze_right") = 0.5F;
  idle_.move({2.8, -2.2, 0}, activations_);
  EXPECT_FLOAT_EQ(at("left_gaze_left"), 0.1F);
  EXPECT_FLOAT_EQ(at("right_gaze_right"), 0.4F);
  EXPECT_EQ(at("right_gaze_left"), 0);
  EXPECT_FLOAT_EQ(at("left_gaze_down"), 0.1F);
  EXPECT_EQ(at("left_gaze_up"), 0);
}

TEST_F(Idle, BreathLiftsTheHeadALittle) {
  at("head_down") = 0.5F;
  idle_.move({0, 0, 1}, activations_);
  EXPECT_NEAR(at("head_down"), 0.5F - 0.5F / 22, 1e-6F);
  EXPECT_FLOAT_EQ(at("head_forward"), 0.05F);
}

TEST_F(Idle, StaysWithinTheChannels) {
  at("left_gaze_left") = 1;
  at("head_forward") = 1;
  idle_.move({3, 0, 1}, activations_);
  EXPECT_EQ(at("left_gaze_left"), 1);
  EXPECT_EQ(at("head_forward"), 1);
}

TEST(IdleOfABareFace, DoesNothing) {
  face::Face face;
  face.channels.push_back({"zygomaticus", Side::Both, 2});
  std::vector<float> activations{0.5F};
  const IdleFace idle(face);
  idle.blink(1, activations);
  idle.move({3, 1, 1}, activations);
  EXPECT_EQ(activations, std::vector<float>{0.5F});
}

}  // namespace
}  // namespace aucast::pipeline

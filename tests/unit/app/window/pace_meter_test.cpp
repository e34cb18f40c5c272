#include "client/app/window/pace_meter.h"

#include <gtest/gtest.h>

namespace aucast::app {
namespace {

using Rows = std::vector<gui::PaceRow>;

TEST(PaceMeter, TellsTheMeansOfItsFramesAndBeginsAgain) {
  Instant now{};
  PaceMeter meter(now);
  for (const int ms : {1, 3}) {
    std::optional<Rows> pace;
    for (int frame = 1; frame <= PaceMeter::kFrames; ++frame) {
      ASSERT_FALSE(pace) << frame;
      now += Milliseconds(40);
      // One slow frame counts as every other.
      const Milliseconds face{frame == 1 ? ms + PaceMeter::kFrames : ms};
      pace = meter.add({Milliseconds(ms), Milliseconds(2 * ms), face, {}}, now);
    }
    ASSERT_TRUE(pace);
    const std::string once = std::to_string(ms);
    EXPECT_EQ(*pace, (Rows{{"Frames a second", "25"},
                           {"Activations", once + ".0 ms"},
                           {"Deforming", std::to_string(2 * ms) + ".0 ms"},
                           {"Face", std::to_string(ms + 1) + ".0 ms"},
                           {"Panels", "0.0 ms"}}));
  }
}

}  // namespace
}  // namespace aucast::app

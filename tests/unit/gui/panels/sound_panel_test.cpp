// Sound in the Play tab.
#include <gtest/gtest.h>

#include "tests/unit/gui/gui_by_hand.h"

namespace aucast::gui {
namespace {

class SoundPanel : public GuiByHand {};

TEST_F(SoundPanel, WithoutADeviceOneCanBeChosenAndNoVolumeIsSet) {
  frames(2);
  EXPECT_FALSE(go_to("##device")) << "no sound is wanted";
  model_.sound.missed = true;
  frames(2);
  EXPECT_TRUE(go_to("##device"));
  EXPECT_FALSE(go_to("##volume")) << "what is wrong is said there";
  model_.sound = SoundView{};
  model_.sound.there = true;
  frames(2);
  EXPECT_TRUE(go_to("##volume"));
}

}  // namespace
}  // namespace aucast::gui

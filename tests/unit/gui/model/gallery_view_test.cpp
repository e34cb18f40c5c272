#include "client/gui/model/gallery_view.h"

#include <gtest/gtest.h>

namespace aucast::gui {
namespace {

TEST(GalleryProgress, TellsWhatIsLeftOnceThatIsKnown) {
  GalleryView view;
  EXPECT_EQ(progress_text(view), "beginning ...");
  view.drawn = 3;
  view.total = 591;
  EXPECT_EQ(progress_text(view), "3 of 591 pictures");
  view.left_s = 119;
  EXPECT_EQ(progress_text(view), "3 of 591 pictures, about 119 s left");
  view.left_s = 170;
  EXPECT_EQ(progress_text(view), "3 of 591 pictures, about 3 min left");
  view.ending = true;
  EXPECT_EQ(progress_text(view), "ending ...");
}

}  // namespace
}  // namespace aucast::gui

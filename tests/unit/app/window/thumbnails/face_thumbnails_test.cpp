#include "client/app/window/thumbnails/face_thumbnails.h"

#include <gtest/gtest.h>

namespace aucast::app {
namespace {

TEST(FaceThumbnails, AFaceThatIsNotListedAnyMoreLeavesNoPictureToTheNextOfItsName) {
  FaceThumbnails thumbnails({}, 8, 8);
  gui::Thumbnails pictures;
  pictures.textures = {{"/own/anna", 1}, {"/own/berta", 2}};
  thumbnails.keep_listed({{"berta", "/own/berta", gui::FaceKind::Own}}, pictures);
  EXPECT_FALSE(pictures.textures.contains("/own/anna"));
  EXPECT_TRUE(pictures.textures.contains("/own/berta"));
}

}  // namespace
}  // namespace aucast::app

#include "client/app/window/thumbnails/face_thumbnails.h"

#include <thread>

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

TEST(FaceThumbnails, WhyAFaceHasNoPictureIsSaid) {
  FaceThumbnails thumbnails({}, 8, 8);
  gui::Thumbnails pictures;
  pictures.seen = {"/no/such/face"};
  bool news = false;
  while (pictures.wrong.empty()) {
    news = thumbnails.advance(pictures);
    std::this_thread::yield();
  }
  EXPECT_TRUE(news) << "or it would not be drawn";
  EXPECT_NE(pictures.wrong["/no/such/face"].find("/no/such/face"), std::string::npos);
  EXPECT_FALSE(thumbnails.advance(pictures)) << "it is not tried again";
  thumbnails.keep_listed({}, pictures);
  EXPECT_TRUE(pictures.wrong.empty());
}

TEST(FaceThumbnails, AFaceThatGoesWhileItIsReadLeavesNothingBehind) {
  FaceThumbnails thumbnails({}, 8, 8);
  gui::Thumbnails pictures;
  pictures.seen = {"/no/such/face"};
  EXPECT_FALSE(thumbnails.advance(pictures));
  ASSERT_TRUE(thumbnails.busy());
  thumbnails.keep_listed({}, pictures);
  pictures.seen.clear();
  while (thumbnails.busy()) {
    EXPECT_FALSE(thumbnails.advance(pictures));
    std::this_thread::yield();
  }
  EXPECT_TRUE(pictures.wrong.empty());
  pictures.seen = {"/no/such/face"};
  EXPECT_FALSE(thumbnails.advance(pictures));
  EXPECT_TRUE(thumbnails.busy()) << "a new one of its name is read";
}

}  // namespace
}  // namespace aucast::app

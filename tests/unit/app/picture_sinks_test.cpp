#include "client/app/film/picture_sinks.h"

#include <gtest/gtest.h>

#include "tests/support/temp_folder.h"

namespace aucast::app {
namespace {

TEST(FrameFolder, MakesItsFolderAndCountsFromOne) {
  const test::TempFolder folder;
  auto frames = FrameFolder::open(folder.path() / "a" / "b");
  ASSERT_TRUE(frames.has_value()) << frames.error().message;
  ASSERT_TRUE(frames->add(view::make_image(4, 3)).has_value());
  ASSERT_TRUE(frames->add(view::make_image(4, 3)).has_value());
  EXPECT_FALSE(folder.read("a/b/frame_000001.png").empty());
  EXPECT_FALSE(folder.read("a/b/frame_000002.png").empty());
}

TEST(FrameFolder, SaysWhyItCannotWrite) {
  const test::TempFolder folder;
  const auto file = folder.write("file", "x");
  for (const auto& path : {file, file / "below"}) {
    const auto frames = FrameFolder::open(path);
    ASSERT_FALSE(frames.has_value());
    EXPECT_EQ(frames.error().kind, ErrorKind::Failed);
    EXPECT_NE(frames.error().message.find("cannot be written: Not a directory"), std::string::npos)
        << frames.error().message;
    EXPECT_NE(frames.error().message.find("choose another folder"), std::string::npos);
  }
}

TEST(Sheet, IsOnePageAndKeepsTheFirstPictures) {
  const test::TempFolder folder;
  Sheet sheet(folder.path() / "sheet.png");
  for (std::size_t i = 0; i < Sheet::kPicturesMax + 5; ++i) {
    EXPECT_EQ(sheet.full(), i >= Sheet::kPicturesMax);
    sheet.add(view::make_image(20, 20, 0xff0000), "12");
  }
  ASSERT_TRUE(sheet.finish().has_value());
  const auto page = view::read_png(folder.path() / "sheet.png");
  ASSERT_TRUE(page.has_value()) << page.error().message;
  EXPECT_GE(page->width, 10 * 20);
}

TEST(Sheet, WithoutPicturesWritesNothing) {
  const test::TempFolder folder;
  EXPECT_TRUE(Sheet(folder.path() / "sheet.png").finish().has_value());
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "sheet.png"));
}

}  // namespace
}  // namespace aucast::app

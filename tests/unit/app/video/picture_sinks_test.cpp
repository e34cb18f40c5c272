#include "client/app/video/picture_sinks.h"

#include <set>
#include <utility>

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

TEST(FrameFolder, TellsOfPicturesThatALongerRunHasLeft) {
  const test::TempFolder folder;
  const auto run = [&folder](int pictures) {
    auto frames = FrameFolder::open(folder.path());
    EXPECT_TRUE(frames);
    for (int i = 0; i < pictures; ++i) EXPECT_TRUE(frames->add(view::make_image(4, 3)));
    return frames->leftovers();
  };
  EXPECT_EQ(run(4), "");
  EXPECT_EQ(run(4), "");
  EXPECT_EQ(run(2), folder.path().string() +
                        ": 2 pictures from frame_000003.png on are of an earlier run; remove them "
                        "before you make a video of this folder");
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

/// The page of a stream of so many keyframes, each of a colour of its own.
view::Image page_of(std::uint32_t keyframes) {
  const test::TempFolder folder;
  Sheet sheet(folder.path() / "sheet.png");
  for (std::uint32_t i = 0; i < keyframes; ++i) {
    if (sheet.wants_next()) sheet.add(view::make_image(20, 20, 0xff0000 + i), "12");
  }
  EXPECT_TRUE(sheet.finish().has_value());
  auto page = view::read_png(folder.path() / "sheet.png");
  EXPECT_TRUE(page.has_value());
  return page.has_value() ? std::move(*page) : view::Image{};
}

/// How many of the keyframes are on the page.
std::size_t shown(const view::Image& page, std::uint32_t keyframes) {
  std::set<std::uint32_t> found;
  for (std::size_t at = 0; at < page.rgba.size(); at += 4) {
    const std::uint32_t below = page.rgba[at + 1] * 256U + page.rgba[at + 2];
    if (page.rgba[at] == 0xff && below < keyframes) found.insert(below);
  }
  return found.size();
}

TEST(Sheet, IsOnePageWithEveryKeyframeOfAShortStream) {
  const view::Image page = page_of(60);
  EXPECT_GE(page.width, 10 * 20);
  EXPECT_EQ(shown(page, 60), 60U);
}

TEST(Sheet, ShowsALongStreamFromItsBeginningToItsEnd) {
  for (const auto& [keyframes, pictures] :
       {std::pair{61U, 31U}, std::pair{120U, 60U}, std::pair{121U, 31U}, std::pair{1000U, 32U}}) {
    const view::Image page = page_of(keyframes);
    EXPECT_EQ(shown(page, keyframes), pictures) << keyframes;
    const std::size_t in_second_half = shown(page, keyframes) - shown(page, keyframes / 2);
    EXPECT_NEAR(static_cast<double>(in_second_half), pictures / 2.0, 1) << keyframes;
  }
}

TEST(Sheet, WithoutPicturesWritesNothing) {
  const test::TempFolder folder;
  EXPECT_TRUE(Sheet(folder.path() / "sheet.png").finish().has_value());
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "sheet.png"));
}

}  // namespace
}  // namespace aucast::app

#include "client/app/video/picture_sinks.h"

#include <iterator>
#include <optional>
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

/// How many pictures were asked for, and the page.
struct Page {
  std::size_t drawn = 0;
  view::Image image;
};

/// The page of a stream of so many keyframes, each of a colour of its own.
Page page_of(std::uint32_t keyframes, const Sheet::Options& options) {
  const test::TempFolder folder;
  Sheet sheet(folder.path() / "sheet.png", options);
  Page page;
  for (std::uint32_t i = 0; i < keyframes; ++i) {
    if (!sheet.wants_next()) continue;
    ++page.drawn;
    sheet.add(view::make_image(20, 20, 0xff0000 + i), "12");
  }
  EXPECT_TRUE(sheet.finish().has_value());
  auto image = view::read_png(folder.path() / "sheet.png");
  EXPECT_TRUE(image.has_value());
  if (image.has_value()) page.image = std::move(*image);
  return page;
}

/// The keyframes that are on the page.
std::set<std::uint32_t> shown(const view::Image& page, std::uint32_t keyframes) {
  std::set<std::uint32_t> found;
  for (std::size_t at = 0; at < page.rgba.size(); at += 4) {
    const std::uint32_t below = page.rgba[at + 1] * 256U + page.rgba[at + 2];
    if (page.rgba[at] == 0xff && below < keyframes) found.insert(below);
  }
  return found;
}

TEST(Sheet, IsOnePageWithEveryKeyframeOfAShortStream) {
  for (const std::optional<std::uint64_t> known : {std::optional<std::uint64_t>(54), {}}) {
    const Page page = page_of(54, {.keyframes = known});
    EXPECT_GE(page.image.width, 9 * 20);
    EXPECT_LT(page.image.width, 10 * 20 + 10 * 9);
    EXPECT_EQ(shown(page.image, 54).size(), 54U);
  }
}

TEST(Sheet, ShowsALongStreamFromItsBeginningToItsEnd) {
  for (const auto& [keyframes, pictures] :
       {std::pair{55U, 28U}, std::pair{108U, 54U}, std::pair{109U, 28U}, std::pair{1000U, 32U}}) {
    const auto found = shown(page_of(keyframes, {}).image, keyframes);
    EXPECT_EQ(found.size(), pictures) << keyframes;
    const auto in_first_half = std::distance(found.begin(), found.lower_bound(keyframes / 2));
    EXPECT_NEAR(static_cast<double>(in_first_half), pictures / 2.0, 1) << keyframes;
  }
}

TEST(Sheet, OfAKnownNumberDrawsWhatItShowsEvenlySpread) {
  for (const std::uint32_t keyframes : {55U, 107U, 109U, 688U, 10'000U}) {
    const Page page = page_of(keyframes, {.keyframes = keyframes});
    EXPECT_EQ(page.drawn, Sheet::kPicturesMax) << keyframes;
    const auto found = shown(page.image, keyframes);
    ASSERT_EQ(found.size(), Sheet::kPicturesMax) << keyframes;
    EXPECT_EQ(*found.begin(), 0U);
    EXPECT_EQ(*found.rbegin(), keyframes - 1);
    for (auto one = found.begin(); std::next(one) != found.end(); ++one) {
      const double step = static_cast<double>(keyframes - 1) / (Sheet::kPicturesMax - 1);
      EXPECT_NEAR(*std::next(one) - *one, step, 1) << keyframes;
    }
  }
}

TEST(Sheet, MayShowPicturesAtHalfTheirSize) {
  const Page whole = page_of(4, {});
  const Page halved = page_of(4, {.halved = true});
  EXPECT_EQ(whole.image.width - halved.image.width, 3 * 10);
  EXPECT_EQ(shown(halved.image, 4).size(), 4U);
}

TEST(Sheet, WithoutPicturesWritesNothing) {
  const test::TempFolder folder;
  EXPECT_TRUE(Sheet(folder.path() / "sheet.png", {}).finish().has_value());
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "sheet.png"));
}

}  // namespace
}  // namespace aucast::app

#include "client/view/image.h"

#include <sys/stat.h>
#include <unistd.h>

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/image_difference.h"
#include "tests/support/seeded.h"
#include "tests/support/temp_folder.h"

namespace aucast::view {
namespace {

Image noise(test::Seeded& seeded, int width, int height, bool alpha) {
  Image image = make_image(width, height);
  for (std::size_t i = 0; i < image.rgba.size(); ++i) {
    if (i % 4 != 3 || alpha) image.rgba[i] = static_cast<std::uint8_t>(seeded.integer(0, 255));
  }
  return image;
}

std::uint32_t pixel(const Image& image, int x, int y) {
  const std::size_t at = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                              static_cast<std::size_t>(x));
  return static_cast<std::uint32_t>(image.rgba[at] << 16U | image.rgba[at + 1] << 8U |
                                    image.rgba[at + 2]);
}

TEST(MakeImage, FillsWithOneOpaqueColour) {
  const Image image = make_image(3, 2, 0x123456);
  ASSERT_EQ(image.rgba.size(), 24U);
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    EXPECT_EQ(std::vector<std::uint8_t>(image.rgba.begin() + static_cast<std::ptrdiff_t>(i),
                                        image.rgba.begin() + static_cast<std::ptrdiff_t>(i) + 4),
              (std::vector<std::uint8_t>{0x12, 0x34, 0x56, 255}));
  }
}

TEST(Png, ComesBackAsItWas) {
  test::Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  const test::TempFolder folder;
  for (const bool alpha : {false, true}) {
    for (int i = 0; i < 20; ++i) {
      const Image image = noise(seeded, seeded.integer(1, 70), seeded.integer(1, 70), alpha);
      const auto file = folder.path() / "x.png";
      ASSERT_TRUE(write_png(image, file).has_value());
      const auto back = read_png(file);
      ASSERT_TRUE(back.has_value()) << back.error().message;
      EXPECT_EQ(back->width, image.width);
      EXPECT_EQ(back->height, image.height);
      EXPECT_EQ(back->rgba, image.rgba);
    }
  }
}

TEST(Png, IsTheSameBytesTwice) {
  test::Seeded seeded;
  const test::TempFolder folder;
  const Image image = noise(seeded, 64, 48, false);
  ASSERT_TRUE(write_png(image, folder.path() / "a.png").has_value());
  ASSERT_TRUE(write_png(image, folder.path() / "b.png").has_value());
  EXPECT_FALSE(folder.read("a.png").empty());
  EXPECT_EQ(folder.read("a.png"), folder.read("b.png"));
}

TEST(WritePng, SaysWhereAndWhyItFailed) {
  const test::TempFolder folder;
  const auto file = folder.path() / "missing" / "x.png";
  const auto result = write_png(make_image(2, 2), file);
  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().kind, ErrorKind::Failed);
  EXPECT_NE(result.error().message.find("x.png: cannot be written: No such file"),
            std::string::npos)
      << result.error().message;
}

TEST(ReadPng, RefusesWhatIsNoPicture) {
  const test::TempFolder folder;
  ASSERT_TRUE(write_png(make_image(20, 20, 0x777777), folder.path() / "good.png").has_value());
  const std::string good = folder.read("good.png");
  for (const std::string& bytes :
       {std::string(), std::string("no picture"), good.substr(0, 40), std::string("GIF89a..")}) {
    const auto result = read_png(folder.write("bad.png", bytes));
    ASSERT_FALSE(result.has_value());
    EXPECT_EQ(result.error().kind, ErrorKind::BadData);
    EXPECT_NE(result.error().message.find("bad.png: not a PNG picture"), std::string::npos)
        << result.error().message;
  }
  EXPECT_EQ(read_png(folder.path() / "none.png").error().kind, ErrorKind::Unreadable);
}

TEST(Paste, CopiesAndCutsAtTheBorders) {
  const Image from = make_image(4, 4, 0xff0000);
  for (int y = -5; y <= 9; ++y) {
    for (int x = -5; x <= 9; ++x) {
      Image to = make_image(8, 8, 0x0000ff);
      paste(to, from, x, y);
      for (int row = 0; row < 8; ++row) {
        for (int column = 0; column < 8; ++column) {
          const bool inside = column >= x && column < x + 4 && row >= y && row < y + 4;
          ASSERT_EQ(pixel(to, column, row), inside ? 0xff0000U : 0x0000ffU)
              << x << ' ' << y << " at " << column << ' ' << row;
        }
      }
    }
  }
}

TEST(ContactSheet, HoldsEveryPictureOnceInRows) {
  std::vector<Image> pictures;
  std::vector<std::string> captions;
  for (std::uint32_t i = 0; i < 5; ++i) {
    pictures.push_back(make_image(60, 40, 0x100000 * (i + 1)));
    captions.push_back("picture " + std::to_string(i));
  }
  const Image sheet = contact_sheet(pictures, captions, 3);
  EXPECT_GE(sheet.width, 3 * 60);
  EXPECT_LT(sheet.width, 4 * 60);
  EXPECT_GE(sheet.height, 2 * 40);
  for (std::uint32_t i = 0; i < 5; ++i) {
    int count = 0;
    for (int y = 0; y < sheet.height; ++y) {
      for (int x = 0; x < sheet.width; ++x) count += pixel(sheet, x, y) == 0x100000 * (i + 1);
    }
    EXPECT_EQ(count, 60 * 40) << i;
  }
}

TEST(ContactSheet, WritesTheCaptionsAndCutsLongOnes) {
  const std::vector<Image> pictures{make_image(90, 30, 0xff0000)};
  const auto sheet = [&pictures](const std::string& caption) {
    return contact_sheet(pictures, std::vector<std::string>{caption}, 4);
  };
  EXPECT_GT(test::compare(sheet("joy"), sheet(""), 0).share, 0);
  EXPECT_GT(test::compare(sheet("joy"), sheet("fear"), 0).share, 0);
  const std::string endless(300, 'm');
  EXPECT_EQ(sheet(endless).width, sheet("joy").width);
  EXPECT_EQ(test::compare(sheet(endless), sheet(endless + "m"), 0).share, 0);
}

TEST(Compare, CountsPixelsBeyondTheTolerance) {
  const Image a = make_image(10, 10, 0x646464);
  Image b = a;
  EXPECT_EQ(test::compare(a, b, 0).share, 0);
  EXPECT_EQ(test::compare(a, b, 0).largest, 0);
  b.rgba[1] = 104;   // 4 above
  b.rgba[42] = 110;  // 10 above
  EXPECT_DOUBLE_EQ(test::compare(a, b, 0).share, 0.02);
  EXPECT_DOUBLE_EQ(test::compare(a, b, 4).share, 0.01);
  EXPECT_DOUBLE_EQ(test::compare(a, b, 10).share, 0);
  EXPECT_EQ(test::compare(b, a, 255).largest, 10);
}

TEST(Halved, IsTheMeanOfFour) {
  Image image = make_image(4, 2, 0x102030);
  image.rgba[0] = 20;   // of the first four pixels
  image.rgba[17] = 34;  // green of the one below
  image.rgba[9] = 255;  // green of the third in the first row
  const Image half = halved(image);
  EXPECT_EQ(half.width, 2);
  EXPECT_EQ(half.height, 1);
  EXPECT_EQ(half.rgba, (std::vector<std::uint8_t>{17, 33, 48, 255, 16, 88, 48, 255}));
}

TEST(WithoutGround, TellsTheGroundFromWhatStandsBeforeIt) {
  // What is there wholly, not at all, and by two thirds.
  Image on_black = make_image(3, 1);
  Image on_white = make_image(3, 1, 0xFFFFFF);
  on_black.rgba = {10, 200, 90, 255, 0, 0, 0, 255, 100, 40, 0, 255};
  on_white.rgba = {10, 200, 90, 255, 255, 255, 255, 255, 185, 125, 85, 255};
  const Image image = without_ground(on_black, on_white);
  EXPECT_EQ(image.rgba, (std::vector<std::uint8_t>{10, 200, 90, 255, 0, 0, 0, 0, 150, 60, 0, 170}));
}

TEST(Compare, CallsOtherSizesWhollyDifferent) {
  const test::ImageDifference difference = test::compare(make_image(4, 5), make_image(5, 4), 255);
  EXPECT_EQ(difference.share, 1);
  EXPECT_EQ(difference.largest, 255);
}

}  // namespace
}  // namespace aucast::view

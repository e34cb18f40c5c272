#include "common/mesh/face_finder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/small_model.h"

namespace aucast::mesh {
namespace {

using test::FlatTable;

/// MediaPipe's detector: 16x16 places with two looks each, then 8x8 with six; 16 numbers a look.
constexpr std::size_t kAllLooks = 16 * 16 * 2 + 8 * 8 * 6;
constexpr std::size_t kEachLook = 16;
constexpr float kPixels = 128;  ///< of the side of what it sees

std::string float_bytes(const std::vector<float>& numbers) {
  std::string bytes(4 * numbers.size(), '\0');
  std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return bytes;
}

/// A detector that sees the same whatever it is shown.
struct Seer {
  std::vector<float> boxes = std::vector<float>(kAllLooks * kEachLook, 0.0F);
  std::vector<float> scores = std::vector<float>(kAllLooks, -20.0F);
  std::int32_t side = 128;

  /// A face `size` pixels wide and high whose middle is `x`, `y` from where it was looked from.
  /// `eyes`: how much lower the left one is than the right one, 10 pixels away.
  void sees(std::size_t look, float score, float size, float x = 0, float y = 0, float eyes = 0) {
    scores[look] = score;
    const std::vector<float> numbers{x, y, size, size, 0, 0, 10, eyes};
    std::copy(numbers.begin(), numbers.end(),
              boxes.begin() + static_cast<std::ptrdiff_t>(look * kEachLook));
  }
  [[nodiscard]] Result<FaceFinder> finder() const {
    const auto tensor = [](std::vector<std::int32_t> shape, std::int32_t buffer) {
      return FlatTable().integers(0, std::move(shape)).byte(1, 0).number(2, buffer);
    };
    const auto looks = static_cast<std::int32_t>(scores.size());
    const FlatTable graph = FlatTable()
                                .tables(0, {tensor({1, side, side, 3}, 0),
                                            tensor({looks, kEachLook}, 1), tensor({looks, 1}, 2)})
                                .integers(1, {0})
                                .integers(2, {1, 2});
    const std::string file = FlatTable()
                                 .tables(2, {graph})
                                 .tables(4, {FlatTable(), FlatTable().bytes(0, float_bytes(boxes)),
                                             FlatTable().bytes(0, float_bytes(scores))})
                                 .file();
    return FaceFinder::make({reinterpret_cast<const std::uint8_t*>(file.data()), file.size()},
                            "seer.tflite");
  }
  /// In a picture twice as wide as high.
  [[nodiscard]] std::vector<Square> faces(std::size_t most = 9) const {
    const std::vector<std::uint8_t> black(3 * 256 * 128, 0);
    auto found = finder();
    EXPECT_TRUE(found.has_value()) << found.error().message;
    return found ? found->find({256, 128, black}, most) : std::vector<Square>{};
  }
};

std::size_t fine(std::size_t column, std::size_t row) {
  return 2 * (16 * row + column);
}
std::size_t coarse(std::size_t column, std::size_t row) {
  return 16 * 16 * 2 + 6 * (8 * row + column);
}

TEST(FaceFinder, IsWhereItWasLookedFromAndMoves) {
  for (const std::size_t second : {0U, 1U}) {
    Seer seer;
    seer.sees(fine(4, 7) + second, 3, 16, 2, -1);
    const auto faces = seer.faces();
    ASSERT_EQ(faces.size(), 1U);
    // The wider side of the picture fills the net's 128 pixels, so one of them is two of ours.
    EXPECT_NEAR(faces[0].x, 2 * ((4.5 / 16) * kPixels + 2), 1e-4);
    EXPECT_NEAR(faces[0].y, 2 * ((7.5 / 16) * kPixels - 1) - 64, 1e-4) << "bars above and below";
    EXPECT_NEAR(faces[0].side, 2 * 16 * 1.5, 1e-4);
    EXPECT_NEAR(faces[0].turn_rad, 0, 1e-6);
  }
  for (const std::size_t sixth : {0U, 5U}) {
    Seer seer;
    seer.sees(coarse(2, 3) + sixth, 3, 40);
    const auto faces = seer.faces();
    ASSERT_EQ(faces.size(), 1U);
    EXPECT_NEAR(faces[0].x, 2 * (2.5 / 8) * kPixels, 1e-4);
    EXPECT_NEAR(faces[0].y, 2 * (3.5 / 8) * kPixels - 64, 1e-4);
    EXPECT_NEAR(faces[0].side, 2 * 40 * 1.5, 1e-4);
  }
}

TEST(FaceFinder, IsLevelWithTheEyes) {
  Seer seer;
  seer.sees(fine(8, 8), 3, 16, 0, 0, 10);
  const auto faces = seer.faces();
  ASSERT_EQ(faces.size(), 1U);
  EXPECT_NEAR(faces[0].turn_rad, std::atan2(10, 10), 1e-6);
}

TEST(FaceFinder, TheClearestIsFirstAndEachFaceIsFoundOnce) {
  Seer seer;
  seer.sees(fine(3, 8), 1, 16);
  seer.sees(fine(3, 8) + 1, 2, 16, 1, 0);  // the same, a little clearer
  seer.sees(fine(12, 8), 4, 16);
  seer.sees(coarse(6, 4), 3, 16);  // the second one from farther away
  const auto faces = seer.faces();
  ASSERT_EQ(faces.size(), 2U);
  EXPECT_NEAR(faces[0].x, 2 * (12.5 / 16) * kPixels, 1e-4);
  EXPECT_NEAR(faces[1].x, 2 * ((3.5 / 16) * kPixels + 1), 1e-4);
  const auto one = seer.faces(1);
  ASSERT_EQ(one.size(), 1U);
  EXPECT_EQ(one[0].x, faces[0].x);
}

TEST(FaceFinder, WhatIsNotSureOrCannotBeSeenIsNone) {
  Seer seer;
  EXPECT_TRUE(seer.faces().empty());
  seer.sees(fine(8, 8), -0.01F, 16);
  EXPECT_TRUE(seer.faces().empty());
  seer.sees(fine(8, 8), 0, 16);
  EXPECT_EQ(seer.faces().size(), 1U) << "as sure as it must be";
  for (const float size : {0.0F, -16.0F, NAN, INFINITY}) {
    seer.sees(fine(8, 8), 9, size);
    EXPECT_TRUE(seer.faces().empty()) << size;
  }
  seer.sees(fine(8, 8), NAN, 16);
  EXPECT_TRUE(seer.faces().empty());
}

TEST(FaceFinder, AnotherNetIsRefused) {
  Seer small;
  small.side = 64;
  Seer few;
  few.scores.pop_back();
  few.boxes.resize(few.scores.size() * kEachLook);
  for (const Seer& other : {small, few}) {
    const auto finder = other.finder();
    ASSERT_FALSE(finder.has_value());
    EXPECT_EQ(finder.error().kind, ErrorKind::BadData);
    EXPECT_EQ(finder.error().message,
              "seer.tflite: not a model that can be used: it is not MediaPipe's face detector");
  }
}

}  // namespace
}  // namespace aucast::mesh

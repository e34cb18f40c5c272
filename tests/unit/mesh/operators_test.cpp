#include "common/mesh/operators.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

// Each operator against numbers that are computed another way: by hand, or by the sums of its
// definition in double precision.
namespace aucast::mesh {
namespace {

constexpr double kFloatTolerance = 2e-5;

std::vector<float> some_numbers(std::size_t count, unsigned seed) {
  std::vector<float> numbers(count);
  std::uint32_t state = seed * 2654435761U + 1;
  for (float& number : numbers) {
    state = state * 1664525U + 1013904223U;
    number = static_cast<float>(state >> 8U) / 8388608.0F - 1;
  }
  return numbers;
}

void expect_near(std::span<const float> got, const std::vector<double>& expected) {
  ASSERT_EQ(got.size(), expected.size());
  for (std::size_t index = 0; index < got.size(); ++index) {
    ASSERT_NEAR(double{got[index]}, expected[index], kFloatTolerance) << "number " << index;
  }
}

struct Case {
  Shape in;
  std::size_t channels;
  std::size_t window;
  std::size_t stride;
  bool same;
};

constexpr Case kCases[] = {{{1, 5, 7, 3}, 2, 3, 1, true},    {{1, 6, 6, 4}, 9, 3, 2, true},
                           {{1, 7, 9, 5}, 16, 5, 2, true},   {{1, 4, 6, 8}, 24, 1, 1, true},
                           {{1, 3, 3, 32}, 10, 3, 1, false}, {{1, 8, 11, 1}, 7, 2, 2, false},
                           {{1, 2, 1, 6}, 8, 3, 1, true}};

KernelWindow window_of(const Case& one, const Shape& out) {
  KernelWindow window{one.window, one.window, one.stride, one.stride, 0, 0};
  if (one.same) {
    window.above = padding_before(one.in[1], one.window, one.stride, out[1]);
    window.left = padding_before(one.in[2], one.window, one.stride, out[2]);
  }
  return window;
}

Shape out_shape_of(const Case& one, std::size_t channels) {
  return {1, places(one.in[1], one.window, one.stride, one.same),
          places(one.in[2], one.window, one.stride, one.same), channels};
}

/// Calls `tap(number of the input, row and column in the window)` for what lies under a window.
template <typename Tap>
void under_window(const Case& one, const KernelWindow& window, std::size_t y, std::size_t x,
                  Tap tap) {
  for (std::size_t row = 0; row < one.window; ++row) {
    for (std::size_t column = 0; column < one.window; ++column) {
      const auto h = static_cast<long>(y * one.stride + row) - static_cast<long>(window.above);
      const auto w = static_cast<long>(x * one.stride + column) - static_cast<long>(window.left);
      if (h < 0 || w < 0 || h >= static_cast<long>(one.in[1]) || w >= static_cast<long>(one.in[2]))
        continue;
      tap((static_cast<std::size_t>(h) * one.in[2] + static_cast<std::size_t>(w)) * one.in[3], row,
          column);
    }
  }
}

TEST(Operators, ConvolutionIsTheSumOfItsDefinition) {
  for (const Case& one : kCases) {
    const Shape out_shape = out_shape_of(one, one.channels);
    const KernelWindow window = window_of(one, out_shape);
    const Shape weight_shape{one.channels, one.window, one.window, one.in[3]};
    const auto in = some_numbers(count_of(one.in), 1);
    const auto weights = some_numbers(count_of(weight_shape), 2);
    auto bias = some_numbers(one.channels, 3);
    std::vector<double> expected;
    for (std::size_t y = 0; y < out_shape[1]; ++y) {
      for (std::size_t x = 0; x < out_shape[2]; ++x) {
        for (std::size_t o = 0; o < one.channels; ++o) {
          double sum = double{bias[o]};
          under_window(one, window, y, x,
                       [&](std::size_t from, std::size_t row, std::size_t column) {
                         for (std::size_t i = 0; i < one.in[3]; ++i) {
                           const std::size_t at =
                               ((o * one.window + row) * one.window + column) * one.in[3] + i;
                           sum += double{in[from + i]} * double{weights[at]};
                         }
                       });
          expected.push_back(sum);
        }
      }
    }
    bias.resize(padded_channels(one.channels), 0.0F);
    std::vector<float> out(count_of(out_shape));
    convolve(in, one.in, arranged_weights(weights, weight_shape), bias, window, out, out_shape);
    expect_near(out, expected);
  }
}

TEST(Operators, DepthwiseConvolutionAndPoolingKeepChannelsApart) {
  for (const Case& one : kCases) {
    const std::size_t channels = one.in[3];
    const Shape out_shape = out_shape_of(one, channels);
    const KernelWindow window = window_of(one, out_shape);
    const auto in = some_numbers(count_of(one.in), 4);
    const auto weights = some_numbers(one.window * one.window * channels, 5);
    const auto bias = some_numbers(channels, 6);
    std::vector<double> sums;
    std::vector<double> largest;
    for (std::size_t y = 0; y < out_shape[1]; ++y) {
      for (std::size_t x = 0; x < out_shape[2]; ++x) {
        for (std::size_t c = 0; c < channels; ++c) {
          double sum = double{bias[c]};
          double most = -1e9;
          under_window(one, window, y, x,
                       [&](std::size_t from, std::size_t row, std::size_t column) {
                         sum += double{in[from + c]} *
                                double{weights[(row * one.window + column) * channels + c]};
                         most = std::max(most, double{in[from + c]});
                       });
          sums.push_back(sum);
          largest.push_back(most);
        }
      }
    }
    std::vector<float> out(count_of(out_shape));
    convolve_depthwise(in, one.in, weights, bias, window, out, out_shape);
    expect_near(out, sums);
    pool_maximum(in, one.in, window, out, out_shape);
    expect_near(out, largest);
  }
}

TEST(Operators, SamePaddingPutsTheOddPixelBehind) {
  EXPECT_EQ(padding_before(4, 3, 2, 2), 0U);  // one pixel in all: it comes last
  EXPECT_EQ(padding_before(5, 3, 1, 5), 1U);
  EXPECT_EQ(padding_before(8, 2, 2, 4), 0U);
  EXPECT_EQ(places(7, 3, 2, true), 4U);
  EXPECT_EQ(places(7, 3, 2, false), 3U);
  EXPECT_EQ(places(2, 3, 1, false), 0U);
}

TEST(Operators, ElementsAreCombinedOneByOne) {
  const std::vector<float> a{1, -2, 3, -4};
  const std::vector<float> b{10, 0.5F};
  std::vector<float> out(4);
  add(a, b, out);
  expect_near(out, {11, -1.5, 13, -3.5});
  multiply(a, b, out);
  expect_near(out, {10, -1, 30, -2});
  prelu(a, b, out);
  expect_near(out, {1, -1, 3, -2});
  std::vector<float> activated{-1, 3, 8};
  activate(activated, Activation::None);
  expect_near(activated, {-1, 3, 8});
  activate(activated, Activation::Relu6);
  expect_near(activated, {0, 3, 6});
  activated = {-1, 3, 8};
  activate(activated, Activation::Relu);
  expect_near(activated, {0, 3, 8});
}

TEST(Operators, BlocksArePaddedSlicedAndPut) {
  const Shape in_shape{1, 2, 2, 2};
  const std::vector<float> in{1, 2, 3, 4, 5, 6, 7, 8};
  const Shape padded_shape{1, 3, 2, 3};
  std::vector<float> padded(18);
  pad(in, in_shape, {0, 1, 0, 0}, padded, padded_shape);
  expect_near(padded, {0, 0, 0, 0, 0, 0, 1, 2, 0, 3, 4, 0, 5, 6, 0, 7, 8, 0});
  std::vector<float> sliced(2);
  slice(in, in_shape, {0, 0, 1, 0}, {1, 1, 1, 2}, sliced, {1, 2, 1, 1});
  expect_near(sliced, {3, 7});
  std::vector<float> joined(16, 0.0F);
  put(in, in_shape, 2, 2, joined, {1, 2, 4, 2});
  expect_near(joined, {0, 0, 0, 0, 1, 2, 3, 4, 0, 0, 0, 0, 5, 6, 7, 8});
}

TEST(Operators, ARegionIsLevelWithItsTwoLandmarksAndAroundTheOthers) {
  // Landmarks 0 and 1 lie on a slope of 90 degrees; turned level, the box is 4 wide and 2 high.
  const std::vector<float> landmarks{10, 10, 0, 10, 14, 0, 11, 12, 0, 9, 12, 0};
  RegionOptions options;
  options.left = 0;
  options.right = 1;
  options.landmarks = {0, 1, 2, 3};
  options.scale_x = 1.5;
  options.scale_y = 2;
  options.width = 16;
  options.height = 8;
  const Matrix m = region_matrix(landmarks, options);
  const auto through = [&m](double u, double v) {
    return std::pair(double{m[0]} * u + double{m[1]} * v + double{m[3]},
                     double{m[4]} * u + double{m[5]} * v + double{m[7]});
  };
  const auto [middle_x, middle_y] = through(8, 4);
  EXPECT_NEAR(middle_x, 10, kFloatTolerance);
  EXPECT_NEAR(middle_y, 12, kFloatTolerance);
  // The small map's right end is 3 (4 * 1.5 / 2) along the slope, which goes down.
  const auto [right_x, right_y] = through(16, 4);
  EXPECT_NEAR(right_x, 10, kFloatTolerance);
  EXPECT_NEAR(right_y, 15, kFloatTolerance);
  // Its lower end is 2 (2 * 2 / 2) across, which is to the left.
  const auto [below_x, below_y] = through(8, 8);
  EXPECT_NEAR(below_x, 8, kFloatTolerance);
  EXPECT_NEAR(below_y, 12, kFloatTolerance);
}

TEST(Operators, AMapIsSampledBetweenItsPlaces) {
  const Shape in_shape{1, 2, 3, 1};
  const std::vector<float> in{0, 1, 2, 10, 11, 12};
  // Half a place to the right: between two columns, and beyond the last.
  const Matrix right{1, 0, 0, 0.5F, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  std::vector<float> out(6);
  sample_bilinear(in, in_shape, right, out, in_shape);
  expect_near(out, {0.5, 1.5, 0, 10.5, 11.5, 0});
  const Matrix same{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  sample_bilinear(in, in_shape, same, out, in_shape);
  expect_near(out, {0, 1, 2, 10, 11, 12});
}

TEST(Operators, LandmarksGoThroughTheMatrix) {
  const Matrix matrix{2, 1, 0, 5, 0, 3, 0, -1, 0, 0, 1, 0, 0, 0, 0, 1};
  const std::vector<float> in{1, 2, -1, 0};
  std::vector<float> out(4);
  transform_landmarks(in, matrix, out);
  expect_near(out, {9, 5, 3, -1});
}

}  // namespace
}  // namespace aucast::mesh

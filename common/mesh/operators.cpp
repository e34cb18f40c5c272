#include "common/mesh/operators.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace aucast::mesh {
namespace {

/// Pixels of a row that are computed together, so that weights are loaded once for all of them.
constexpr std::size_t kPixelsAtOnce = 4;

/// The part of a window that lies on the input.
struct Part {
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// Of the window at place `out` along one dimension.
Part part_of(std::size_t out, std::size_t stride, std::size_t before, std::size_t window,
             std::size_t in) {
  const std::size_t first = out * stride;
  const std::size_t begin = first < before ? before - first : 0;
  const std::size_t end = std::min(window, in + before > first ? in + before - first : 0);
  return {begin, std::max(begin, end)};
}

bool whole(const Part& part, std::size_t window) {
  return part.begin == 0 && part.end == window;
}

/// A convolution with what does not change from pixel to pixel.
struct Convolution {
  const float* in;
  const float* weights;
  const float* bias;
  std::size_t in_width, in_channels, out_channels, window_width;
  std::size_t pixel_step;  ///< numbers of the input between two neighbours of the output

  /// `kPixels` neighbours of the output for which the same part of the window lies on the input.
  /// `first`: what the first one's window has at the first place that is on the input.
  template <std::size_t kPixels>
  void pixels(const float* first, const Part& rows, const Part& columns, float* out) const {
    const std::size_t padded = padded_channels(out_channels);
    for (std::size_t channel = 0; channel < out_channels; channel += kChannelsAtOnce) {
      float sums[kPixels][kChannelsAtOnce];
      for (std::size_t pixel = 0; pixel < kPixels; ++pixel) {
        for (std::size_t lane = 0; lane < kChannelsAtOnce; ++lane) {
          sums[pixel][lane] = bias[channel + lane];
        }
      }
      for (std::size_t row = rows.begin; row < rows.end; ++row) {
        const float* numbers = first + (row - rows.begin) * in_width * in_channels;
        const std::size_t taps = (columns.end - columns.begin) * in_channels;
        const float* factors =
            weights + (row * window_width + columns.begin) * in_channels * padded + channel;
        for (std::size_t tap = 0; tap < taps; ++tap, factors += padded) {
          for (std::size_t pixel = 0; pixel < kPixels; ++pixel) {
            const float number = numbers[pixel * pixel_step + tap];
            for (std::size_t lane = 0; lane < kChannelsAtOnce; ++lane) {
              sums[pixel][lane] += number * factors[lane];
            }
          }
        }
      }
      const std::size_t lanes = std::min(kChannelsAtOnce, out_channels - channel);
      for (std::size_t pixel = 0; pixel < kPixels; ++pixel) {
        std::copy_n(sums[pixel], lanes, out + pixel * out_channels + channel);
      }
    }
  }
};

/// Calls `at(pixel of the input, place in the window, pixel of the output)` for each pixel of the
/// input that lies under the window of a pixel of the output, in the order of memory.
template <typename At>
void under_window(std::span<const float> in, const Shape& in_shape, const KernelWindow& window,
                  std::span<float> out, const Shape& out_shape, At at) {
  const std::size_t channels = out_shape[3];
  float* to = out.data();
  for (std::size_t y = 0; y < out_shape[1]; ++y) {
    const Part rows = part_of(y, window.stride_height, window.above, window.height, in_shape[1]);
    for (std::size_t x = 0; x < out_shape[2]; ++x, to += channels) {
      const Part columns = part_of(x, window.stride_width, window.left, window.width, in_shape[2]);
      for (std::size_t row = rows.begin; row < rows.end; ++row) {
        const std::size_t in_row = y * window.stride_height + row - window.above;
        for (std::size_t column = columns.begin; column < columns.end; ++column) {
          const std::size_t in_column = x * window.stride_width + column - window.left;
          at(in.data() + (in_row * in_shape[2] + in_column) * channels, row * window.width + column,
             to);
        }
      }
    }
  }
}

/// Calls `at(flat place in the small, flat place in the large)` for each number of the smaller of
/// two blocks, which lies in the larger at `origin` with `stride` between its numbers.
template <typename At>
void walk(const Shape& small, const Shape& large, const Shape& origin, const Shape& stride, At at) {
  std::size_t place = 0;
  for (std::size_t b = 0; b < small[0]; ++b) {
    for (std::size_t h = 0; h < small[1]; ++h) {
      for (std::size_t w = 0; w < small[2]; ++w) {
        const std::size_t row = (origin[0] + b * stride[0]) * large[1] + origin[1] + h * stride[1];
        std::size_t other = (row * large[2] + origin[2] + w * stride[2]) * large[3] + origin[3];
        for (std::size_t c = 0; c < small[3]; ++c, other += stride[3]) at(place++, other);
      }
    }
  }
}

constexpr Shape kEvery{1, 1, 1, 1};

}  // namespace

std::size_t padding_before(std::size_t in, std::size_t window, std::size_t stride,
                           std::size_t out) {
  const std::size_t needed = (out - 1) * stride + window;
  return needed > in ? (needed - in) / 2 : 0;
}

std::size_t places(std::size_t in, std::size_t window, std::size_t stride, bool same) {
  if (same) return (in + stride - 1) / stride;
  return in < window ? 0 : (in - window) / stride + 1;
}

void activate(std::span<float> numbers, Activation activation) {
  if (activation == Activation::None) return;
  const float most =
      activation == Activation::Relu6 ? 6.0F : std::numeric_limits<float>::infinity();
  for (float& number : numbers) number = std::min(std::max(number, 0.0F), most);
}

std::vector<float> arranged_weights(std::span<const float> weights, const Shape& shape) {
  const std::size_t taps = shape[1] * shape[2] * shape[3];
  const std::size_t padded = padded_channels(shape[0]);
  std::vector<float> arranged(taps * padded, 0.0F);
  for (std::size_t channel = 0; channel < shape[0]; ++channel) {
    for (std::size_t tap = 0; tap < taps; ++tap) {
      arranged[tap * padded + channel] = weights[channel * taps + tap];
    }
  }
  return arranged;
}

void convolve(std::span<const float> in, const Shape& in_shape, std::span<const float> weights,
              std::span<const float> bias, const KernelWindow& window, std::span<float> out,
              const Shape& out_shape) {
  const Convolution convolution{
      in.data(),   weights.data(), bias.data(),  in_shape[2],
      in_shape[3], out_shape[3],   window.width, window.stride_width * in_shape[3]};
  float* to = out.data();
  for (std::size_t y = 0; y < out_shape[1]; ++y) {
    const Part rows = part_of(y, window.stride_height, window.above, window.height, in_shape[1]);
    const std::size_t top = y * window.stride_height + rows.begin - window.above;
    const auto columns_at = [&](std::size_t x) {
      return part_of(x, window.stride_width, window.left, window.width, in_shape[2]);
    };
    for (std::size_t x = 0; x < out_shape[2];) {
      const Part columns = columns_at(x);
      const std::size_t left = x * window.stride_width + columns.begin - window.left;
      const float* first = in.data() + (top * in_shape[2] + left) * in_shape[3];
      const std::size_t last = x + kPixelsAtOnce - 1;
      if (whole(columns, window.width) && last < out_shape[2] &&
          whole(columns_at(last), window.width)) {
        convolution.pixels<kPixelsAtOnce>(first, rows, columns, to);
        x += kPixelsAtOnce;
        to += kPixelsAtOnce * out_shape[3];
      } else {
        convolution.pixels<1>(first, rows, columns, to);
        x += 1;
        to += out_shape[3];
      }
    }
  }
}

void convolve_depthwise(std::span<const float> in, const Shape& in_shape,
                        std::span<const float> weights, std::span<const float> bias,
                        const KernelWindow& window, std::span<float> out, const Shape& out_shape) {
  const std::size_t channels = out_shape[3];
  for (float* to = out.data(); to != out.data() + out.size(); to += channels) {
    std::copy(bias.begin(), bias.end(), to);
  }
  under_window(in, in_shape, window, out, out_shape,
               [&](const float* from, std::size_t place, float* to) {
                 const float* factors = weights.data() + place * channels;
                 for (std::size_t channel = 0; channel < channels; ++channel) {
                   to[channel] += from[channel] * factors[channel];
                 }
               });
}

void pool_maximum(std::span<const float> in, const Shape& in_shape, const KernelWindow& window,
                  std::span<float> out, const Shape& out_shape) {
  const std::size_t channels = out_shape[3];
  std::fill(out.begin(), out.end(), std::numeric_limits<float>::lowest());
  under_window(in, in_shape, window, out, out_shape,
               [&](const float* from, std::size_t /*place*/, float* to) {
                 for (std::size_t channel = 0; channel < channels; ++channel) {
                   to[channel] = std::max(to[channel], from[channel]);
                 }
               });
}

void prelu(std::span<const float> in, std::span<const float> slopes, std::span<float> out) {
  const std::size_t channels = slopes.size();
  for (std::size_t begin = 0; begin < in.size(); begin += channels) {
    for (std::size_t channel = 0; channel < channels; ++channel) {
      const float number = in[begin + channel];
      out[begin + channel] = number < 0 ? number * slopes[channel] : number;
    }
  }
}

void add(std::span<const float> a, std::span<const float> b, std::span<float> out) {
  for (std::size_t begin = 0; begin < a.size(); begin += b.size()) {
    for (std::size_t index = 0; index < b.size(); ++index) {
      out[begin + index] = a[begin + index] + b[index];
    }
  }
}

void multiply(std::span<const float> a, std::span<const float> b, std::span<float> out) {
  for (std::size_t begin = 0; begin < a.size(); begin += b.size()) {
    for (std::size_t index = 0; index < b.size(); ++index) {
      out[begin + index] = a[begin + index] * b[index];
    }
  }
}

void pad(std::span<const float> in, const Shape& in_shape, const Shape& before,
         std::span<float> out, const Shape& out_shape) {
  std::fill(out.begin(), out.end(), 0.0F);
  walk(in_shape, out_shape, before, kEvery,
       [&](std::size_t small, std::size_t large) { out[large] = in[small]; });
}

void slice(std::span<const float> in, const Shape& in_shape, const Shape& begin,
           const Shape& stride, std::span<float> out, const Shape& out_shape) {
  walk(out_shape, in_shape, begin, stride,
       [&](std::size_t small, std::size_t large) { out[small] = in[large]; });
}

void put(std::span<const float> in, const Shape& in_shape, std::size_t axis, std::size_t at,
         std::span<float> out, const Shape& out_shape) {
  Shape origin{};
  origin[axis] = at;
  walk(in_shape, out_shape, origin, kEvery,
       [&](std::size_t small, std::size_t large) { out[large] = in[small]; });
}

Matrix region_matrix(std::span<const float> landmarks, const RegionOptions& options) {
  const auto x = [&](std::size_t landmark) { return double{landmarks[3 * landmark]}; };
  const auto y = [&](std::size_t landmark) { return double{landmarks[3 * landmark + 1]}; };
  const double slope =
      std::atan2(y(options.right) - y(options.left), x(options.right) - x(options.left));
  const double turn = options.target_angle_rad - slope;
  const double cosine = std::cos(turn);
  const double sine = std::sin(turn);
  constexpr double kFar = std::numeric_limits<double>::max();
  double left = kFar;
  double right = -kFar;
  double top = kFar;
  double bottom = -kFar;
  for (const std::size_t landmark : options.landmarks) {
    const double across = cosine * x(landmark) - sine * y(landmark);
    const double down = sine * x(landmark) + cosine * y(landmark);
    left = std::min(left, across);
    right = std::max(right, across);
    top = std::min(top, down);
    bottom = std::max(bottom, down);
  }
  const double across = (left + right) / 2;
  const double down = (top + bottom) / 2;
  const double step_x = options.scale_x * (right - left) / options.width;
  const double step_y = options.scale_y * (bottom - top) / options.height;
  // Turned back, the region's steps and its middle, which is the small map's middle.
  const double xx = cosine * step_x;
  const double xy = sine * step_y;
  const double yx = -sine * step_x;
  const double yy = cosine * step_y;
  const double x0 = cosine * across + sine * down - (xx * options.width + xy * options.height) / 2;
  const double y0 = cosine * down - sine * across - (yx * options.width + yy * options.height) / 2;
  const auto real = [](double number) { return static_cast<float>(number); };
  return {real(xx), real(xy), 0, real(x0), real(yx), real(yy), 0, real(y0), 0, 0, 1, 0, 0, 0, 0, 1};
}

void sample_bilinear(std::span<const float> in, const Shape& in_shape, const Matrix& matrix,
                     std::span<float> out, const Shape& out_shape) {
  const std::size_t channels = out_shape[3];
  const auto right_most = static_cast<float>(in_shape[2] - 1);
  const auto lowest = static_cast<float>(in_shape[1] - 1);
  float* to = out.data();
  for (std::size_t row = 0; row < out_shape[1]; ++row) {
    for (std::size_t column = 0; column < out_shape[2]; ++column, to += channels) {
      // Places are the middles of pixels, in both maps.
      const float u = static_cast<float>(column) + 0.5F;
      const float v = static_cast<float>(row) + 0.5F;
      const float x = matrix[0] * u + matrix[1] * v + matrix[3] - 0.5F;
      const float y = matrix[4] * u + matrix[5] * v + matrix[7] - 0.5F;
      if (!(x >= 0 && x <= right_most && y >= 0 && y <= lowest)) {
        std::fill_n(to, channels, 0.0F);
        continue;
      }
      const auto left = static_cast<std::size_t>(x);
      const auto top = static_cast<std::size_t>(y);
      const std::size_t right = std::min(left + 1, in_shape[2] - 1);
      const std::size_t below = std::min(top + 1, in_shape[1] - 1);
      const float to_right = x - static_cast<float>(left);
      const float to_below = y - static_cast<float>(top);
      const auto at = [&](std::size_t h, std::size_t w) {
        return in.data() + (h * in_shape[2] + w) * channels;
      };
      for (std::size_t channel = 0; channel < channels; ++channel) {
        const float upper =
            (1 - to_right) * at(top, left)[channel] + to_right * at(top, right)[channel];
        const float lower =
            (1 - to_right) * at(below, left)[channel] + to_right * at(below, right)[channel];
        to[channel] = (1 - to_below) * upper + to_below * lower;
      }
    }
  }
}

void transform_landmarks(std::span<const float> in, const Matrix& matrix, std::span<float> out) {
  for (std::size_t index = 0; index + 1 < in.size(); index += 2) {
    const float x = in[index];
    const float y = in[index + 1];
    out[index] = matrix[0] * x + matrix[1] * y + matrix[3];
    out[index + 1] = matrix[4] * x + matrix[5] * y + matrix[7];
  }
}

}  // namespace aucast::mesh

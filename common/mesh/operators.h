#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "common/mesh/model_file.h"

/// The arithmetic of the nets: one function for each operator, from numbers to numbers. The numbers
/// are laid out as in TFLite: channels vary fastest, then columns, rows and batch (always 1 here).
/// The caller has checked that the shapes fit; the sizes of spans are those of their shapes.
namespace aucast::mesh {

/// How an operator's window lies on its input.
struct KernelWindow {
  std::size_t height = 1;
  std::size_t width = 1;
  std::size_t stride_height = 1;
  std::size_t stride_width = 1;
  std::size_t above = 0;  ///< rows of padding before the first row
  std::size_t left = 0;   ///< columns of padding before the first column
};

/// Padding before the first row or column, as TFLite's SAME distributes it.
[[nodiscard]] std::size_t padding_before(std::size_t in, std::size_t window, std::size_t stride,
                                         std::size_t out);
/// How many positions a window takes along one dimension of an input. `same`: with TFLite's SAME
/// padding.
[[nodiscard]] std::size_t places(std::size_t in, std::size_t window, std::size_t stride, bool same);

void activate(std::span<float> numbers, Activation activation);

/// Reorders the weights of a convolution from TFLite's order (output channel, row, column, input
/// channel) to that of convolve(): row, column, input channel, output channel, with
/// padded_channels() output channels.
[[nodiscard]] std::vector<float> arranged_weights(std::span<const float> weights,
                                                  const Shape& shape);
/// How many output channels are computed at a time.
inline constexpr std::size_t kChannelsAtOnce = 8;
[[nodiscard]] constexpr std::size_t padded_channels(std::size_t channels) {
  return (channels + kChannelsAtOnce - 1) / kChannelsAtOnce * kChannelsAtOnce;
}

/// `bias` has padded_channels() numbers.
void convolve(std::span<const float> in, const Shape& in_shape, std::span<const float> weights,
              std::span<const float> bias, const KernelWindow& window, std::span<float> out,
              const Shape& out_shape);
void convolve_depthwise(std::span<const float> in, const Shape& in_shape,
                        std::span<const float> weights, std::span<const float> bias,
                        const KernelWindow& window, std::span<float> out, const Shape& out_shape);
void pool_maximum(std::span<const float> in, const Shape& in_shape, const KernelWindow& window,
                  std::span<float> out, const Shape& out_shape);
/// `slopes` has one number for each channel or one for each number of `in`.
void prelu(std::span<const float> in, std::span<const float> slopes, std::span<float> out);
/// `b` repeats until it is as long as `a`.
void add(std::span<const float> a, std::span<const float> b, std::span<float> out);
void multiply(std::span<const float> a, std::span<const float> b, std::span<float> out);
/// `before`: how many zeros come before the numbers in each dimension; zeros fill the rest of
/// `out`.
void pad(std::span<const float> in, const Shape& in_shape, const Shape& before,
         std::span<float> out, const Shape& out_shape);
/// Every `stride`th number from `begin` on, in each dimension.
void slice(std::span<const float> in, const Shape& in_shape, const Shape& begin,
           const Shape& stride, std::span<float> out, const Shape& out_shape);
/// Copies `in` into `out`, beginning at index `at` of dimension `axis`.
void put(std::span<const float> in, const Shape& in_shape, std::size_t axis, std::size_t at,
         std::span<float> out, const Shape& out_shape);

// === MediaPipe's own operators, of the face mesh with attention

/// A 4x4 matrix, row by row, that turns coordinates in a small map into coordinates in a large one.
using Matrix = std::array<float, 16>;

/// A region around some landmarks, level with two of them.
struct RegionOptions {
  std::size_t left = 0;  ///< the landmark that is level with `right`
  std::size_t right = 0;
  double target_angle_rad = 0;
  std::vector<std::size_t> landmarks;  ///< those that the region surrounds; not empty
  double scale_x = 1;                  ///< width of the region, in widths of the landmarks
  double scale_y = 1;
  double width = 16;  ///< of the small map
  double height = 16;
};

/// `landmarks`: x, y, z of each, in coordinates of the large map.
[[nodiscard]] Matrix region_matrix(std::span<const float> landmarks, const RegionOptions& options);
/// Samples `in`, the large map, bilinearly at the points of `out`, the small map. Points outside of
/// `in` give 0.
void sample_bilinear(std::span<const float> in, const Shape& in_shape, const Matrix& matrix,
                     std::span<float> out, const Shape& out_shape);
/// Transforms x and y of each landmark by the matrix.
void transform_landmarks(std::span<const float> in, const Matrix& matrix, std::span<float> out);

}  // namespace aucast::mesh

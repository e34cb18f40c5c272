#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "common/mesh/flat_buffer.h"
#include "common/result.h"

namespace aucast::mesh {

/// The operators that the engine knows, with the numbers of TFLite's schema; from 1000 on,
/// MediaPipe's custom operators, which have no number in the schema.
enum class Operator : std::uint16_t {
  Add = 0,
  Concatenation = 2,
  Conv2d = 3,
  DepthwiseConv2d = 4,
  Dequantize = 6,
  MaxPool2d = 17,
  Mul = 18,
  Relu = 19,
  Reshape = 22,
  Pad = 34,
  StridedSlice = 45,
  Prelu = 54,
  LandmarksToTransformMatrix = 1000,
  TransformTensorBilinear = 1001,
  TransformLandmarks = 1002,
};

enum class Activation : std::uint8_t { None, Relu, Relu6 };

/// Four dimensions: batch, height, width, channels. Where a file has fewer, the first ones are 1.
using Shape = std::array<std::size_t, 4>;
[[nodiscard]] std::size_t count_of(const Shape& shape);

struct Tensor {
  Shape shape{1, 1, 1, 1};
  std::size_t rank = 4;  ///< how many of the four dimensions the file has
  bool constant = false;
  std::vector<float> values;           ///< of constants
  std::vector<std::int32_t> integers;  ///< of constants: shapes and paddings
};

/// One operator of a net, with the options that its kind has.
struct Step {
  Operator kind = Operator::Add;
  std::vector<std::size_t> inputs;
  std::vector<std::size_t> outputs;
  bool same_padding = true;  ///< else no padding
  std::size_t stride_height = 1;
  std::size_t stride_width = 1;
  std::size_t filter_height = 1;
  std::size_t filter_width = 1;
  std::size_t depth_multiplier = 1;
  std::size_t axis = 0;  ///< which of the four dimensions
  Activation activation = Activation::None;
  FlexMap custom;
};

/// A net as its file describes it. Every index in it is within bounds; whether shapes fit each
/// other is checked by Net.
struct Model {
  std::vector<Tensor> tensors;
  std::vector<Step> steps;
  std::vector<std::size_t> inputs;
  std::vector<std::size_t> outputs;
};

/// How many numbers one tensor may have, and how many all tensors together may have.
inline constexpr std::size_t kTensorNumbersMax = std::size_t{1} << 24U;
inline constexpr std::size_t kModelNumbersMax = std::size_t{1} << 25U;

/// A BadData error: "file: not a model that can be used: why".
[[nodiscard]] Error unusable_model(std::string_view file, std::string_view why);

/// Reads a TFLite file with 32 or 16 bit floats. Fails with BadData and a message that begins with
/// `file` if this is another kind of file, is damaged or has operators that the engine does not
/// know.
[[nodiscard]] Result<Model> read_model(std::span<const std::uint8_t> bytes, std::string_view file);

}  // namespace aucast::mesh

#include "common/mesh/net.h"

#include <algorithm>

#include "common/mesh/net_planner.h"

namespace aucast::mesh {

Result<Net> Net::make(std::span<const std::uint8_t> bytes, std::string_view file) {
  auto model = read_model(bytes, file);
  if (!model) return model.error();
  return Planner(std::move(*model), file).plan();
}

void Net::run() {
  for (const Planned& step : steps_) run(step);
}

Matrix Net::matrix_of(std::size_t tensor) const {
  Matrix matrix{};
  std::copy_n(values_[tensor].begin(), matrix.size(), matrix.begin());
  return matrix;
}

void Net::run(const Planned& step) {
  const std::span<const float> in = values_[step.inputs[0]];
  const Shape& in_shape = shapes_[step.inputs[0]];
  const std::span<float> out = values_[step.output];
  const Shape& out_shape = shapes_[step.output];
  const auto other = [&]() -> std::span<const float> { return values_[step.inputs[1]]; };
  switch (step.kind) {
    case Operator::Conv2d:
      convolve(in, in_shape, step.weights, step.bias, step.window, out, out_shape);
      break;
    case Operator::DepthwiseConv2d:
      convolve_depthwise(in, in_shape, other(), values_[step.inputs[2]], step.window, out,
                         out_shape);
      break;
    case Operator::MaxPool2d:
      pool_maximum(in, in_shape, step.window, out, out_shape);
      break;
    case Operator::Prelu:
      prelu(in, other(), out);
      break;
    case Operator::Add:
      add(in, other(), out);
      break;
    case Operator::Mul:
      multiply(in, other(), out);
      break;
    case Operator::Relu:
      std::copy(in.begin(), in.end(), out.begin());
      activate(out, Activation::Relu);
      break;
    case Operator::Reshape:
      std::copy(in.begin(), in.end(), out.begin());
      break;
    case Operator::Pad:
      pad(in, in_shape, step.begin, out, out_shape);
      break;
    case Operator::StridedSlice:
      slice(in, in_shape, step.begin, step.stride, out, out_shape);
      break;
    case Operator::Concatenation: {
      std::size_t at = 0;
      for (const std::size_t input : step.inputs) {
        put(values_[input], shapes_[input], step.axis, at, out, out_shape);
        at += shapes_[input][step.axis];
      }
      break;
    }
    case Operator::LandmarksToTransformMatrix: {
      const Matrix matrix = region_matrix(in, step.region);
      std::copy(matrix.begin(), matrix.end(), out.begin());
      break;
    }
    case Operator::TransformTensorBilinear:
      sample_bilinear(in, in_shape, matrix_of(step.inputs[1]), out, out_shape);
      break;
    case Operator::TransformLandmarks:
      transform_landmarks(in, matrix_of(step.inputs[1]), out);
      break;
    case Operator::Dequantize:
      break;  // done when the net was made
  }
  activate(out, step.activation);
}

}  // namespace aucast::mesh

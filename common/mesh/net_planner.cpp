#include "common/mesh/net_planner.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace aucast::mesh {
namespace {

std::optional<double> number_in(const FlexMap& map, std::string_view key) {
  const auto found =
      std::find_if(map.begin(), map.end(), [key](const auto& entry) { return entry.first == key; });
  if (found == map.end() || found->second.size() != 1) return std::nullopt;
  return found->second[0];
}

/// A whole number of an option that is below `most`; `most` when it is not.
std::size_t index_in(double value, std::size_t most) {
  if (!(value >= 0 && value < static_cast<double>(most))) return most;
  return static_cast<std::size_t>(value);
}

}  // namespace

Error Net::Planner::bad(const std::string& why) const {
  return unusable_model(file_, why);
}

Result<Net> Net::Planner::plan() {
  if (model_.inputs.size() != 1 || model_.outputs.empty()) {
    return bad("it has not one input and some outputs");
  }
  known_.assign(model_.tensors.size(), false);
  for (std::size_t index = 0; index < model_.tensors.size(); ++index) {
    known_[index] = tensor(index).constant;
    net_.shapes_.push_back(shape(index));
  }
  if (known_[model_.inputs[0]]) return bad("its input is a constant");
  known_[model_.inputs[0]] = true;
  for (const Step& step : model_.steps) {
    if (!plan_step(step)) {
      return bad("step " + std::to_string(&step - model_.steps.data()) + " does not fit");
    }
  }
  for (const std::size_t output : model_.outputs) {
    if (!known_[output]) return bad("nothing makes one of its outputs");
  }
  if (multiplications_ > kMultiplicationsMax) return bad("it takes too long to run");
  net_.values_.resize(model_.tensors.size());
  for (std::size_t index = 0; index < model_.tensors.size(); ++index) {
    Tensor& one = model_.tensors[index];
    net_.values_[index] = std::move(one.values);
    net_.values_[index].resize(known_[index] ? count_of(one.shape) : 0, 0.0F);
  }
  net_.inputs_ = model_.inputs;
  net_.outputs_ = model_.outputs;
  return std::move(net_);
}

bool Net::Planner::plan_step(const Step& step) {
  const std::size_t output = step.outputs[0];
  const bool ready = std::all_of(step.inputs.begin(), step.inputs.end(),
                                 [this](std::size_t input) { return known_[input]; });
  if (!ready || known_[output]) return false;
  multiplications_ += static_cast<double>(count_of(shape(output)));
  if (step.kind == Operator::Dequantize) return dequantize(step);
  Planned planned;
  planned.kind = step.kind;
  planned.inputs = step.inputs;
  planned.output = output;
  planned.activation = step.activation;
  planned.axis = step.axis;
  bool fits = false;
  switch (step.kind) {
    case Operator::Conv2d:
      fits = plan_convolution(step, planned);
      break;
    case Operator::DepthwiseConv2d:
      fits = plan_depthwise(step, planned);
      break;
    case Operator::MaxPool2d:
      fits = shape(output)[3] == shape(step.inputs[0])[3] &&
             plan_window(step, planned, step.filter_height, step.filter_width);
      break;
    case Operator::Add:
    case Operator::Mul:
    case Operator::Prelu:
      fits = plan_repeating(step);
      break;
    case Operator::Relu:
    case Operator::Reshape:
      fits = count_of(shape(output)) == count_of(shape(step.inputs[0]));
      break;
    case Operator::Pad:
      fits = plan_pad(step, planned);
      break;
    case Operator::StridedSlice:
      fits = plan_slice(step, planned);
      break;
    case Operator::Concatenation:
      fits = plan_concatenation(step);
      break;
    case Operator::LandmarksToTransformMatrix:
      fits = plan_region(step, planned);
      break;
    case Operator::TransformTensorBilinear:
    case Operator::TransformLandmarks:
      fits = plan_custom(step, planned);
      break;
    case Operator::Dequantize:
      break;
  }
  if (!fits) return false;
  // A constant whose numbers have gone elsewhere has none.
  for (const std::size_t input : step.inputs) {
    if (tensor(input).constant && tensor(input).values.empty() && tensor(input).integers.empty()) {
      return false;
    }
  }
  known_[output] = true;
  net_.steps_.push_back(std::move(planned));
  return true;
}

/// Weights are 16 bit floats in the file; they are widened when it is read.
bool Net::Planner::dequantize(const Step& step) {
  const std::size_t from = step.inputs[0];
  const std::size_t to = step.outputs[0];
  if (tensor(from).values.empty() || shape(from) != shape(to)) return false;
  model_.tensors[to].values = std::exchange(model_.tensors[from].values, {});
  model_.tensors[to].constant = true;
  known_[to] = true;
  return true;
}

bool Net::Planner::plan_window(const Step& step, Planned& planned, std::size_t height,
                               std::size_t width) {
  const Shape& in = shape(step.inputs[0]);
  const Shape& out = shape(step.outputs[0]);
  KernelWindow& window = planned.window;
  window = {height, width, step.stride_height, step.stride_width, 0, 0};
  if (in[0] != 1 || out[0] != 1 ||
      out[1] != places(in[1], height, window.stride_height, step.same_padding) ||
      out[2] != places(in[2], width, window.stride_width, step.same_padding)) {
    return false;
  }
  if (step.same_padding) {
    window.above = padding_before(in[1], height, window.stride_height, out[1]);
    window.left = padding_before(in[2], width, window.stride_width, out[2]);
  }
  multiplications_ +=
      static_cast<double>(count_of(out)) * static_cast<double>(height) * static_cast<double>(width);
  return true;
}

bool Net::Planner::plan_convolution(const Step& step, Planned& planned) {
  if (step.inputs.size() != 3) return false;
  const Tensor& weights = tensor(step.inputs[1]);
  const Tensor& bias = tensor(step.inputs[2]);
  const Shape& in = shape(step.inputs[0]);
  const Shape& out = shape(step.outputs[0]);
  if (weights.values.empty() || weights.shape[0] != out[3] || weights.shape[3] != in[3] ||
      bias.values.size() != out[3] ||
      !plan_window(step, planned, weights.shape[1], weights.shape[2])) {
    return false;
  }
  const auto weights_of_one = count_of(weights.shape) / out[3];
  multiplications_ += static_cast<double>(count_of(out)) * static_cast<double>(weights_of_one);
  planned.weights = arranged_weights(weights.values, weights.shape);
  planned.bias = bias.values;
  planned.bias.resize(padded_channels(out[3]), 0.0F);
  return true;
}

bool Net::Planner::plan_depthwise(const Step& step, Planned& planned) {
  if (step.inputs.size() != 3 || step.depth_multiplier != 1) return false;
  const Tensor& weights = tensor(step.inputs[1]);
  const Tensor& bias = tensor(step.inputs[2]);
  const Shape& out = shape(step.outputs[0]);
  return !weights.values.empty() && weights.shape[0] == 1 && weights.shape[3] == out[3] &&
         shape(step.inputs[0])[3] == out[3] && bias.values.size() == out[3] &&
         plan_window(step, planned, weights.shape[1], weights.shape[2]);
}

/// The second input repeats along the first.
bool Net::Planner::plan_repeating(const Step& step) const {
  if (step.inputs.size() != 2) return false;
  const Shape& a = shape(step.inputs[0]);
  const Shape& b = shape(step.inputs[1]);
  if (a != shape(step.outputs[0])) return false;
  // It fits from the last dimension on, and is 1 in all that come before.
  std::size_t dimension = 4;
  while (dimension > 0 && a[dimension - 1] == b[dimension - 1]) --dimension;
  return std::all_of(b.begin(), b.begin() + static_cast<std::ptrdiff_t>(dimension),
                     [](std::size_t size) { return size == 1; });
}

bool Net::Planner::plan_pad(const Step& step, Planned& planned) const {
  if (step.inputs.size() != 2) return false;
  const Shape& in = shape(step.inputs[0]);
  const Shape& out = shape(step.outputs[0]);
  const auto& paddings = tensor(step.inputs[1]).integers;
  if (paddings.size() != 8) return false;
  for (std::size_t dimension = 0; dimension < 4; ++dimension) {
    const std::int32_t before = paddings[2 * dimension];
    const std::int32_t behind = paddings[2 * dimension + 1];
    if (before < 0 || behind < 0) return false;
    planned.begin[dimension] = static_cast<std::size_t>(before);
    if (out[dimension] !=
        in[dimension] + planned.begin[dimension] + static_cast<std::size_t>(behind)) {
      return false;
    }
  }
  return true;
}

bool Net::Planner::plan_slice(const Step& step, Planned& planned) const {
  if (step.inputs.size() != 4) return false;
  const Shape& in = shape(step.inputs[0]);
  const Shape& out = shape(step.outputs[0]);
  const auto& begin = tensor(step.inputs[1]).integers;
  const auto& stride = tensor(step.inputs[3]).integers;
  if (begin.size() != 4 || stride.size() != 4) return false;
  for (std::size_t dimension = 0; dimension < 4; ++dimension) {
    const auto most = static_cast<std::int32_t>(in[dimension]);
    if (begin[dimension] < 0 || begin[dimension] >= most || stride[dimension] < 1 ||
        stride[dimension] > most) {
      return false;
    }
    planned.begin[dimension] = static_cast<std::size_t>(begin[dimension]);
    planned.stride[dimension] = static_cast<std::size_t>(stride[dimension]);
    if (planned.begin[dimension] + (out[dimension] - 1) * planned.stride[dimension] >=
        in[dimension]) {
      return false;
    }
  }
  return true;
}

bool Net::Planner::plan_concatenation(const Step& step) const {
  const Shape& out = shape(step.outputs[0]);
  std::size_t along = 0;
  for (const std::size_t input : step.inputs) {
    Shape expected = out;
    expected[step.axis] = shape(input)[step.axis];
    if (shape(input) != expected) return false;
    along += shape(input)[step.axis];
  }
  return along == out[step.axis];
}

bool Net::Planner::plan_region(const Step& step, Planned& planned) const {
  const std::size_t landmarks = count_of(shape(step.inputs[0])) / 3;
  RegionOptions& region = planned.region;
  const auto whole = [&](std::string_view key) {
    return index_in(number_in(step.custom, key).value_or(-1), landmarks);
  };
  const auto above_zero = [&](std::string_view key) {
    const double value = number_in(step.custom, key).value_or(0);
    return value > 0 && value < 1e6 ? value : 0;
  };
  region.left = whole("left_rotation_idx");
  region.right = whole("right_rotation_idx");
  region.target_angle_rad = number_in(step.custom, "target_rotation_radians").value_or(0);
  region.scale_x = above_zero("scale_x");
  region.scale_y = above_zero("scale_y");
  region.width = above_zero("output_width");
  region.height = above_zero("output_height");
  for (const auto& [key, values] : step.custom) {
    if (key != "subset_idxs") continue;
    for (const double value : values) region.landmarks.push_back(index_in(value, landmarks));
  }
  const auto is_one = [landmarks](std::size_t landmark) { return landmark < landmarks; };
  return is_one(region.left) && is_one(region.right) && std::isfinite(region.target_angle_rad) &&
         !region.landmarks.empty() &&
         std::all_of(region.landmarks.begin(), region.landmarks.end(), is_one) &&
         region.scale_x > 0 && region.scale_y > 0 && region.width > 0 && region.height > 0 &&
         count_of(shape(step.outputs[0])) == std::tuple_size_v<Matrix>;
}

bool Net::Planner::plan_custom(const Step& step, Planned&) const {
  if (step.inputs.size() != 2) return false;
  const Shape& in = shape(step.inputs[0]);
  const Shape& out = shape(step.outputs[0]);
  if (count_of(shape(step.inputs[1])) != std::tuple_size_v<Matrix>) return false;
  if (step.kind == Operator::TransformLandmarks) return in == out && in[3] == 2;
  return in[0] == 1 && out[0] == 1 && in[3] == out[3];
}

}  // namespace aucast::mesh

#include "common/mesh/model_file.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

#include "common/text.h"

namespace aucast::mesh {
namespace {

constexpr int kCustom = 32;
constexpr std::size_t kListMax = 100'000;

enum TensorType : std::int8_t { kFloat32 = 0, kFloat16 = 1, kInt32 = 2 };

std::optional<Operator> builtin(int code) {
  constexpr std::array kKnown{Operator::Add,          Operator::Concatenation,
                              Operator::Conv2d,       Operator::DepthwiseConv2d,
                              Operator::Dequantize,   Operator::MaxPool2d,
                              Operator::Mul,          Operator::Relu,
                              Operator::Reshape,      Operator::Pad,
                              Operator::StridedSlice, Operator::Prelu};
  const auto found = std::find_if(kKnown.begin(), kKnown.end(),
                                  [code](Operator one) { return static_cast<int>(one) == code; });
  return found == kKnown.end() ? std::nullopt : std::optional(*found);
}

std::optional<Operator> custom(std::string_view name) {
  if (name == "Landmarks2TransformMatrix") return Operator::LandmarksToTransformMatrix;
  if (name == "TransformTensorBilinear") return Operator::TransformTensorBilinear;
  if (name == "TransformLandmarks") return Operator::TransformLandmarks;
  return std::nullopt;
}

/// Reads the tables of TFLite's schema; fields by their numbers there.
class ModelReader {
 public:
  ModelReader(std::span<const std::uint8_t> bytes, std::string_view file)
      : buffer_(bytes), file_(file) {}

  Result<Model> read() {
    const std::size_t root = buffer_.target(0);
    if (auto read = read_operators(root); !read) return read.error();
    const auto graphs = buffer_.items(root, 2, 4);
    if (graphs.count != 1) return bad("it has not one graph");
    const std::size_t graph = buffer_.target(graphs.begin);
    if (auto read = read_tensors(root, graph); !read) return read.error();
    if (auto read = read_steps(graph); !read) return read.error();
    model_.inputs = indices(graph, 1);
    model_.outputs = indices(graph, 2);
    if (buffer_.broken()) return bad("it is damaged");
    if (outside_) return bad("it names a tensor that it does not have");
    return std::move(model_);
  }

 private:
  [[nodiscard]] Error bad(const std::string& why) const { return unusable_model(file_, why); }

  Result<void> read_operators(std::size_t root) {
    const auto codes = buffer_.items(root, 1, 4);
    if (buffer_.broken() || codes.count > kListMax) return bad("it is damaged");
    for (std::size_t index = 0; index < codes.count; ++index) {
      const std::size_t code = buffer_.target(codes.begin + 4 * index);
      // Small codes stand in an older field of one byte.
      const int number = std::max<int>(buffer_.number<std::int8_t>(code, 0, 0),
                                       buffer_.number<std::int32_t>(code, 3, 0));
      const std::string name = buffer_.text(code, 1);
      const auto kind = number == kCustom ? custom(name) : builtin(number);
      if (buffer_.broken()) return bad("it is damaged");
      if (!kind) return bad("operator " + std::to_string(number) + " is not known here");
      operators_.push_back(*kind);
    }
    return {};
  }

  std::vector<std::size_t> indices(std::size_t table, std::size_t field) {
    std::vector<std::size_t> found;
    for (const std::int32_t index : buffer_.integers(table, field)) {
      outside_ |= index < 0 || static_cast<std::size_t>(index) >= model_.tensors.size();
      found.push_back(outside_ ? 0 : static_cast<std::size_t>(index));
    }
    return found;
  }

  Result<void> read_tensors(std::size_t root, std::size_t graph) {
    const auto tensors = buffer_.items(graph, 0, 4);
    const auto buffers = buffer_.items(root, 4, 4);
    if (buffer_.broken() || tensors.count > kListMax) return bad("it is damaged");
    for (std::size_t index = 0; index < tensors.count; ++index) {
      const std::size_t table = buffer_.target(tensors.begin + 4 * index);
      Tensor tensor;
      if (!read_shape(table, tensor)) return bad("a tensor has a shape that cannot be");
      numbers_ += count_of(tensor.shape);
      if (numbers_ > kModelNumbersMax) return bad("it is too large");
      const auto type = buffer_.number<std::int8_t>(table, 1, 0);
      const auto data = buffer_.number<std::uint32_t>(table, 2, 0);
      if (type != kFloat32 && type != kFloat16 && type != kInt32) {
        return bad("a tensor has a type that is not known here");
      }
      if (data >= buffers.count) return bad("it is damaged");
      const std::size_t source = buffer_.target(buffers.begin + std::size_t{4} * data);
      if (!read_values(buffer_.bytes(source, 0), type, tensor)) {
        return bad("a tensor has not as many numbers as its shape");
      }
      model_.tensors.push_back(std::move(tensor));
    }
    return {};
  }

  bool read_shape(std::size_t table, Tensor& tensor) {
    const auto sizes = buffer_.integers(table, 0);
    tensor.rank = sizes.size();
    if (buffer_.broken() || tensor.rank > tensor.shape.size()) return false;
    std::size_t count = 1;
    for (std::size_t index = 0; index < sizes.size(); ++index) {
      if (sizes[index] < 1 || static_cast<std::size_t>(sizes[index]) > kTensorNumbersMax / count) {
        return false;
      }
      const auto size = static_cast<std::size_t>(sizes[index]);
      count *= size;
      tensor.shape[4 - tensor.rank + index] = size;
    }
    return true;
  }

  static bool read_values(std::span<const std::uint8_t> bytes, std::int8_t type, Tensor& tensor) {
    if (bytes.empty()) return true;
    tensor.constant = true;
    const std::size_t count = count_of(tensor.shape);
    if (bytes.size() != count * (type == kFloat16 ? 2 : 4)) return false;
    if (type == kInt32) {
      tensor.integers.resize(count);
      std::memcpy(tensor.integers.data(), bytes.data(), bytes.size());
      return true;
    }
    tensor.values.resize(count);
    if (type == kFloat32) {
      std::memcpy(tensor.values.data(), bytes.data(), bytes.size());
      return true;
    }
    for (std::size_t index = 0; index < count; ++index) {
      std::uint16_t half = 0;
      std::memcpy(&half, bytes.data() + 2 * index, 2);
      tensor.values[index] = half_to_float(half);
    }
    return true;
  }

  Result<void> read_steps(std::size_t graph) {
    const auto steps = buffer_.items(graph, 3, 4);
    if (buffer_.broken() || steps.count > kListMax) return bad("it is damaged");
    for (std::size_t index = 0; index < steps.count; ++index) {
      const std::size_t table = buffer_.target(steps.begin + 4 * index);
      const auto code = buffer_.number<std::uint32_t>(table, 0, 0);
      if (code >= operators_.size()) return bad("it is damaged");
      Step step;
      step.kind = operators_[code];
      step.inputs = indices(table, 1);
      step.outputs = indices(table, 2);
      if (step.inputs.empty() || step.outputs.size() != 1) return bad("it is damaged");
      if (!read_options(buffer_.table(table, 4), step)) {
        return bad("an operator has options that are not known here");
      }
      if (const auto bytes = buffer_.bytes(table, 5); !bytes.empty()) {
        auto map = read_flex_map(bytes);
        if (!map) return bad("the options of a custom operator are damaged");
        step.custom = std::move(*map);
      }
      model_.steps.push_back(std::move(step));
    }
    return {};
  }

  bool read_options(std::size_t table, Step& step) {
    if (table == FlatBuffer::kNone) return true;
    switch (step.kind) {
      case Operator::Conv2d:
        return read_window(table, step) && read_activation(table, 3, step) && !dilated(table, 4);
      case Operator::DepthwiseConv2d:
        return read_window(table, step) && read_size(table, 3, step.depth_multiplier) &&
               read_activation(table, 4, step) && !dilated(table, 5);
      case Operator::MaxPool2d:
        return read_window(table, step) && read_size(table, 3, step.filter_width) &&
               read_size(table, 4, step.filter_height) && read_activation(table, 5, step);
      case Operator::Add:
      case Operator::Mul:
        return read_activation(table, 0, step);
      case Operator::Concatenation:
        return read_axis(table, step) && read_activation(table, 1, step);
      case Operator::StridedSlice:
        for (std::size_t mask = 0; mask < 5; ++mask) {
          if (buffer_.number<std::int32_t>(table, mask, 0) != 0) return false;
        }
        return true;
      default:
        return true;
    }
  }

  bool read_size(std::size_t table, std::size_t field, std::size_t& size) {
    const auto value = buffer_.number<std::int32_t>(table, field, 1);
    size = static_cast<std::size_t>(std::max(value, 1));
    return value >= 1 && value <= 4096;
  }

  bool read_window(std::size_t table, Step& step) {
    step.same_padding = buffer_.number<std::int8_t>(table, 0, 0) == 0;
    return read_size(table, 1, step.stride_width) && read_size(table, 2, step.stride_height);
  }

  bool dilated(std::size_t table, std::size_t field) {
    return buffer_.number<std::int32_t>(table, field, 1) != 1 ||
           buffer_.number<std::int32_t>(table, field + 1, 1) != 1;
  }

  bool read_activation(std::size_t table, std::size_t field, Step& step) {
    switch (buffer_.number<std::int8_t>(table, field, 0)) {
      case 0:
        step.activation = Activation::None;
        return true;
      case 1:
        step.activation = Activation::Relu;
        return true;
      case 3:
        step.activation = Activation::Relu6;
        return true;
      default:
        return false;
    }
  }

  /// The file counts the dimensions that it names; we count all four.
  bool read_axis(std::size_t table, Step& step) {
    if (outside_) return true;
    const auto rank = static_cast<std::int32_t>(model_.tensors[step.outputs[0]].rank);
    std::int32_t axis = buffer_.number<std::int32_t>(table, 0, 0);
    if (axis < 0) axis += rank;
    if (axis < 0 || axis >= rank) return false;
    step.axis = static_cast<std::size_t>(4 - rank + axis);
    return true;
  }

  FlatBuffer buffer_;
  std::string file_;
  Model model_;
  std::vector<Operator> operators_;
  std::size_t numbers_ = 0;
  bool outside_ = false;
};

}  // namespace

std::size_t count_of(const Shape& shape) {
  return std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>());
}

Error unusable_model(std::string_view file, std::string_view why) {
  return {ErrorKind::BadData, at_place(file, "not a model that can be used: " + std::string(why))};
}

Result<Model> read_model(std::span<const std::uint8_t> bytes, std::string_view file) {
  constexpr std::string_view kMark = "TFL3";
  if (bytes.size() < 8 || !std::equal(kMark.begin(), kMark.end(), bytes.begin() + 4)) {
    return unusable_model(file, "it is no TFLite file");
  }
  return ModelReader(bytes, file).read();
}

}  // namespace aucast::mesh

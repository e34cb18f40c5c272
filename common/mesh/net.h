#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "common/mesh/model_file.h"
#include "common/mesh/operators.h"
#include "common/result.h"

namespace aucast::mesh {

/// A net that can be run: a model whose shapes were checked, with the values of all tensors.
/// Nothing is allocated while it runs. Thread: any, but one at a time.
class Net {
 public:
  /// Fails with BadData and a message that begins with `file` if the bytes are no model
  /// (read_model()), if its shapes do not fit each other, or if one picture would take more
  /// multiplications than kMultiplicationsMax.
  [[nodiscard]] static Result<Net> make(std::span<const std::uint8_t> bytes, std::string_view file);

  static constexpr double kMultiplicationsMax = 2e9;

  /// Fill this before run(): the values of the net's input.
  [[nodiscard]] std::span<float> input() { return values_[inputs_[0]]; }
  [[nodiscard]] const Shape& input_shape() const { return shapes_[inputs_[0]]; }
  void run();
  [[nodiscard]] std::size_t outputs() const { return outputs_.size(); }
  /// The values of an output after run().
  [[nodiscard]] std::span<const float> output(std::size_t index) const {
    return values_[outputs_[index]];
  }

 private:
  /// A step with everything that can be computed before it runs.
  struct Planned {
    Operator kind = Operator::Add;
    std::vector<std::size_t> inputs;
    std::size_t output = 0;
    KernelWindow window;
    Activation activation = Activation::None;
    std::vector<float> weights;  ///< of a convolution, as arranged_weights() orders them
    std::vector<float> bias;
    std::size_t axis = 0;
    Shape begin{};  ///< of a slice: where it begins; of a padding: how many zeros come before
    Shape stride{};
    RegionOptions region;
  };
  class Planner;

  Net() = default;
  void run(const Planned& step);
  [[nodiscard]] Matrix matrix_of(std::size_t tensor) const;

  std::vector<Shape> shapes_;
  std::vector<std::vector<float>> values_;
  std::vector<Planned> steps_;
  std::vector<std::size_t> inputs_;
  std::vector<std::size_t> outputs_;
};

}  // namespace aucast::mesh

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "common/mesh/net.h"

namespace aucast::mesh {

/// Checks that the steps of a model fit its tensors and prepares what does not change from picture
/// to picture. Used once for each net.
class Net::Planner {
 public:
  Planner(Model model, std::string_view file) : model_(std::move(model)), file_(file) {}

  [[nodiscard]] Result<Net> plan();

 private:
  /// Each of these plans one step and returns whether the step fits.
  [[nodiscard]] bool plan_step(const Step& step);
  [[nodiscard]] bool plan_convolution(const Step& step, Planned& planned);
  [[nodiscard]] bool plan_depthwise(const Step& step, Planned& planned);
  [[nodiscard]] bool plan_window(const Step& step, Planned& planned, std::size_t height,
                                 std::size_t width);
  [[nodiscard]] bool plan_repeating(const Step& step) const;
  [[nodiscard]] bool plan_pad(const Step& step, Planned& planned) const;
  [[nodiscard]] bool plan_slice(const Step& step, Planned& planned) const;
  [[nodiscard]] bool plan_concatenation(const Step& step) const;
  [[nodiscard]] bool plan_region(const Step& step, Planned& planned) const;
  [[nodiscard]] bool plan_custom(const Step& step, Planned& planned) const;
  [[nodiscard]] bool dequantize(const Step& step);

  [[nodiscard]] const Tensor& tensor(std::size_t index) const { return model_.tensors[index]; }
  [[nodiscard]] const Shape& shape(std::size_t index) const { return tensor(index).shape; }
  [[nodiscard]] Error bad(const std::string& why) const;

  Model model_;
  std::string file_;
  Net net_;
  std::vector<bool> known_;  ///< which tensors have values before the next step runs
  double multiplications_ = 0;
};

}  // namespace aucast::mesh

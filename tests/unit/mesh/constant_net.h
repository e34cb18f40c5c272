#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "tests/support/small_model.h"

namespace aucast::test {

/// The file of a net that gives the same `outputs` for every picture; pictures are `side` pixels
/// wide and high.
inline std::string constant_net(std::int32_t side, const std::vector<std::vector<float>>& outputs) {
  const auto tensor = [](std::vector<std::int32_t> shape, std::int32_t buffer) {
    return FlatTable().integers(0, std::move(shape)).byte(1, 0).number(2, buffer);
  };
  std::vector<FlatTable> tensors{tensor({1, side, side, 3}, 0)};
  std::vector<FlatTable> buffers{FlatTable()};
  std::vector<std::int32_t> numbers;
  for (const std::vector<float>& output : outputs) {
    const auto number = static_cast<std::int32_t>(tensors.size());
    std::string bytes(4 * output.size(), '\0');
    std::memcpy(bytes.data(), output.data(), bytes.size());
    buffers.push_back(FlatTable().bytes(0, std::move(bytes)));
    tensors.push_back(tensor({static_cast<std::int32_t>(output.size())}, number));
    numbers.push_back(number);
  }
  return FlatTable()
      .tables(2, {FlatTable().tables(0, tensors).integers(1, {0}).integers(2, numbers)})
      .tables(4, buffers)
      .file();
}

/// The outputs of a MediaPipe detector. It looks for faces from 16x16 places twice each, then from
/// 8x8 places six times each; each look gives a score and 16 numbers.
struct FaceBoxes {
  static constexpr std::size_t kLooks = 16 * 16 * 2 + 8 * 8 * 6;
  static constexpr std::size_t kEach = 16;
  static constexpr float kPixels = 128;  ///< side of the picture that it sees

  std::vector<float> boxes = std::vector<float>(kLooks * kEach, 0.0F);
  std::vector<float> scores = std::vector<float>(kLooks, -20.0F);
  std::int32_t side = 128;

  [[nodiscard]] static std::size_t fine(std::size_t column, std::size_t row) {
    return 2 * (16 * row + column);
  }
  [[nodiscard]] static std::size_t coarse(std::size_t column, std::size_t row) {
    return 16 * 16 * 2 + 6 * (8 * row + column);
  }

  /// Look `look` finds a face `size` pixels wide and high, whose middle is `x`, `y` from the look's
  /// place. `eyes`: how much lower the left eye is than the right one, which is 10 pixels away.
  void sees(std::size_t look, float score, float size, float x = 0, float y = 0, float eyes = 0) {
    scores[look] = score;
    float* const numbers = &boxes[look * kEach];
    numbers[0] = x;
    numbers[1] = y;
    numbers[2] = numbers[3] = size;
    numbers[6] = 10;
    numbers[7] = eyes;
  }
  [[nodiscard]] std::string file() const { return constant_net(side, {boxes, scores}); }
};

/// The outputs of MediaPipe's face mesh with attention, in pixels of its input of 192 by 192.
struct FacePoints {
  std::vector<float> mesh = std::vector<float>(3 * 468, 96.0F);  ///< x, y, z of each point
  std::vector<float> lips = std::vector<float>(2 * 80, 96.0F);
  std::vector<float> right_eye = std::vector<float>(2 * 71, 96.0F);
  std::vector<float> left_eye = std::vector<float>(2 * 71, 96.0F);
  std::vector<float> right_iris = std::vector<float>(2 * 5, 96.0F);
  std::vector<float> left_iris = std::vector<float>(2 * 5, 96.0F);
  std::vector<float> presence{20.0F};
  std::int32_t side = 192;

  void put(std::size_t point, float x, float y, float z) {
    mesh[3 * point] = x;
    mesh[3 * point + 1] = y;
    mesh[3 * point + 2] = z;
  }
  [[nodiscard]] std::string file() const {
    return constant_net(side, {mesh, lips, right_eye, left_eye, right_iris, left_iris, presence});
  }
};

}  // namespace aucast::test

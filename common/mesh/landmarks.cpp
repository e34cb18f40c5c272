#include "common/mesh/landmarks.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "common/mesh/model_file.h"

namespace aucast::mesh {
namespace {

constexpr std::size_t kMeshSide = 192;
constexpr double kMeshMargin = 1.5;  ///< the next square's side, in boxes around the landmarks
constexpr std::size_t kRightEyeOuter = 33;
constexpr std::size_t kLeftEyeOuter = 263;

// What the net's outputs are: the whole face, then parts of it seen from nearby, which replace x
// and y of these landmarks. Right is the subject's own.
enum Output : std::uint8_t {
  kMesh,
  kLips,
  kRightEye,
  kLeftEye,
  kRightIrisOut,
  kLeftIrisOut,
  kFlag
};
constexpr std::array<std::uint16_t, 80> kLipPoints{
    61, 146, 91, 181, 84, 17, 314, 405, 321, 375, 291, 185, 40, 39, 37, 0,  267, 269, 270, 409,
    78, 95,  88, 178, 87, 14, 317, 402, 318, 324, 308, 191, 80, 81, 82, 13, 312, 311, 310, 415,
    76, 77,  90, 180, 85, 16, 315, 404, 320, 307, 306, 184, 74, 73, 72, 11, 302, 303, 304, 408,
    62, 96,  89, 179, 86, 15, 316, 403, 319, 325, 292, 183, 42, 41, 38, 12, 268, 271, 272, 407};
constexpr std::array<std::uint16_t, 71> kRightEyePoints{
    33,  7,   163, 144, 145, 153, 154, 155, 133, 246, 161, 160, 159, 158, 157, 173, 130, 25,
    110, 24,  23,  22,  26,  112, 243, 247, 30,  29,  27,  28,  56,  190, 226, 31,  228, 229,
    230, 231, 232, 233, 244, 113, 225, 224, 223, 222, 221, 189, 35,  124, 46,  53,  52,  65,
    143, 111, 117, 118, 119, 120, 121, 128, 245, 156, 70,  63,  105, 66,  107, 55,  193};
constexpr std::array<std::uint16_t, 71> kLeftEyePoints{
    263, 249, 390, 373, 374, 380, 381, 382, 362, 466, 388, 387, 386, 385, 384, 398, 359, 255,
    339, 254, 253, 252, 256, 341, 463, 467, 260, 259, 257, 258, 286, 414, 446, 261, 448, 449,
    450, 451, 452, 453, 464, 342, 445, 444, 443, 442, 441, 413, 265, 353, 276, 283, 282, 295,
    372, 340, 346, 347, 348, 349, 350, 357, 465, 383, 300, 293, 334, 296, 336, 285, 417};
/// The lids come first among an eye's points; an iris lies as deep as they do.
constexpr std::size_t kLidPoints = 16;

template <std::size_t kCount>
void refine(Landmarks& landmarks, const std::array<std::uint16_t, kCount>& points,
            std::span<const float> numbers) {
  for (std::size_t index = 0; index < kCount; ++index) {
    landmarks.points[points[index]].x = double{numbers[2 * index]};
    landmarks.points[points[index]].y = double{numbers[2 * index + 1]};
  }
}

void add_iris(Landmarks& landmarks, std::size_t first, std::span<const float> numbers,
              std::span<const std::uint16_t> eye) {
  double depth = 0;
  for (const std::uint16_t point : eye.first(kLidPoints)) depth += landmarks.points[point].z;
  for (std::size_t index = 0; index < kIrisPoints; ++index) {
    landmarks.points[first + index] = {double{numbers[2 * index]}, double{numbers[2 * index + 1]},
                                       depth / static_cast<double>(kLidPoints)};
  }
}

/// From places in the square to places in the picture.
void put_into_picture(Landmarks& landmarks, const Square& square) {
  const double step = square.side / static_cast<double>(kMeshSide);
  const double cosine = std::cos(square.turn_rad) * step;
  const double sine = std::sin(square.turn_rad) * step;
  for (Point& point : landmarks.points) {
    const double u = point.x - kMeshSide / 2.0;
    const double v = point.y - kMeshSide / 2.0;
    point = {square.x + cosine * u - sine * v, square.y + sine * u + cosine * v, point.z * step};
  }
}

}  // namespace

Result<LandmarkFinder> LandmarkFinder::make(std::span<const std::uint8_t> bytes,
                                            std::string_view file) {
  auto net = Net::make(bytes, file);
  if (!net) return net.error();
  const Shape expected{1, kMeshSide, kMeshSide, 3};
  constexpr std::array<std::size_t, 7> kSizes{3 * kFacePoints,
                                              2 * kLipPoints.size(),
                                              2 * kRightEyePoints.size(),
                                              2 * kLeftEyePoints.size(),
                                              2 * kIrisPoints,
                                              2 * kIrisPoints,
                                              1};
  bool fits = net->input_shape() == expected && net->outputs() == kSizes.size();
  for (std::size_t index = 0; fits && index < kSizes.size(); ++index) {
    fits = net->output(index).size() == kSizes[index];
  }
  if (!fits) {
    return unusable_model(file, "it is not MediaPipe's face mesh with attention");
  }
  return LandmarkFinder(std::move(*net));
}

Landmarks LandmarkFinder::find(const Picture& picture, const Square& square) {
  sample_square(picture, square, kMeshSide, 0, 1, net_.input());
  net_.run();
  Landmarks landmarks;
  const auto mesh = net_.output(kMesh);
  for (std::size_t index = 0; index < kFacePoints; ++index) {
    landmarks.points[index] = {double{mesh[3 * index]}, double{mesh[3 * index + 1]},
                               double{mesh[3 * index + 2]}};
  }
  refine(landmarks, kLipPoints, net_.output(kLips));
  refine(landmarks, kRightEyePoints, net_.output(kRightEye));
  refine(landmarks, kLeftEyePoints, net_.output(kLeftEye));
  add_iris(landmarks, kRightIris, net_.output(kRightIrisOut), kRightEyePoints);
  add_iris(landmarks, kLeftIris, net_.output(kLeftIrisOut), kLeftEyePoints);
  landmarks.presence = 1 / (1 + std::exp(-double{net_.output(kFlag)[0]}));
  put_into_picture(landmarks, square);
  return landmarks;
}

Square square_around(const Landmarks& landmarks) {
  const auto face = std::span(landmarks.points).first(kFacePoints);
  const auto [left, right] = std::minmax_element(
      face.begin(), face.end(), [](const Point& a, const Point& b) { return a.x < b.x; });
  const auto [top, bottom] = std::minmax_element(
      face.begin(), face.end(), [](const Point& a, const Point& b) { return a.y < b.y; });
  const Point& a = landmarks.points[kRightEyeOuter];
  const Point& b = landmarks.points[kLeftEyeOuter];
  return {(left->x + right->x) / 2, (top->y + bottom->y) / 2,
          kMeshMargin * std::max(right->x - left->x, bottom->y - top->y),
          std::atan2(b.y - a.y, b.x - a.x)};
}

}  // namespace aucast::mesh

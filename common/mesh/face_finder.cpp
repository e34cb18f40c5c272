#include "common/mesh/face_finder.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "common/mesh/model_file.h"

namespace aucast::mesh {
namespace {

constexpr std::size_t kFinderSide = 128;
/// The net looks from 16x16 places, twice from each, and from 8x8, six times from each.
constexpr std::size_t kFinePlaces = 16;
constexpr std::size_t kFineEach = 2;
constexpr std::size_t kCoarsePlaces = 8;
constexpr std::size_t kCoarseEach = 6;
constexpr std::size_t kFine = kFinePlaces * kFinePlaces * kFineEach;
constexpr std::size_t kLooks = kFine + kCoarsePlaces * kCoarsePlaces * kCoarseEach;
/// A box (x, y, width, height) and six points of the face: right eye, left eye, ...
constexpr std::size_t kNumbers = 16;
constexpr double kFinderMargin = 1.5;  ///< the square's side, in boxes

struct Centre {
  double x;
  double y;
};

/// Where the net looked from, as a part of the picture's side.
Centre centre_of(std::size_t look) {
  const bool fine = look < kFine;
  const std::size_t index = fine ? look / kFineEach : (look - kFine) / kCoarseEach;
  const std::size_t side = fine ? kFinePlaces : kCoarsePlaces;
  const auto part = [side](std::size_t number) {
    return (static_cast<double>(number) + 0.5) / static_cast<double>(side);
  };
  return {part(index % side), part(index / side)};
}

}  // namespace

Result<FaceFinder> FaceFinder::make(std::span<const std::uint8_t> bytes, std::string_view file) {
  auto net = Net::make(bytes, file);
  if (!net) return net.error();
  const Shape expected{1, kFinderSide, kFinderSide, 3};
  if (net->input_shape() != expected || net->outputs() != 2 ||
      net->output(0).size() != kLooks * kNumbers || net->output(1).size() != kLooks) {
    return unusable_model(file, "it is not MediaPipe's face detector");
  }
  return FaceFinder(std::move(*net));
}

Square FaceFinder::square_of(const Picture& picture, std::size_t look) const {
  const double middle_x = static_cast<double>(picture.width) / 2;
  const double middle_y = static_cast<double>(picture.height) / 2;
  const double side = static_cast<double>(std::max(picture.width, picture.height));
  const Centre from = centre_of(look);
  const auto numbers = net_.output(0).subspan(look * kNumbers, kNumbers);
  const auto part = [&](std::size_t index) { return double{numbers[index]} / kFinderSide; };
  const auto x = [&](std::size_t index) { return (part(index) + from.x - 0.5) * side + middle_x; };
  const auto y = [&](std::size_t index) { return (part(index) + from.y - 0.5) * side + middle_y; };
  return {x(0), y(1), kFinderMargin * std::max(part(2), part(3)) * side,
          std::atan2(y(7) - y(5), x(6) - x(4))};
}

std::vector<Square> FaceFinder::find(const Picture& picture, std::size_t most) {
  const double side = static_cast<double>(std::max(picture.width, picture.height));
  sample_square(
      picture,
      {static_cast<double>(picture.width) / 2, static_cast<double>(picture.height) / 2, side, 0},
      kFinderSide, -1, 1, net_.input());
  net_.run();
  const auto scores = net_.output(1);
  std::vector<std::size_t> sure;
  for (std::size_t look = 0; look < scores.size(); ++look) {
    if (1 / (1 + std::exp(-scores[look])) >= kSureMin) sure.push_back(look);
  }
  std::stable_sort(sure.begin(), sure.end(),
                   [&](std::size_t a, std::size_t b) { return scores[a] > scores[b]; });
  std::vector<Square> faces;
  for (const std::size_t look : sure) {
    if (faces.size() == most) break;
    const Square square = square_of(picture, look);
    // The net sees each face from several places.
    const auto seen = [&square](const Square& face) { return show_the_same(face, square); };
    if (!can_be_seen(square) || std::any_of(faces.begin(), faces.end(), seen)) continue;
    faces.push_back(square);
  }
  return faces;
}

}  // namespace aucast::mesh

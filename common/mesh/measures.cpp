#include "common/mesh/measures.h"

#include <cmath>
#include <initializer_list>

namespace aucast::mesh {
namespace {

using Points = std::array<Point, kLandmarks>;
using Group = std::initializer_list<std::size_t>;

double mean_x(const Points& points, Group group) {
  double sum = 0;
  for (const std::size_t index : group) sum += points[index].x;
  return sum / static_cast<double>(group.size());
}
double mean_y(const Points& points, Group group) {
  double sum = 0;
  for (const std::size_t index : group) sum += points[index].y;
  return sum / static_cast<double>(group.size());
}
double mean_z(const Points& points, Group group) {
  double sum = 0;
  for (const std::size_t index : group) sum += points[index].z;
  return sum / static_cast<double>(group.size());
}

/// The landmarks of one side.
struct Side {
  double out;  ///< which way x grows away from the middle of the face
  Group brow_inner, brow_middle, brow_outer, upper_lid, lower_lid, nose_wing, cheek, puff,
      nasolabial;
  std::size_t corner, inner_canthus, outer_canthus, iris;
};

std::array<double, kSideMeasures> measure_side(const Points& p, const Side& side) {
  const Point& inner = p[side.inner_canthus];
  const Point& outer = p[side.outer_canthus];
  const double eye_width = std::max(std::hypot(inner.x - outer.x, inner.y - outer.y), 1e-6);
  const double upper_lid = mean_y(p, side.upper_lid);
  const double lower_lid = mean_y(p, side.lower_lid);
  const Point& iris = p[side.iris];
  return {-mean_y(p, side.brow_inner),
          -mean_y(p, side.brow_middle),
          -mean_y(p, side.brow_outer),
          side.out * mean_x(p, side.brow_inner),
          (lower_lid - upper_lid) / eye_width,
          -upper_lid,
          -lower_lid,
          -p[side.corner].y,
          side.out * p[side.corner].x,
          -p[side.corner].z,
          -mean_y(p, side.nose_wing),
          side.out * mean_x(p, side.nose_wing),
          -mean_y(p, side.cheek),
          side.out * mean_x(p, side.puff),
          -mean_z(p, side.puff),
          -mean_y(p, side.nasolabial),
          2 * (iris.x - (inner.x + outer.x) / 2) / eye_width,
          -2 * (iris.y - (inner.y + outer.y) / 2) / eye_width};
}

std::array<double, kMiddleMeasures> measure_middle(const Points& p) {
  const Group upper_lip_rim{13, 82, 312};
  const Group lower_lip_rim{14, 87, 317};
  const Group upper_lip_edge{0, 37, 267};
  const Group lower_lip_edge{17, 84, 314};
  const double upper_rim = mean_y(p, upper_lip_rim);
  const double lower_rim = mean_y(p, lower_lip_rim);
  const double upper_edge = mean_y(p, upper_lip_edge);
  const double lower_edge = mean_y(p, lower_lip_edge);
  return {p[285].x - p[55].x,
          p[291].x - p[61].x,
          lower_rim - upper_rim,
          upper_rim - upper_edge,
          lower_edge - lower_rim,
          lower_edge - upper_edge,
          -mean_y(p, {0, 37, 267, 39, 269}),
          -mean_y(p, {17, 84, 314, 181, 405}),
          -mean_y(p, {152, 148, 377, 175}),
          -mean_y(p, {200, 199, 201, 421}),
          -mean_z(p, {0, 13, 14, 17, 37, 267, 84, 314}),
          -mean_y(p, {1, 4}),
          mean_x(p, {13, 14, 0, 17}),
          -mean_y(p, {33, 263}),
          -mean_y(p, {133, 362}),
          -p[168].y,
          -p[6].y,
          -p[197].y,
          -p[195].y,
          -p[5].y,
          -p[4].y,
          -p[1].y,
          -p[19].y,
          -p[94].y,
          -p[2].y,
          -mean_y(p, {162, 389}),
          -mean_y(p, {127, 356}),
          -mean_y(p, {234, 454}),
          -mean_y(p, {93, 323})};
}

}  // namespace

Measures measure(const FittedHead& head) {
  Measures measures;
  measures.turn = head.turn;
  measures.scale = head.scale;
  // A picture shows the subject's right side on the left.
  measures.right = measure_side(head.points, {-1,
                                              {107, 55, 66, 65},
                                              {105, 52},
                                              {70, 46, 63, 53},
                                              {159, 158, 160},
                                              {145, 153, 144},
                                              {129, 98, 64, 48},
                                              {50, 117, 118, 101, 36},
                                              {187, 207, 205, 50},
                                              {206, 203, 205},
                                              61,
                                              133,
                                              33,
                                              kRightIris});
  measures.left = measure_side(head.points, {1,
                                             {336, 285, 296, 295},
                                             {334, 282},
                                             {300, 276, 293, 283},
                                             {386, 385, 387},
                                             {374, 380, 373},
                                             {358, 327, 294, 278},
                                             {280, 346, 347, 330, 266},
                                             {411, 427, 425, 280},
                                             {426, 423, 425},
                                             291,
                                             362,
                                             263,
                                             kLeftIris});
  measures.middle = measure_middle(head.points);
  return measures;
}

const std::array<std::string_view, kSideMeasures>& side_measure_names() {
  static constexpr std::array<std::string_view, kSideMeasures> kNames{
      "brow-inner-up", "brow-middle-up", "brow-outer-up", "brow-inner-out", "aperture",
      "upper-lid-up",  "lower-lid-up",   "corner-up",     "corner-out",     "corner-front",
      "nose-wing-up",  "nose-wing-out",  "cheek-up",      "cheek-out",      "cheek-front",
      "nasolabial-up", "gaze-left",      "gaze-up"};
  return kNames;
}

const std::array<std::string_view, kMiddleMeasures>& middle_measure_names() {
  static constexpr std::array<std::string_view, kMiddleMeasures> kNames{"brow-gap",
                                                                        "mouth-width",
                                                                        "lip-gap",
                                                                        "upper-lip-height",
                                                                        "lower-lip-height",
                                                                        "lips-height",
                                                                        "upper-lip-up",
                                                                        "lower-lip-up",
                                                                        "chin-up",
                                                                        "chin-boss-up",
                                                                        "lips-front",
                                                                        "nose-tip-up",
                                                                        "mouth-left",
                                                                        "still-outer-eye-up",
                                                                        "still-inner-eye-up",
                                                                        "still-bridge-top-up",
                                                                        "still-bridge-high-up",
                                                                        "still-bridge-middle-up",
                                                                        "still-bridge-low-up",
                                                                        "still-ridge-up",
                                                                        "still-tip-up",
                                                                        "still-tip-low-up",
                                                                        "still-tip-under-up",
                                                                        "still-septum-up",
                                                                        "still-nose-base-up",
                                                                        "still-temple-high-up",
                                                                        "still-temple-up",
                                                                        "still-ear-up",
                                                                        "still-jaw-hinge-up"};
  return kNames;
}

}  // namespace aucast::mesh

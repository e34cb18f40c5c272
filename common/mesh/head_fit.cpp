#include "common/mesh/head_fit.h"

#include <algorithm>
#include <cmath>

namespace aucast::mesh {
namespace {

using Matrix3 = std::array<std::array<double, 3>, 3>;
using Matrix4 = std::array<std::array<double, 4>, 4>;

/// The eigenvector of the largest eigenvalue of a symmetric matrix (Jacobi's rotations).
std::array<double, 4> largest_eigenvector(Matrix4 a) {
  Matrix4 vectors{};
  for (std::size_t i = 0; i < 4; ++i) vectors[i][i] = 1;
  for (int sweep = 0; sweep < 30; ++sweep) {
    for (std::size_t p = 0; p < 4; ++p) {
      for (std::size_t q = p + 1; q < 4; ++q) {
        if (std::abs(a[p][q]) < 1e-15) continue;
        const double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
        const double sign = theta < 0 ? -1 : 1;
        const double tangent = sign / (std::abs(theta) + std::sqrt(theta * theta + 1));
        const double c = 1 / std::sqrt(tangent * tangent + 1);
        const double s = tangent * c;
        const auto turn = [c, s](double& x, double& y) {
          const double before = x;
          x = c * before - s * y;
          y = s * before + c * y;
        };
        for (std::size_t k = 0; k < 4; ++k) turn(a[k][p], a[k][q]);
        for (std::size_t k = 0; k < 4; ++k) turn(a[p][k], a[q][k]);
        for (std::size_t k = 0; k < 4; ++k) turn(vectors[k][p], vectors[k][q]);
      }
    }
  }
  std::size_t best = 0;
  for (std::size_t i = 1; i < 4; ++i) {
    if (a[i][i] > a[best][best]) best = i;
  }
  return {vectors[0][best], vectors[1][best], vectors[2][best], vectors[3][best]};
}

Matrix3 rotation_of(const std::array<double, 4>& quaternion) {
  const auto [w, x, y, z] = quaternion;
  return {{{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
           {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
           {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}}};
}

Point middle_of(const StillPoints& points) {
  Point middle;
  for (const Point& point : points) {
    middle.x += point.x / static_cast<double>(points.size());
    middle.y += point.y / static_cast<double>(points.size());
    middle.z += point.z / static_cast<double>(points.size());
  }
  return middle;
}

std::array<double, 3> from(const Point& origin, const Point& point) {
  return {point.x - origin.x, point.y - origin.y, point.z - origin.z};
}

/// How the head is turned, from the rotation that takes its turn back.
HeadTurn turn_of(const Matrix3& back) {
  // The head's own rotation is the inverse, which is the transposed matrix.
  const double yaw = std::asin(std::clamp(back[2][0], -1.0, 1.0));
  const double pitch = std::atan2(-back[2][1], back[2][2]);
  const double roll = std::atan2(-back[1][0], back[0][0]);
  return {-yaw, -pitch, roll};
}

}  // namespace

FittedHead fit_head(const Landmarks& landmarks, const StillPoints& onto) {
  StillPoints ours;
  for (std::size_t i = 0; i < ours.size(); ++i) ours[i] = landmarks.points[kStillLandmarks[i]];
  const Point our_middle = middle_of(ours);
  const Point their_middle = middle_of(onto);
  Matrix3 s{};
  double our_size = 0;
  double their_size = 0;
  for (std::size_t i = 0; i < ours.size(); ++i) {
    const auto a = from(our_middle, ours[i]);
    const auto b = from(their_middle, onto[i]);
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t column = 0; column < 3; ++column) s[row][column] += a[row] * b[column];
      our_size += a[row] * a[row];
      their_size += b[row] * b[row];
    }
  }
  const Matrix4 n{
      {{s[0][0] + s[1][1] + s[2][2], s[1][2] - s[2][1], s[2][0] - s[0][2], s[0][1] - s[1][0]},
       {s[1][2] - s[2][1], s[0][0] - s[1][1] - s[2][2], s[0][1] + s[1][0], s[2][0] + s[0][2]},
       {s[2][0] - s[0][2], s[0][1] + s[1][0], -s[0][0] + s[1][1] - s[2][2], s[1][2] + s[2][1]},
       {s[0][1] - s[1][0], s[2][0] + s[0][2], s[1][2] + s[2][1], -s[0][0] - s[1][1] + s[2][2]}}};
  const Matrix3 back = rotation_of(largest_eigenvector(n));
  const double scale = our_size > 0 ? std::sqrt(their_size / our_size) : 1;
  FittedHead fitted;
  fitted.turn = turn_of(back);
  fitted.scale = 1 / scale;
  for (std::size_t i = 0; i < kLandmarks; ++i) {
    const auto p = from(our_middle, landmarks.points[i]);
    const auto along = [&](std::size_t row) {
      return scale * (back[row][0] * p[0] + back[row][1] * p[1] + back[row][2] * p[2]);
    };
    fitted.points[i] = {along(0) + their_middle.x, along(1) + their_middle.y,
                        along(2) + their_middle.z};
  }
  return fitted;
}

}  // namespace aucast::mesh

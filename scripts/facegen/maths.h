#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>
#include <type_traits>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace aucast::facegen {

// Everything is computed in double precision and without fast-math. So the results of two compilers
// differ by far less than the 1e-4 that the test of the committed head allows.

using Vec3 = glm::dvec3;

inline constexpr double kPi = std::numbers::pi;

[[nodiscard]] inline double radians(double degrees) {
  return degrees * kPi / 180;
}

[[nodiscard]] inline double saturate(double x) {
  return std::clamp(x, 0.0, 1.0);
}

[[nodiscard]] inline double mix(double a, double b, double t) {
  return a + (b - a) * t;
}
[[nodiscard]] inline Vec3 mix(const Vec3& a, const Vec3& b, double t) {
  return a + (b - a) * t;
}

/// 0 before `from`, 1 beyond `to`, an S curve between them; `from` may be the larger one.
[[nodiscard]] inline double smooth_step(double from, double to, double x) {
  const double t = saturate((x - from) / (to - from));
  return t * t * (3 - 2 * t);
}

/// 1 at 0, 1/e at `width`.
[[nodiscard]] inline double bell(double x, double width) {
  return std::exp(-(x / width) * (x / width));
}

/// The same for a vector whose components were divided by their widths.
[[nodiscard]] inline double bell(const Vec3& scaled) {
  return std::exp(-glm::dot(scaled, scaled));
}

/// A power that is 0, not NaN, for the tiny negative bases to which rounding leads at the ends of
/// curves.
[[nodiscard]] inline double power(double base, double exponent) {
  return base < 1e-7 ? 0.0 : std::pow(base, exponent);
}

[[nodiscard]] inline Vec3 rotated_x(const Vec3& p, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {p.x, c * p.y - s * p.z, s * p.y + c * p.z};
}

[[nodiscard]] inline Vec3 rotated_y(const Vec3& p, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {c * p.x + s * p.z, p.y, -s * p.x + c * p.z};
}

/// One point of a curve through given values.
template <typename T>
struct Key {
  double at = 0;
  T value{};
};

/// Cubic Hermite through `count` values (at least two) that `value(i)` gives, at the ascending
/// places `at(i)`; the slope at a value is that between its neighbours. Constant beyond both ends.
template <typename At, typename Value>
[[nodiscard]] auto curve_through(std::size_t count, const At& at, const Value& value,
                                 double where) {
  using T = std::decay_t<decltype(value(0))>;
  const std::size_t last = count - 1;
  if (where <= at(0)) return T{value(0)};
  if (where >= at(last)) return T{value(last)};
  std::size_t i = 0;
  while (where > at(i + 1)) ++i;
  const auto slope = [&](std::size_t j) {
    const std::size_t a = j == 0 ? 0 : j - 1;
    const std::size_t b = j == last ? last : j + 1;
    return (value(b) - value(a)) * (1 / (at(b) - at(a)));
  };
  const double h = at(i + 1) - at(i);
  const double t = (where - at(i)) / h;
  const double t2 = t * t;
  const double t3 = t2 * t;
  return T{value(i) * (2 * t3 - 3 * t2 + 1) + slope(i) * (h * (t3 - 2 * t2 + t)) +
           value(i + 1) * (3 * t2 - 2 * t3) + slope(i + 1) * (h * (t3 - t2))};
}

/// The curve through the keys (ascending `at`, at least two).
template <typename T>
[[nodiscard]] T sample(std::span<const Key<T>> keys, double at) {
  return curve_through(
      keys.size(), [&](std::size_t i) { return keys[i].at; },
      [&](std::size_t i) { return keys[i].value; }, at);
}

/// A fixed pseudo-random number in [0, 1) for an integer.
[[nodiscard]] inline double hash(std::int64_t n) {
  auto x = static_cast<std::uint32_t>(n) * 747796405U + 2891336453U;
  x = ((x >> ((x >> 28U) + 4U)) ^ x) * 277803737U;
  x = (x >> 22U) ^ x;
  return x / 4294967296.0;
}

/// Smooth noise in [0, 1) with features of size 1.
[[nodiscard]] inline double value_noise(const Vec3& p) {
  const Vec3 cell{std::floor(p.x), std::floor(p.y), std::floor(p.z)};
  const Vec3 f{smooth_step(0, 1, p.x - cell.x), smooth_step(0, 1, p.y - cell.y),
               smooth_step(0, 1, p.z - cell.z)};
  const auto corner = [&](int dx, int dy, int dz) {
    return hash((static_cast<std::int64_t>(cell.x) + dx) * 73856 +
                (static_cast<std::int64_t>(cell.y) + dy) * 19349663 +
                (static_cast<std::int64_t>(cell.z) + dz) * 83492791);
  };
  const auto layer = [&](int dz) {
    return mix(mix(corner(0, 0, dz), corner(1, 0, dz), f.x),
               mix(corner(0, 1, dz), corner(1, 1, dz), f.x), f.y);
  };
  return mix(layer(0), layer(1), f.z);
}

}  // namespace aucast::facegen

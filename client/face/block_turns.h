#pragma once

#include "client/face/vertex_block.h"

namespace aucast::face {

// Turns of eight vertices, each by its own angle (radians, at most a quarter turn), about an axis
// parallel to a coordinate axis. The difference that a turn adds is exactly zero at the angle zero,
// so a vertex that does not turn keeps its place to the last bit. Sine and cosine are Taylor series
// up to x^12 in plain arithmetic, four lanes at a time. At a quarter turn the terms left out come
// to 6e-8; with rounding the error is 2e-7.

[[nodiscard]] inline Four turn_sine(Four x) {
  const Four q = x * x;
  return x * (1 + q * (-1.0F / 6 +
                       q * (1.0F / 120 +
                            q * (-1.0F / 5040 + q * (1.0F / 362880 - q * (1.0F / 39916800))))));
}

/// cos(x) - 1.
[[nodiscard]] inline Four turn_cosine_less_one(Four x) {
  const Four q = x * x;
  return q * (-0.5F + q * (1.0F / 24 +
                           q * (-1.0F / 720 + q * (1.0F / 40320 + q * (-1.0F / 3628800 +
                                                                       q * (1.0F / 479001600))))));
}

/// Turns the coordinates `u` and `v` about (u0, v0), each vertex by `angle` times its weight; a
/// positive angle turns the v axis towards the u axis.
inline void turn_plane(Lanes& u, Lanes& v, const Lanes& weights, float angle, float u0, float v0) {
  for (std::size_t i = 0; i < kLanes; i += 4) {
    const Four angles = four_at(weights, i) * angle;
    const Four sine = turn_sine(angles);
    const Four cosine_less_one = turn_cosine_less_one(angles);
    const Four at_u = four_at(u, i);
    const Four at_v = four_at(v, i);
    const Four du = at_u - u0;
    const Four dv = at_v - v0;
    set_four(u, i, at_u + (cosine_less_one * du + sine * dv));
    set_four(v, i, at_v + (cosine_less_one * dv - sine * du));
  }
}

/// About the x axis; positive: what is in front goes up.
inline void pitch(VertexBlock& block, const Lanes& weights, float angle, float y0, float z0) {
  turn_plane(block.y, block.z, weights, angle, y0, z0);
}

/// About the y axis; positive: what is in front goes to +x, the subject's left.
inline void turn(VertexBlock& block, const Lanes& weights, float angle, float x0, float z0) {
  turn_plane(block.x, block.z, weights, angle, x0, z0);
}

/// About the z axis; positive: what is above goes to +x.
inline void tilt(VertexBlock& block, const Lanes& weights, float angle, float x0, float y0) {
  turn_plane(block.x, block.y, weights, angle, x0, y0);
}

}  // namespace aucast::face

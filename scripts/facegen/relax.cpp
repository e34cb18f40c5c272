#include "scripts/facegen/relax.h"

#include <algorithm>
#include <functional>

#include "scripts/facegen/anatomy.h"
#include "scripts/facegen/sculpt.h"

namespace aucast::facegen {
namespace {

using Neighbours = std::vector<std::vector<std::uint32_t>>;

Neighbours neighbours_of(const HalfHead& half) {
  Neighbours of(half.vertices.size());
  for (const Quad& quad : half.quads) {
    for (std::size_t k = 0; k < 4; ++k) {
      of[quad[k]].push_back(quad[(k + 1) % 4]);
      of[quad[(k + 1) % 4]].push_back(quad[k]);
    }
  }
  for (auto& list : of) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return of;
}

/// The middle of a vertex' neighbours, those on the other half of the head included.
Vec3 neighbour_mean(const HalfHead& half, const Neighbours& neighbours, std::size_t index) {
  Vec3 sum{0};
  double count = 0;
  for (const std::uint32_t n : neighbours[index]) {
    const HalfVertex& neighbour = half.vertices[n];
    sum += neighbour.position;
    count += 1;
    if (half.vertices[index].on_midline && !neighbour.on_midline) {
      sum += neighbour.position * Vec3{-1, 1, 1};
      count += 1;
    }
  }
  return sum / count;
}

/// One pass over all vertices at once, so that the order of the vertices does not show.
void pass(HalfHead& half, const std::function<Vec3(std::size_t)>& moved) {
  std::vector<Vec3> next(half.vertices.size());
  for (std::size_t i = 0; i < next.size(); ++i) {
    next[i] = moved(i);
    if (half.vertices[i].on_midline) next[i].x = 0;
  }
  for (std::size_t i = 0; i < next.size(); ++i) half.vertices[i].position = next[i];
}

void spread(const Identity& who, HalfHead& half, const Neighbours& neighbours, int passes,
            double share) {
  for (int i = 0; i < passes; ++i) {
    pass(half, [&](std::size_t v) {
      const HalfVertex& vertex = half.vertices[v];
      if (vertex.pinned) return vertex.position;
      return on_skin(who, mix(vertex.position, neighbour_mean(half, neighbours, v), share), 4);
    });
  }
}

/// The loops round eye, mouth and nose must stay; the borders of the blocks must not, or their
/// corners show in the shading.
void free_borders(HalfHead& half) {
  for (HalfVertex& v : half.vertices) {
    if (v.patch == Patch::Eye && v.ring <= 3) v.pinned = false;
    if (v.patch == Patch::Mouth && v.ring <= 2) v.pinned = false;
    if (v.patch == Patch::Grid && v.row < kRows) {
      const bool nose = v.row >= 18 && v.row <= 24 && v.column <= 6;
      const bool ear = v.row >= 10 && v.row <= 20 && v.column >= 18 && v.column <= 24;
      if (!nose && !ear) v.pinned = false;
    }
  }
}

/// The ear is built freely in space; three light passes settle it into the side of the head.
void smooth_ear(HalfHead& half, const Neighbours& neighbours) {
  for (int i = 0; i < 3; ++i) {
    pass(half, [&](std::size_t index) {
      const HalfVertex& v = half.vertices[index];
      const bool beside =
          v.patch == Patch::Grid && v.row >= 9 && v.row <= 21 && v.column >= 17 && v.column <= 25;
      if (v.patch != Patch::Ear && !beside) return v.position;
      const bool carved = v.patch == Patch::Ear && v.ring >= 3 && v.ring <= 10;
      const double share = carved ? 0.11 : v.patch == Patch::Ear ? 0.35 : 0.40;
      return mix(v.position, neighbour_mean(half, neighbours, index), share);
    });
  }
}

/// A deep fold in the lid must not let the eyeball through.
void lift_lids(const Form& form, HalfHead& half) {
  const Vec3 eye = eye_centre(form);
  for (HalfVertex& v : half.vertices) {
    if (v.patch != Patch::Eye || v.ring > kLidInnerRing) continue;
    const Vec3 from_eye = v.position - eye;
    const double distance = glm::length(from_eye);
    const double thinnest = v.ring < kLidMarginRing ? 0.045 : 0.015;
    v.position += from_eye * (std::max(0.0, kEyeRadius + thinnest - distance) / distance);
  }
}

/// The last row goes inwards, so that it does not poke through the collar.
void tuck_neck(HalfHead& half) {
  for (HalfVertex& v : half.vertices) {
    if (v.patch != Patch::Grid || v.row < kRows) continue;
    v.position = mix(v.position, Vec3{0, v.position.y, -1.0}, 0.10);
  }
}

}  // namespace

void relax(const Identity& who, HalfHead& half) {
  const Neighbours neighbours = neighbours_of(half);
  spread(who, half, neighbours, 160, 0.6);
  free_borders(half);
  spread(who, half, neighbours, 10, 0.5);
  pass(half, [&](std::size_t v) {
    const HalfVertex& vertex = half.vertices[v];
    return vertex.pinned ? vertex.position : on_skin(who, vertex.position, 12);
  });
  lift_lids(who.form, half);
  smooth_ear(half, neighbours);
  tuck_neck(half);
}

}  // namespace aucast::facegen

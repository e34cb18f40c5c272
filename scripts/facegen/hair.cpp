#include "scripts/facegen/hair.h"

#include "scripts/facegen/hair_parts.h"
#include "scripts/facegen/scalp.h"

namespace aucast::facegen {

void add_sheet(Part& hair, const SheetSize& size,
               const std::function<HairPoint(double, double)>& at) {
  std::vector<std::vector<std::uint32_t>> rows(size.rows);
  for (std::size_t i = 0; i < size.columns; ++i) {
    for (std::size_t j = 0; j < size.rows; ++j) {
      const HairPoint point = at(static_cast<double>(i) / static_cast<double>(size.columns - 1),
                                 static_cast<double>(j) / static_cast<double>(size.rows - 1));
      rows[j].push_back(hair.add(point.place, point.colour, point.alpha));
      hair.vertices.back()[Map::Strand] = saturate(point.strand);
      hair.vertices.back().gloss = point.gloss;
    }
  }
  // Edges blend in this order: what is nearer to the face covers what is behind.
  const std::size_t middle = size.columns / 2;
  const auto add_column = [&](std::size_t i) {
    for (std::size_t j = 1; j < size.rows; ++j) {
      // Cut the way the strands lean, from the upper middle outwards, or they would run in steps.
      if (i < middle) {
        hair.add_quad(rows[j][i + 1], rows[j - 1][i + 1], rows[j - 1][i], rows[j][i]);
      } else {
        hair.add_quad(rows[j][i], rows[j][i + 1], rows[j - 1][i + 1], rows[j - 1][i]);
      }
    }
  };
  for (std::size_t i = middle; i-- > 0;) add_column(i);
  for (std::size_t i = middle; i + 1 < size.columns; ++i) add_column(i);
}

void add_stray(Part& hair, const Identity& who, std::size_t number,
               const std::function<Vec3(double)>& at, const std::function<Vec3(double)>& up) {
  // A ribbon on edge, so that it shows on the outline.
  constexpr double kHalfWidth = 0.013;
  const double strand = hash(static_cast<int>(number) * 37 + 11);
  const double front = glm::cross(up(0.5), at(0.4) - at(0.6)).z < 0 ? -1 : 1;
  add_sheet(hair, kStray, [&](double u, double v) {
    const double aside = front * (2 * u - 1) * kHalfWidth * mix(1, 0.5, v);
    // Light falls on it from all sides.
    HairPoint point{at(v) + up(v) * aside, 1.4 * shade_of(who, mix(0.55, 1.0, strand))};
    point.alpha = 0.45 * smooth_step(0, 0.2, v) * smooth_step(1, 0.5, v);
    point.strand = mix(0.1, 0.9, strand);
    point.gloss = 0.3;
    return point;
  });
}

void add_wisp(Part& hair, const Identity& who, double light, const std::function<Vec3(double)>& at,
              const std::function<Vec3(double)>& up) {
  // It lies flat, as it is seen from above.
  constexpr double kHalfWidth = 0.010;
  add_sheet(hair, kWisp, [&](double u, double v) {
    const double next = std::min(v + 0.05, 1.0);
    const Vec3 aside = glm::normalize(glm::cross(at(next) - at(next - 0.1), up(v)));
    HairPoint point{at(v) + aside * ((1 - 2 * u) * kHalfWidth * mix(1, 0.4, v)),
                    1.3 * shade_of(who, light)};
    point.alpha = 0.50 * smooth_step(0, 0.35, v) * smooth_step(1, 0.4, v);
    point.strand = mix(0.1, 0.9, light);
    point.gloss = 0.2;
    return point;
  });
}

Vec3 shade_of(const Identity& who, double light) {
  return mix(who.colours.hair, who.colours.hair_light, saturate(light));
}

Part make_hair(const Identity& who) {
  Part hair = who.hair.guides.empty() ? make_short_hair(who) : make_long_hair(who);
  hair.name = "hair";
  hair.material = who.hair.grey ? face::Material::GreyHair : face::Material::Hair;
  hair.fill(Map::Head, 1);
  return hair;
}

std::vector<ScalpPoint> scalp_of(const Identity& who) {
  const Scalp scalp(who);
  std::vector<ScalpPoint> points;
  for (int i = 0; i < 288; ++i) {
    for (int j = 0; j <= 32; ++j) {
      const double inside = j / 32.0;
      const Vec3 root = scalp.root(i / 12.0 - 12, inside);
      points.push_back({root, scalp.edge_from(root).distance});
    }
  }
  return points;
}

}  // namespace aucast::facegen

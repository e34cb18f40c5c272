#include "scripts/facegen/brows_lashes.h"

#include "scripts/facegen/anatomy.h"
#include "scripts/facegen/palette.h"
#include "scripts/facegen/sculpt.h"
#include "scripts/facegen/weights.h"

namespace aucast::facegen {
namespace {

// Lashes. On a lid, t runs from the inner corner of the eye (0) to the outer one (1).

/// The vertex of a ring of a lid, `k` spokes from the inner corner.
const Vertex& on_lid(const Skin& skin, int ring, int side, bool upper, int k) {
  const int spoke = spoke_from_canthus(upper ? k : kEyeSpokes - k);
  return skin.part.vertices[skin.find(Patch::Eye, ring, spoke, side)];
}

Vertex between(const Vertex& a, const Vertex& b, double share) {
  Vertex v = a;
  v.position = mix(a.position, b.position, share);
  for (std::size_t m = 0; m < v.maps.size(); ++m) v.maps[m] = mix(a.maps[m], b.maps[m], share);
  return v;
}

Vertex on_margin(const Skin& skin, int side, bool upper, double t) {
  const double at = std::clamp(t * kLidSteps, 0.0, kLidSteps - 1e-6);
  const int k = static_cast<int>(at);
  return between(on_lid(skin, kLidMarginRing, side, upper, k),
                 on_lid(skin, kLidMarginRing, side, upper, k + 1), at - k);
}

/// The dark line where the lashes stand, thin at both ends.
void add_lash_line(Part& part, const Identity& who, const Skin& skin, int side, bool upper) {
  std::vector<std::vector<std::uint32_t>> rows(3);
  for (int k = 0; k <= kLidSteps; ++k) {
    const double t = static_cast<double>(k) / kLidSteps;
    const Vertex& edge = on_lid(skin, kLidMarginRing, side, upper, k);
    const Vertex& inner = on_lid(skin, kLidInnerRing, side, upper, k);
    const Vertex& above = on_lid(skin, kLidMarginRing - 1, side, upper, k);
    const double dark = (upper ? mix(0.58, 0.84, who.form.lash) * smooth_step(0.0, 0.35, t)
                               : 0.34 * smooth_step(0.15, 0.75, t)) *
                        smooth_step(1.03, 0.90, t);
    // The lower lashes stand on the outer edge of their lid: its rim shows between them and the
    // ball.
    const std::array<Vertex, 3> across{upper ? between(edge, inner, 0.7) : edge,
                                       upper ? edge : between(edge, above, 0.35),
                                       between(edge, above, upper ? 0.55 : 1.0)};
    const std::array<double, 3> alphas{upper ? 0.7 * dark : 0.0, dark, 0.0};
    for (std::size_t j = 0; j < across.size(); ++j) {
      rows[j].push_back(part.add(across[j].position, kLash, alphas[j]));
      part.vertices.back().maps = across[j].maps;
      part.vertices.back().gloss = 0;
    }
  }
  for (std::size_t j = 0; j + 1 < rows.size(); ++j) part.add_band(rows[j], rows[j + 1], false);
}

/// The shade of a lid on the ball, and the red flesh in the inner corner of the eye. They belong to
/// the lid: on the ball they would turn with the gaze.
void add_lid_shade(Part& part, const Identity& who, const Skin& skin, int side, bool upper) {
  constexpr Vec3 kShade{0.055, 0.024, 0.020};  // lighter, it is a veil on iris and pupil
  const Vec3 eye = eye_centre(who.form) * Vec3{side, 1, 1};
  std::array<std::vector<std::uint32_t>, 2> rows;
  for (int k = 0; k <= kLidSteps; ++k) {
    const Vertex& margin = on_lid(skin, kLidInnerRing, side, upper, k);
    const Vec3 gap = on_lid(skin, kLidInnerRing, side, !upper, k).position - margin.position;
    const double width = std::min(upper ? 0.24 : 0.13, 0.7 * glm::length(gap));
    const Vec3 end = margin.position + gap * (width / std::max(glm::length(gap), 1e-6));
    const std::array<Vec3, 2> across{margin.position,
                                     eye + glm::normalize(end - eye) * (kEyeRadius + 0.012)};
    for (std::size_t j = 0; j < across.size(); ++j) {
      const double pink = smooth_step(3.6, 1.8, k);
      const double shade = j == 0 ? (upper ? 0.46 : 0.34) : 0.0;
      rows[j].push_back(part.add(across[j], mix(kShade, kCaruncle, pink), mix(shade, 0.85, pink)));
      part.vertices.back().maps = margin.maps;
      part.vertices.back().gloss = 0;
    }
  }
  part.add_band(rows[0], rows[1], false);
}

/// Where the skin of the upper lid lies at `over` the fold, on a spoke.
Vertex on_fold(const Identity& who, const Skin& skin, int side, int k, double over) {
  const Vec3 eye = eye_centre(who.form);
  const auto above = [&](const Vertex& v) {
    const double x =
        std::clamp(std::abs(v.position.x) - eye.x, kInnerCanthus + 0.1, kOuterCanthus - 0.1);
    return v.position.y - eye.y - lid_fold(who, x) - over;
  };
  for (int ring = kLidMarginRing; ring > 1; --ring) {
    const Vertex& below = on_lid(skin, ring, side, true, k);
    const Vertex& next = on_lid(skin, ring - 1, side, true, k);
    if (above(next) < 0) continue;
    return between(below, next, saturate(above(below) / (above(below) - above(next))));
  }
  return on_lid(skin, 1, side, true, k);
}

/// The skin of the upper lid from the lashes to its fold: darker along both, and above the fold
/// where the skin over it turns in. The quads of the skin are too coarse for it, and without it the
/// lid is a pale band between two lines.
void add_lid_band(Part& part, const Identity& who, const Skin& skin, int side) {
  struct Row {
    double over;  ///< the fold; in heights of the lid below it, in mesh units above
    double alpha;
    double dark;  ///< 1: as dark as the fold
  };
  static constexpr std::array<Row, 7> kBand{{{-1.1, 0.54, 0.75},
                                             {-0.80, 0.46, 0.55},
                                             {-0.45, 0.34, 0.40},
                                             {-0.12, 0.60, 0.85},
                                             {0.03, 0.78, 0.95},
                                             {0.085, 0.46, 0.85},
                                             {0.26, 0.0, 0.40}}};
  const Vec3 deep = who.colours.lid_skin * Vec3{0.36, 0.27, 0.25};
  std::vector<std::vector<std::uint32_t>> rows(kBand.size());
  for (int k = 1; k < kLidSteps; ++k) {
    const double t = static_cast<double>(k) / kLidSteps;
    const double ends = smooth_step(0.05, 0.30, t) * smooth_step(0.98, 0.75, t);
    for (std::size_t j = 0; j < kBand.size(); ++j) {
      const Row& row = kBand[j];
      const double over = row.over < 0 ? row.over * who.form.lid_fold : row.over;
      const Vertex on = on_fold(who, skin, side, k, over);
      rows[j].push_back(
          part.add(on.position, mix(who.colours.lid_skin, deep, row.dark), row.alpha * ends));
      part.vertices.back().maps = on.maps;
      part.vertices.back().gloss = 0;
    }
  }
  for (std::size_t j = 0; j + 1 < rows.size(); ++j) part.add_band(rows[j], rows[j + 1], false);
}

/// How lashes grow at `t`: where they leave the lid, and which way they go and curl.
struct LashGrowth {
  Vertex root;
  Vec3 along{0};
  Vec3 direction{0};
  double length = 0;
  double curl = 0;  ///< upwards, share of the length
};

LashGrowth lash_growth(const Identity& who, const Skin& skin, int side, bool upper, double t) {
  const Vec3 eye = eye_centre(who.form) * Vec3{side, 1, 1};
  LashGrowth growth;
  growth.root = on_margin(skin, side, upper, t);
  growth.along = glm::normalize(on_margin(skin, side, upper, std::min(1.0, t + 0.03)).position -
                                on_margin(skin, side, upper, std::max(0.0, t - 0.03)).position);
  const Vec3 out = glm::normalize(growth.root.position - eye);
  growth.root.position -= out * 0.015;
  // They fan out towards the temple.
  const Vec3 fan{side * (1.0 * (std::min(t, 0.80) - 0.36)), 0, 0};
  growth.direction = glm::normalize(out + fan + Vec3{0, upper ? -0.26 : -0.40, 0});
  const double ends = smooth_step(0.0, 0.25, t) * (1 - 0.74 * smooth_step(0.66, 0.98, t));
  growth.length = who.form.lash * ends * (upper ? mix(0.24, 0.47, smooth_step(0.1, 0.9, t)) : 0.09);
  growth.curl = upper ? 0.40 : -0.10;
  return growth;
}

Vec3 along_lash(const LashGrowth& growth, double s) {
  return growth.root.position + growth.direction * (growth.length * s) +
         Vec3{0, growth.curl * growth.length * s * s, 0};
}

/// The weights at `s` of a lash. Its tip turns further than the lid, so that the lashes of a shut
/// eye hang over the cheek; seen end-on they would be a drawn line.
Maps maps_along(const LashGrowth& growth, double s) {
  Maps maps = growth.root.maps;
  maps[static_cast<std::size_t>(Map::LidAngle)] *= 1 + 0.60 * s;
  return maps;
}

/// How dark lashes are: short ones are also thin.
double lash_strength(const Identity& who) {
  return mix(0.25, 1.0, who.form.lash);
}

/// What lashes are from afar: a soft dark fringe, dense at the lid.
void add_lash_fringe(Part& part, const Identity& who, const Skin& skin, int side, bool upper) {
  static constexpr std::array kSteps{0.0, 0.3, 0.62, 1.0};
  static constexpr std::array kAlphas{0.64, 0.46, 0.20, 0.0};
  constexpr int kColumns = kLidSteps;
  std::array<std::vector<std::uint32_t>, kSteps.size()> rows;
  for (int i = 1; i <= kColumns; ++i) {
    const double t = static_cast<double>(i) / kColumns;
    const LashGrowth growth = lash_growth(who, skin, side, upper, t);
    const double dark = (upper ? smooth_step(0.02, 0.4, t) : 0.6 * smooth_step(0.15, 0.70, t)) *
                        lash_strength(who) * (1 - 0.6 * smooth_step(0.80, 1.0, t));
    for (std::size_t j = 0; j < kSteps.size(); ++j) {
      rows[j].push_back(part.add(along_lash(growth, 0.85 * kSteps[j]), kLash, kAlphas[j] * dark));
      part.vertices.back().maps = upper ? maps_along(growth, kSteps[j]) : growth.root.maps;
      part.vertices.back().gloss = 0;
    }
  }
  for (std::size_t j = 0; j + 1 < rows.size(); ++j) part.add_band(rows[j], rows[j + 1], false);
}

/// One upper lash: a curved blade, pointed, that is seen from the front and from the side alike.
void add_lash(Part& part, const Identity& who, const Skin& skin, int side, int number, int count) {
  const auto chance = [&](int of) { return hash(number * 29 + side * 131 + of * 7001); };
  const double t = 0.06 + 0.93 * (number + 0.6 * chance(1)) / count;
  // Three or four stand apart at the lid and meet at their tips.
  constexpr int kTogether = 3;
  const int tuft_number = number / kTogether;
  const double tuft = 0.06 + 0.93 * ((tuft_number + 0.5) * kTogether) / count;
  LashGrowth growth = lash_growth(who, skin, side, true, t);
  const LashGrowth other = lash_growth(who, skin, side, true, std::clamp(tuft, 0.0, 1.0));
  growth.length *= 0.72 + 0.40 * chance(2);
  growth.curl *= 0.85 + 0.3 * chance(3);
  const Vec3 lean = 0.7 * (other.root.position - growth.root.position) +
                    growth.along * (0.06 * (chance(4) - 0.5));
  const Vec3 blade = glm::normalize(growth.along + Vec3{0, chance(5) > 0.5 ? 0.8 : -0.8, 0});
  static constexpr std::array kSteps{0.0, 0.50, 1.0};
  static constexpr std::array kWidths{1.0, 0.66, 0.0};
  static constexpr std::array kAlphas{0.82, 0.60, 0.04};
  const double half_width = 0.016 * mix(0.5, 1.0, who.form.lash);
  const double dark =
      lash_strength(who) * smooth_step(0.0, 0.22, t) * (1 - 0.4 * smooth_step(0.85, 1.0, t));
  std::array<std::uint32_t, 2> before{};
  for (std::size_t j = 0; j < kSteps.size(); ++j) {
    const Vec3 p = along_lash(growth, kSteps[j]) + lean * (kSteps[j] * kSteps[j]);
    const auto add = [&](double aside) {
      const auto index =
          part.add(p + blade * (aside * half_width * kWidths[j]), kLash, kAlphas[j] * dark);
      part.vertices.back().maps = maps_along(growth, kSteps[j]);
      part.vertices.back().gloss = 0;
      return index;
    };
    if (j + 1 == kSteps.size()) {
      part.add_triangle(before[0], before[1], add(0));
      break;
    }
    const std::array<std::uint32_t, 2> here{add(-1), add(1)};
    if (j > 0) part.add_quad(before[0], before[1], here[1], here[0]);
    before = here;
  }
}

void add_lashes(Part& part, const Identity& who, const Skin& skin, int side, bool upper) {
  add_lash_line(part, who, skin, side, upper);
  add_lash_fringe(part, who, skin, side, upper);
  constexpr int kLashes = 54;
  for (int i = 0; upper && i < kLashes; ++i) add_lash(part, who, skin, side, i, kLashes);
}

// Brows. t runs along the spine from the nose (0) to the temple (1), s across it from below (-1).

struct BrowPlace {
  Vec3 spine{0};
  Vec3 along{0};
  Vec3 across{0};
};

BrowPlace brow_place(const Identity& who, double t) {
  const Vec3 along = glm::normalize(brow_spine(who, std::min(1.0, t + 0.01)) -
                                    brow_spine(who, std::max(0.0, t - 0.01)));
  return {brow_spine(who, t), along, {-along.y, along.x, 0}};
}

/// A place in the front plane, laid on the skin. It must not stand off, or it leaves the outline.
Vec3 laid_on_skin(const Identity& who, const Vec3& flat, double height, int side) {
  Vec3 p{flat.x, flat.y, face_z(who, flat.x, flat.y)};
  p += head_normal(who, p, 0.05) * height;
  p.x *= side;
  return p;
}

/// Sets the maps of a vertex of a brow. Muscles move it nearly as they move the brow's spine: where
/// they squeeze the skin across the brow, its hairs stay long.
void weigh_by_spine(const Identity& who, Vertex& vertex) {
  constexpr double kShare = 0.6;  // with all of it, a frown's brows are too heavy
  const double begin = brow_spine(who, 0).x;
  const double t = (std::abs(vertex.position.x) - begin) / (brow_spine(who, 1).x - begin);
  const double below = kShare * (vertex.position.y - brow_spine(who, saturate(t)).y);
  Vertex root = vertex;
  root.position.y -= below;
  weigh_by_position(who, root);
  vertex.maps = root.maps;
  vertex[Map::RootBelow] = below;
}

/// The soft ground under the hairs.
void add_brow_ground(Part& brow, const Identity& who, int side) {
  constexpr int kAlong = 40;
  constexpr int kAcross = 6;
  std::vector<std::uint32_t> before;
  for (int i = 0; i <= kAlong; ++i) {
    const double t = static_cast<double>(i) / kAlong;
    const BrowPlace place = brow_place(who, t);
    const double half_width = std::max(0.012, 1.15 * brow_half_width(who, t));
    std::vector<std::uint32_t> row;
    for (int j = 0; j <= kAcross; ++j) {
      const double s = 2.0 * j / kAcross - 1;
      const Vec3 flat = place.spine + place.across * (half_width * s);
      // The inner end is single hairs on bare skin: with as much ground it is a grey haze.
      const double fade = smooth_step(0.00, 0.36, t) * smooth_step(1.02, 0.76, t);
      const double alpha = 0.74 * fade * smooth_step(1.0, 0.06, std::abs(s));
      row.push_back(brow.add(laid_on_skin(who, flat, 0.022, side), who.colours.brow, alpha));
      weigh_by_spine(who, brow.vertices.back());
    }
    if (i > 0) {
      if (side > 0) {
        brow.add_band(before, row, false);
      } else {
        brow.add_band(row, before, false);
      }
    }
    before = std::move(row);
  }
}

/// Which way a hair lies: up at the nose, then along the brow, from both edges towards its ridge.
Vec3 hair_direction(const BrowPlace& place, double t, double s, double astray) {
  const double upright = mix(1.25, 0.12, smooth_step(-0.05, 0.36, t));
  const double angle = upright - 0.46 * s * smooth_step(0.08, 0.4, t) + 0.32 * (astray - 0.5);
  return place.along * std::cos(angle) + place.across * std::sin(angle);
}

void add_brow_hairs(Part& brow, const Identity& who, int side) {
  constexpr int kHairs = 196;
  for (int i = 0; i < kHairs; ++i) {
    const auto chance = [&](int of) { return hash(i * 97 + of * 7919); };
    // Both sides stand alike and are not equally dark: no face is its own mirror image.
    const auto on_side = [&](int of) { return hash(i * 97 + of * 7919 + (side > 0 ? 0 : 53)); };
    // More of them where no ground is under them.
    const double even = (i + chance(1)) / kHairs;
    const double t = 0.94 * mix(even * even, even, 0.55);
    // At the head they stand up from the lower edge.
    const double s = 1.7 * (chance(2) - 0.5) - mix(0.30, 0.10, smooth_step(0.05, 0.35, t));
    const BrowPlace place = brow_place(who, t);
    const double half_width = brow_half_width(who, std::max(t, 0.06));
    const Vec3 root = place.spine + place.across * (half_width * s);
    const Vec3 direction = hair_direction(place, t, s, chance(3));
    const Vec3 aside{-direction.y, direction.x, 0};
    const double length = (0.25 + 0.46 * half_width) * (0.75 + 0.5 * chance(4)) *
                          mix(0.62, 1.0, smooth_step(0.0, 0.35, t)) *
                          mix(1.0, 0.72, smooth_step(0.6, 1.0, t));
    // As dark at the edges as in the middle, they are a comb.
    const double alpha = mix(0.30, 0.70, smooth_step(0.0, 0.28, t)) * (0.6 + 0.4 * on_side(5)) *
                         (1 - 0.55 * smooth_step(0.35, 0.90, std::abs(s))) *
                         (1 - 0.35 * smooth_step(0.55, 0.95, t));
    const Vec3 colour = who.colours.brow * (0.7 + 0.6 * on_side(6));
    const double thick = mix(0.0090, 0.0115, smooth_step(0.0, 0.25, t)) * (0.8 + 0.4 * chance(7));
    std::array<std::uint32_t, 3> corner{};
    const std::array<Vec3, 3> flat{root - aside * thick, root + aside * thick,
                                   root + direction * length};
    for (std::size_t k = 0; k < corner.size(); ++k) {
      const bool tip = k == 2;
      corner[k] = brow.add(laid_on_skin(who, flat[k], tip ? 0.034 : 0.026, side), colour,
                           alpha * (tip ? 0.25 : 1));
      weigh_by_spine(who, brow.vertices.back());
    }
    if (side > 0) {
      brow.add_triangle(corner[0], corner[1], corner[2]);
    } else {
      brow.add_triangle(corner[1], corner[0], corner[2]);
    }
  }
}

}  // namespace

Part make_brow(const Identity& who, int side) {
  Part brow;
  brow.name = side > 0 ? "left_brow" : "right_brow";
  brow.material = face::Material::Brow;
  add_brow_ground(brow, who, side);
  add_brow_hairs(brow, who, side);
  return brow;
}

Part make_lashes(const Identity& who, const Skin& skin) {
  Part lashes;
  lashes.name = "lashes";
  lashes.material = face::Material::Lash;
  for (const int side : {1, -1}) {
    add_lid_band(lashes, who, skin, side);
    for (const bool upper : {true, false}) add_lid_shade(lashes, who, skin, side, upper);
    for (const bool upper : {true, false}) add_lashes(lashes, who, skin, side, upper);
  }
  return lashes;
}

}  // namespace aucast::facegen

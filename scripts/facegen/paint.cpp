#include "scripts/facegen/paint.h"

#include "scripts/facegen/anatomy.h"
#include "scripts/facegen/hair_parts.h"
#include "scripts/facegen/palette.h"
#include "scripts/facegen/polyline.h"
#include "scripts/facegen/sculpt.h"

namespace aucast::facegen {
namespace {

/// How much blood shows: cheeks, tip and wings of the nose, chin, ears, and a little unevenness
/// (any finer and the quads would show): more of it on skin that is `mottled`.
double flush(const HalfVertex& v, const Vec3& mirrored_position, double mottled) {
  const Vec3& p = v.position;
  double f = mix(0.20, 0.38, mottled) * (value_noise(mirrored_position * 0.7) - 0.5) +
             mix(0.10, 0.34, mottled) * (value_noise(mirrored_position * 1.7) - 0.5);
  if (p.z > 3) {
    f += 0.55 * bell(Vec3{(p.x - 2.75) / 1.25, (p.y - 0.15) / 1.05, (p.z - 6.5) / 2.2});
    f += 0.42 * bell(Vec3{p.x / 0.85, (p.y - 0.10) / 0.7, 0}) * smooth_step(8.2, 9.2, p.z);
    f += 0.28 * bell(Vec3{(p.x - 0.95) / 0.5, (p.y + 0.25) / 0.5, 0});
    f += 0.10 * bell(Vec3{p.x / 0.9, (p.y + 4.6) / 0.7, 0});
  }
  if (v.patch == Patch::Ear) f += 0.34 * smooth_step(0, 4, v.ring);
  return saturate(f);
}

/// The thin skin round the eye and over the temple is cooler and a little darker.
Vec3 cooled(const Vec3& colour, const Vec3& p) {
  if (p.z < 2) return colour;
  const double socket = 0.32 * bell(Vec3{(p.x - 1.75) / 0.95, (p.y - 3.1) / 0.8, 0}) +
                        0.40 * bell(Vec3{(p.x - 1.9) / 0.85, (p.y - 1.95) / 0.42, 0});
  const double temple = bell(Vec3{(p.x - 4.3) / 0.9, (p.y - 3.4) / 1.3, (p.z - 4) / 1.6});
  return colour * mix(Vec3{1}, Vec3{0.90, 0.86, 0.88}, saturate(socket + 0.35 * temple));
}

/// What faces down between the brow and the fold of the lid: light that comes up from the cheeks
/// keeps it from being a brown patch.
double under_brow(const Vec3& p) {
  if (p.z < 5) return 0;
  return bell(Vec3{(p.x - 1.8) / 1.25, (p.y - 3.56) / 0.36, 0});
}

/// Between the inner corner of the eye, the brow and the nose, where what light the lamp leaves is
/// grey: the skin there is warmer.
double inner_socket(const Vec3& p) {
  if (p.z < 6) return 0;
  return bell(Vec3{(p.x - 0.98) / 0.42, (p.y - 3.25) / 0.62, 0});
}

/// How far a vertex lies below its neighbours, mesh units, for every vertex; negative: above them.
std::vector<double> hollows(const Part& part) {
  const std::vector<Vec3> means = means_of_neighbours(part, &Vertex::position);
  const std::vector<Vec3> normals = normals_of(part);
  std::vector<double> below(means.size());
  for (std::size_t i = 0; i < below.size(); ++i) {
    below[i] = glm::dot(means[i] - part.vertices[i].position, normals[i]);
  }
  return below;
}

/// Deep in the ear little light arrives, and what does is red.
void paint_ear(Vertex& vertex, const HalfVertex& v) {
  // The shell is deep, and so is the furrow inside the rim from the top down to the lobe.
  const double shell = smooth_step(6.0, 10.5, v.ring);
  const double furrow = bell(v.ring - 5.0, 1.3) * smooth_step(14, 10, std::abs(v.spoke - 22.0));
  const double deep = std::max(shell, 0.55 * furrow);
  vertex.colour *= Vec3{1.0, 1.01, 1.01};
  vertex.colour *= mix(Vec3{1}, Vec3{0.47, 0.38, 0.35}, deep);
  vertex.gloss *= 1 - 0.7 * deep;
}

void paint_eye(const Identity& who, Vertex& vertex, const HalfVertex& v) {
  const bool upper = from_canthus(v.spoke) <= kLidSteps;
  // More than this below the eye looks tired.
  Vec3 c =
      mix(vertex.colour, who.colours.lid_skin, (upper ? 0.30 : 0.12) * smooth_step(1, 5, v.ring));
  if (v.ring >= kLidMarginRing)
    c = mix(c, who.colours.lid_rim, v.ring == kLidMarginRing ? 0.55 : 0.35);
  if (v.ring > kLidInnerRing) c = kLidInside;
  const double from_corner = v.position.x - (eye_centre(who.form).x + kInnerCanthus);
  if (v.ring >= kLidMarginRing) {
    c = mix(c, kCaruncle, 0.8 * smooth_step(0.45, 0.05, from_corner));
  }
  vertex.colour = c;
  // The edge of the lower lid is moist; in the corner it would be a spark on a shut eye.
  const bool edge = v.ring == kLidInnerRing;
  vertex.gloss = edge && !upper ? mix(0.4, 4.5, smooth_step(0.2, 0.6, from_corner)) : 1.2;
}

/// The corner of the mouth lies in a small shade of its own, where the lips close and the cheek
/// begins.
double corner_shade(const Identity& who, const Vec3& p) {
  const Vec3 from_corner{p.x - kMouthCorner + 0.09, p.y - lip_contact(who, kMouthCorner), 0};
  return bell(Vec3{from_corner.x / 0.25, from_corner.y / 0.18, 0});
}

void paint_mouth(const Identity& who, Vertex& vertex, const HalfVertex& v) {
  vertex.colour *= Vec3{1} - Vec3{0.10, 0.15, 0.16} * corner_shade(who, v.position);
  if (v.ring == kLipBorderRing - 1) {
    // A pale line goes round the red of the lips.
    vertex.colour *= mix(1.06, 1.0, smooth_step(0.5, 1.0, v.position.x / kMouthCorner));
  }
  if (v.ring < kLipBorderRing) return;
  const bool border = v.ring == kLipBorderRing;
  const double to_corner = saturate(v.position.x / kMouthCorner);
  // The red tapers towards the corners, from its border inwards: red as far as the border there, a
  // mouth that is stretched open has a rim of even width, a hole cut in rubber.
  const double from_border = saturate(static_cast<double>(v.ring - kLipBorderRing) /
                                      static_cast<double>(kLipContactRing - kLipBorderRing));
  const double taper =
      smooth_step(mix(0.40, 0.70, from_border), mix(0.86, 1.0, from_border), to_corner);
  const double strength = (border ? 0.70 : 1.0) * (1 - 0.20 * to_corner * to_corner) *
                          (1 - mix(0.92, 0.75, from_border) * taper);
  Vec3 c =
      mix(vertex.colour, who.colours.lip, strength) * (v.spoke < kMouthCornerSpoke ? 0.88 : 1.04);
  // The line between the lips fades out before their corners, or it is drawn with a pen.
  if (v.ring >= kLipContactRing - 1)
    c = mix(c, kLipInside, 0.8 - 0.65 * smooth_step(0.66, 0.98, to_corner));
  // The web of skin between the ends of the lips lies in shade: lit, it is a pale rim.
  c *= mix(Vec3{1}, kLipWeb, smooth_step(0.55, 0.96, to_corner) * mix(0.5, 1.0, from_border));
  if (v.ring > kLipContactRing) {
    // Into the dark of the mouth, sooner at the corners.
    const double inwards = static_cast<double>(v.ring - kLipContactRing) /
                           static_cast<double>(kLipLastRing - kLipContactRing);
    c = mix(kLipInside * 0.95, kMouthFront * 0.5, inwards * mix(0.7, 0.4, to_corner));
    // Lit, the corners' insides would hang as curtains before the dark.
    c *= 1 - 0.10 * smooth_step(0.75, 0.95, to_corner);
  }
  vertex.colour = c;
  // The lower lip is the fuller one and catches most light in its middle.
  const double full = (v.spoke > kMouthCornerSpoke ? 1.3 : 0.3) * bell(v.position.x, 0.9);
  vertex.gloss = (border ? 0.9 : 1.6 + full) * (1 - 0.85 * smooth_step(0.55, 0.95, to_corner));
}

void paint_nostril(Vertex& vertex, const HalfVertex& v) {
  if (v.ring == 1) vertex.colour = mix(vertex.colour, kNostrilRim, 0.34);
  if (v.ring < 2) return;
  vertex.colour = mix(vertex.colour, kNostril, v.ring == 2 ? 0.44 : 0.92);
  vertex.gloss = 0.2;
}

/// Where a beard grows: upper lip, chin, jaw and the front of the throat, not the red of the lips.
double beard_field(const HalfVertex& v) {
  const Vec3& p = v.position;
  if (p.z < 1 || (v.patch == Patch::Mouth && v.ring >= kLipBorderRing)) return 0;
  const double jaw = smooth_step(-0.9, -2.6, p.y + 0.35 * (p.z - 5) - 0.25 * p.x);
  const double moustache = smooth_step(-0.70, -1.50, p.y) * smooth_step(2.4, 1.2, p.x);
  const double below = smooth_step(-7.2, -5.6, p.y) * smooth_step(1.0, 2.6, p.z);
  return std::max(jaw * mix(1, 0.5, smooth_step(1.8, 3.2, p.x)), 0.55 * moustache) * below;
}

/// What faces down under the edge of the jaw: a little darker, so that the edge reads in profile.
double under_jaw(const Identity& who, const Vec3& p) {
  if (p.z < 0.5 || p.y > -1.5 || p.y < -7.5) return 0;
  return smooth_step(-0.10, -0.65, head_normal(who, p, 0.1).y) * smooth_step(0.5, 2.0, p.z) *
         smooth_step(-2.2, -3.2, p.y - 0.2 * (p.z - 4)) * smooth_step(-7.5, -6.0, p.y);
}

/// The floor of the mouth and the top of the throat: a little darker, so that the chin stands out
/// from the neck also where the light comes from the front. Not below the side of the jaw, where so
/// much would be a bruise in profile.
double under_chin(const Vec3& p) {
  return bell(p.y + 6.0, 1.3) * smooth_step(0.8, 2.4, p.z) * bell(p.x, 1.8) *
         smooth_step(-5.0, -5.6, p.y - 0.25 * (p.z - 3.5));
}

/// The shadow that the jaw casts on the front of the neck, deepest close below it: the ambient
/// light that is baked does not know the lamp above.
double below_jaw(const Vec3& p) {
  return smooth_step(-8.6, -6.2, p.y) * smooth_step(-4.6, -5.6, p.y - 0.25 * (p.z - 3.5)) *
         smooth_step(0.0, 2.2, p.z) * bell(p.x, 2.6);
}

/// The underside of the chin, which takes light from the chest that is not baked: without it the
/// chin is a bulb with a dark end.
double below_chin(const Identity& who, const Vec3& p) {
  if (p.z < 5) return 0;
  return bell(Vec3{p.x / 1.7, (p.y + 5.10 + who.form.chin_drop) / 0.50, 0});
}

/// Beside the ropes that run from behind the ears to the pit of the throat the neck falls back.
double beside_rope(const Identity& who, const Vec3& p) {
  if (p.z < 0 || p.y > -5.5) return 0;
  const double wide = who.form.neck_width;
  const auto [behind_ear, pit] = neck_rope(who.form);
  const double down = saturate((p.y - behind_ear.y) / (pit.y - behind_ear.y));
  const double inwards = p.x - mix(behind_ear.x, pit.x, down);
  // Widest a little above where both ropes end.
  const double hollow = bell(Vec3{p.x / (0.55 * wide), (p.y - (pit.y + 1.0)) / 1.1, 0});
  return std::max(smooth_step(-5.5, -7.2, p.y) * (0.9 * bell(inwards + 0.85 * wide, 0.42 * wide) +
                                                  0.7 * bell(inwards - 0.95 * wide, 0.5 * wide)),
                  hollow);
}

/// The side of the nose from the inner corner of the eye to the wing, which turns away from every
/// light: without it bridge and wings are one form with the cheeks from the front. Faint along the
/// bridge, which more would make a column.
double beside_nose(const Identity& who, const Vec3& p) {
  if (p.z < 6.5) return 0;
  static constexpr std::array<Vec3, 4> kSide{
      {{.66, 2.2, .25}, {.78, 1.2, .40}, {.96, .45, .65}, {1.24, -.05, 1.0}}};
  const double x = p.x / who.form.nose_width;
  const double under_tip =
      bell(Vec3{x / 0.75, (p.y + 0.80) / 0.22, 0}) * smooth_step(7.8, 8.6, p.z);
  return std::max(Polyline(kSide).strength({x, p.y}, mix(0.28, 0.40, smooth_step(0.3, 1.4, p.y))),
                  0.8 * under_tip);
}

/// The ridge of the nose between the eyes and the tip: as light as what faces the lamp is, it would
/// be a column.
double on_bridge(const Vec3& p) {
  if (p.z < 7) return 0;
  return bell(p.x, 0.36) * smooth_step(0.5, 1.1, p.y) * smooth_step(3.0, 2.2, p.y);
}

/// What faces down or aside of tip and wings: without more warmth, what gets no light of the lamp
/// there looks grey beside the red edge of its shadow.
double under_nose(const Identity& who, const Vec3& p) {
  const double x = p.x / who.form.nose_width;
  const double near = bell(Vec3{x / 1.25, (p.y + 0.48) / 0.50, 0}) * smooth_step(7.6, 8.2, p.z);
  if (near < 1e-3) return 0;
  const Vec3 normal = head_normal(who, p);
  const double away = smooth_step(0.05, -0.55, normal.y) + smooth_step(0.50, 0.85, normal.x);
  return near * std::min(1.0, 0.25 + away);
}

/// The planes of the cheek: light on the bone below the eye, shade below it to beside the
/// corner of the mouth. Of one colour, a cheek is a large ball however it is formed. 1 is shade, -1
/// light.
double cheek_planes(const Vec3& p) {
  if (p.z < 2) return 0;
  static constexpr std::array<Vec3, 4> kBelowBone{
      {{4.5, .30, .0}, {3.75, -.55, .5}, {3.05, -1.45, .9}, {2.75, -2.30, .4}}};
  static constexpr std::array<Vec3, 3> kOnBone{
      {{3.95, 1.75, .7}, {3.15, 1.05, 1.0}, {2.2, .85, .5}}};
  return Polyline(kBelowBone).strength({p.x, p.y}, 0.62) -
         Polyline(kOnBone).strength({p.x, p.y}, 0.45);
}

/// The groove from nose to lip and the shade of its nearer edges.
double philtrum(const Identity& who, const Vec3& p) {
  if (p.z < 7) return 0;
  return who.form.philtrum * smooth_step(kPhiltrumFoot + 0.10, kPhiltrumFoot + 0.45, p.y) *
         smooth_step(kPhiltrumTop, kPhiltrumTop - 0.25, p.y) *
         (bell(p.x, 0.20) - 0.5 * bell(p.x - kPhiltrumRidge, 0.14));
}

/// The tip of the nose shines more than the rest, in one spot. Its bridge, which would be a stripe,
/// and forehead, chin and the skin below the eyes, which face the lamp, shine less, neck and back
/// of the head least.
double shine(const Vec3& p) {
  double s = 0.85;
  if (p.z > 8) s += 0.75 * bell(Vec3{p.x / 0.5, (p.y - 0.22) / 0.40, 0});
  if (p.z > 7.5) s -= 0.25 * bell(Vec3{p.x / 0.8, (p.y - 1.7) / 0.9, 0});
  if (p.z > 5) s -= 0.32 * bell(Vec3{p.x / 2.5, (p.y - 5.8) / 1.3, 0});
  if (p.z > 5) s -= 0.50 * bell(Vec3{p.x / 1.3, (p.y + 4.4) / 1.1, 0});
  if (p.z > 5) s -= 0.30 * bell(Vec3{(p.x - 1.8) / 1.0, (p.y - 1.4) / 0.8, 0});
  return p.y < -5 || p.z < 0 ? 0.6 * s : s;
}

}  // namespace

void paint_skin(const Identity& who, Skin& skin) {
  for (std::size_t i = 0; i < skin.part.vertices.size(); ++i) {
    Vertex& vertex = skin.part.vertices[i];
    const HalfVertex& v = skin.half.vertices[skin.source[i]];
    const Vec3& p = v.position;
    Vec3 c =
        mix(who.colours.skin, who.colours.flush, flush(v, vertex.position, who.colours.mottled));
    if (p.z > 4)
      c = mix(c, who.colours.forehead_skin, 0.85 * bell(Vec3{p.x / 3.0, (p.y - 5.8) / 1.8, 0}));
    c = mix(c, who.colours.neck_skin, 0.55 * smooth_step(-5, -7, p.y));
    c = cooled(c, p) * (Vec3{1} - Vec3{0.24, 0.28, 0.29} * under_chin(p));
    c *= Vec3{1} - Vec3{0.33, 0.37, 0.38} * below_jaw(p);
    c *= Vec3{1} - Vec3{0.11, 0.13, 0.13} * under_jaw(who, p);
    c *= Vec3{1} + Vec3{0.14, 0.21, 0.23} * below_chin(who, p);
    c *= Vec3{1} - Vec3{0.15, 0.20, 0.21} * beside_rope(who, p);
    c *= Vec3{1} - Vec3{1.15, 1.75, 1.75} * std::max(0.0, fold_depth(who, p));
    c *= Vec3{1} - Vec3{0.075, 0.11, 0.11} * beside_nose(who, p);
    c *= Vec3{1} - Vec3{0.05, 0.08, 0.08} * on_bridge(p);
    c *= Vec3{1} - Vec3{0.10, 0.13, 0.13} * cheek_planes(p);
    c *= Vec3{1} - Vec3{-0.20, -0.13, -0.10} * inner_socket(p);
    c *= Vec3{1} + Vec3{0.17, 0.22, 0.25} * under_brow(p);
    c *= Vec3{1} - Vec3{0.02, 0.09, 0.115} * under_nose(who, p);
    c *= Vec3{1} - Vec3{0.03, 0.055, 0.055} * philtrum(who, p);
    const double stubble = who.colours.beard * beard_field(v);
    vertex.colour = mix(c, c * kBeardShade, stubble);
    vertex.gloss = 1 - stubble;
    if (v.patch == Patch::Eye) paint_eye(who, vertex, v);
    if (v.patch == Patch::Mouth) paint_mouth(who, vertex, v);
    if (v.patch == Patch::Ear) paint_ear(vertex, v);
    if (v.patch == Patch::Nostril) paint_nostril(vertex, v);
    vertex.gloss *= shine(p);
  }
  // The ridges of the ears catch the light and the furrows between them do not, also where the head
  // is lit from the front.
  const std::vector<double> below = hollows(skin.part);
  for (std::size_t i = 0; i < below.size(); ++i) {
    const HalfVertex& v = skin.half.vertices[skin.source[i]];
    if (v.patch != Patch::Ear || v.ring < 2) continue;
    constexpr double kDeep = 0.04;
    const double hollow = std::clamp(below[i] / kDeep, -1.0, 1.0);
    skin.part.vertices[i].colour *= hollow > 0 ? mix(Vec3{1}, Vec3{0.60, 0.50, 0.47}, hollow)
                                               : mix(Vec3{1}, Vec3{1.34, 1.37, 1.37}, -hollow);
  }
}

void lighten_sockets(Skin& skin) {
  // Light that bounces between brow, lid and nose is not baked; without it the sockets are dirty.
  for (std::size_t i = 0; i < skin.part.vertices.size(); ++i) {
    const Vec3& p = skin.half.vertices[skin.source[i]].position;
    if (p.z < 4) continue;
    const double inside = bell(Vec3{(p.x - 1.95) / 1.35, (p.y - 3.25) / 0.70, 0});
    double& occlusion = skin.part.vertices[i].occlusion;
    // Beside the nose the rim lights would lay a grey haze on it.
    occlusion = mix(occlusion, 1.0, 0.5 * inside) * (1 - 0.2 * inner_socket(p));
  }
}

void shade_inner_lips(Skin& skin) {
  for (std::size_t i = 0; i < skin.part.vertices.size(); ++i) {
    const HalfVertex& v = skin.half.vertices[skin.source[i]];
    if (v.patch != Patch::Mouth) continue;
    if (v.ring <= kLipContactRing) {
      // The groove between the lips ends softly.
      double& occlusion = skin.part.vertices[i].occlusion;
      const double to_end = smooth_step(0.70, 1.0, v.position.x / kMouthCorner);
      if (v.ring >= kLipBorderRing) occlusion = mix(occlusion, 1.0, 0.6 * to_end);
      continue;
    }
    const double inwards = static_cast<double>(v.ring - kLipContactRing) /
                           static_cast<double>(kLipLastRing - kLipContactRing);
    const double to_corner = saturate(v.position.x / kMouthCorner);
    // In their very ends the lips are red as far as they are seen: black, they are drawn points.
    const double end = smooth_step(0.80, 0.97, to_corner) * (1 - inwards);
    skin.part.vertices[i].occlusion *=
        mix(0.75, 0.40, inwards) * (1 - 0.3 * to_corner) * (1 + 1.3 * end);
    skin.part.vertices[i].gloss *= 0.3;
  }
}

void shade_under_hair(const Identity& who, Skin& skin, const Part& hair) {
  // As much as there is of hair near by, weighed by distance: no ray hits or misses a strand, which
  // would show as blocks.
  constexpr double kReach = 0.7;
  // What hangs beside the face keeps light from its whole side, faintly.
  constexpr double kFar = 1.7;
  struct Piece {
    Vec3 place{0};
    double weight = 0;
  };
  std::vector<Piece> pieces;
  for (const face::Polygon& polygon : hair.polygons) {
    const auto at = [&](std::size_t k) { return hair.vertices[polygon.corners[k]]; };
    const Vec3 middle = (at(0).position + at(1).position + at(2).position + at(3).position) * 0.25;
    const double area = 0.5 * glm::length(glm::cross(at(2).position - at(0).position,
                                                     at(3).position - at(1).position));
    const double alpha = (at(0).alpha + at(1).alpha + at(2).alpha + at(3).alpha) * 0.25;
    pieces.push_back({middle, alpha * area / kPi});
  }
  // Short hair takes less of the light, and what falls through it is not reddened.
  const bool cropped = who.hair.guides.empty();
  const double strength = cropped ? 0.6 : 1;
  const Vec3 under = cropped ? Vec3{0.72, 0.72, 0.74} : kUnderHair;
  for (Vertex& vertex : skin.part.vertices) {
    double near = 0;
    double beside = 0;
    for (const Piece& piece : pieces) {
      const Vec3 way = piece.place - vertex.position;
      const double far2 = glm::dot(way, way);
      if (far2 > 9 * kFar * kFar) continue;
      near += piece.weight * std::exp(-far2 / (kReach * kReach)) / (kReach * kReach);
      beside += piece.weight * std::exp(-far2 / (kFar * kFar)) / (kFar * kFar);
    }
    const double shade = 1 - std::exp(-3.0 * near);
    const double wide = 1 - std::exp(-1.1 * beside);
    vertex.occlusion *= (1 - 0.68 * strength * shade) * (1 - 0.30 * wide);
    vertex.colour *= mix(Vec3{1}, under, shade) * mix(Vec3{1}, Vec3{0.86, 0.82, 0.81}, wide);
  }
}

void tint_scalp(const Identity& who, Skin& skin, std::span<const ScalpPoint> scalp) {
  constexpr double kReach2 = 1.6;
  // Through short hair skin would shine orange; in the neck it thins out over a longer way.
  const bool cropped = who.hair.guides.empty();
  for (std::size_t i = 0; i < skin.part.vertices.size(); ++i) {
    Vertex& vertex = skin.part.vertices[i];
    if (vertex.position.y < -3.5) continue;
    if (skin.half.vertices[skin.source[i]].patch == Patch::Ear) continue;
    double nearest2 = kReach2;
    double inside = 0;
    for (const ScalpPoint& point : scalp) {
      const Vec3 way = point.place - vertex.position;
      const double distance2 = glm::dot(way, way);
      if (distance2 < nearest2) {
        nearest2 = distance2;
        inside = point.inside;
      }
    }
    const double width = cropped ? mix(1.8, 3.2, smooth_step(2.0, -0.5, vertex.position.y)) : 1.3;
    // The tint starts behind the hairline; at the line itself it would show the grid in steps.
    const double tint = (cropped ? 0.92 : 0.85) * smooth_step(0.0, width, inside);
    vertex.colour = mix(vertex.colour, shade_of(who, 0.12), tint);
  }
}

}  // namespace aucast::facegen

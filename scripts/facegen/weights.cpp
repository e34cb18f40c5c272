#include "scripts/facegen/weights.h"

#include "scripts/facegen/anatomy.h"
#include "scripts/facegen/polyline.h"

namespace aucast::facegen {
namespace {

/// The zygomatics' published reach takes the nose along, and a linear muscle moves the skin
/// half-way to its attachment most. A smile should move the corner of the mouth most and the nose
/// not at all.
double smile_field(const Vec3& p) {
  const double x = std::abs(p.x);
  const double nose = smooth_step(-1.35, -0.35, p.y) * smooth_step(2.0, 1.05, x);
  const double from_attachment = glm::length(Vec3{x, p.y, p.z} - kSmileAttachment);
  const double outer = mix(0.20, 1.0, smooth_step(2.6, 4.2, from_attachment));
  return (1 - nose) * outer * (1 - 0.8 * smooth_step(0.6, 1.8, p.y));
}

double forehead_field(const Vec3& p) {
  return smooth_step(2.4, 3.9, p.y);
}

/// Share of the lower lip: across a band about the line of the mouth.
double lower_lip_field(const Identity& who, const Vec3& p) {
  const double line = lip_contact(who, std::min(std::abs(p.x), kMouthCorner));
  return smooth_step(0.30, -0.40, p.y - line);
}

/// What the levators leave alone: the tip and the ridge of the nose.
double nose_tip_field(const Vec3& p) {
  return smooth_step(-2.2, -0.4, p.y) * smooth_step(1.05, 0.3, std::abs(p.x)) *
         smooth_step(6.0, 7.0, p.z);
}

/// What they raise less than the lip: the wings of the nose, or it is a W from the front.
double nose_wing_field(const Vec3& p) {
  return smooth_step(-1.3, -0.6, p.y) * smooth_step(1.5, 1.1, std::abs(p.x)) *
         smooth_step(6.0, 7.0, p.z);
}

/// 1 on the furrow from the wing of the nose past the corner of the mouth; below 0 on the cheek
/// along it, which swells as the furrow gets deeper. A groove alone is a scratch.
double nasolabial_field(const Vec3& p) {
  if (p.z < 5) return 0;
  const glm::dvec2 place{std::abs(p.x), p.y};
  const Polyline furrow(kFurrow);
  const auto nearest = furrow.nearest(place);
  // Beside the wing of the nose it would be a muzzle, beside the corner of the mouth a jowl.
  const double swell =
      smooth_step(0.2, 2.2, nearest.along()) * smooth_step(3.9, 2.5, nearest.along()) *
      smooth_step(0.08, 0.50, nearest.to_left) * smooth_step(1.55, 0.55, nearest.away);
  return furrow.strength(place, 0.24) - 0.9 * swell;
}

double glabella_field(const Vec3& p) {
  if (p.z < 5) return 0;
  return bell(std::abs(p.x) - 0.34, 0.17) * bell(p.y - 4.15, 0.55);
}

/// Lids: elevation about the eye's centre of the inner edge of the margin, spoke by spoke.
std::array<double, kEyeSpokes> margin_elevation(const Form& form, const HalfHead& half) {
  std::array<double, kEyeSpokes> elevation{};
  for (const HalfVertex& v : half.vertices) {
    if (v.patch != Patch::Eye || v.ring != kLidInnerRing) continue;
    const Vec3 from_eye = v.position - eye_centre(form);
    elevation[static_cast<std::size_t>(v.spoke)] = std::atan2(from_eye.y, from_eye.z);
  }
  return elevation;
}

void weigh_lid(Vertex& vertex, const HalfVertex& v,
               const std::array<double, kEyeSpokes>& elevation) {
  const double from_margin =
      v.ring >= kLidMarginRing ? 0.0 : kEyeRings[static_cast<std::size_t>(v.ring)];
  const double share = 1 - smooth_step(0.02, 0.48, from_margin);
  // Muscles round the eye hardly move the lids: they slide on the ball by their own channel.
  vertex[Map::Muscle] = 1 - 0.9 * share;
  const int k = from_canthus(v.spoke);
  if (k % kLidSteps == 0) return;  // the corners of the eye stay
  const bool upper = k < kLidSteps;
  const double middle = std::sin(kPi * (k % kLidSteps) / kLidSteps);
  if (!upper) {
    // Undoes the factor above for the one muscle that is the lower lid's own.
    vertex[Map::LowerLid] = 0.1 * share * middle / vertex[Map::Muscle];
  }
  const double own = elevation[static_cast<std::size_t>(v.spoke)];
  const double opposite = elevation[static_cast<std::size_t>(opposite_on_lid(v.spoke))];
  // Both margins meet a fifth of the way above where the lower one rests, half-way near the
  // corners, which else would fold, and press by a trace.
  const double meet = mix(0.5, 0.74, smooth_step(0.0, 0.95, middle));
  const double press = std::min(1.0, 5 * middle) * (upper ? -0.028 : 0.004);
  const double target = mix(own, opposite, upper ? meet : 1 - meet) + press;
  // What lies above the fold stays, so that the lid unrolls from under it.
  const double turning = upper ? 1 - smooth_step(0.02, 0.39, from_margin) : share;
  vertex[Map::LidAngle] = turning * (own - target);
}

/// From 0 in the middle of a lip to 1 in the corner of the mouth, along an ellipse, so that the jaw
/// opens an oval with round ends: a lens looks cut out, and exponents above 2.15 tear the corner.
double towards_corner(double t, double exponent) {
  return 1 - power(std::max(0.0, 1 - power(t, exponent)), 1 / exponent);
}

void weigh_mouth(Vertex& vertex, const HalfVertex& v) {
  const double blend = smooth_step(0, 4, v.ring);
  const bool upper = v.spoke <= kMouthCornerSpoke;
  const double to_corner = along_lip(v.spoke);
  // The corner goes down by more than half of the way: with a third of it the opening is a bowl
  // below a flat upper lip.
  constexpr double kCorner = 0.53;
  // The border of the upper lip follows later than its edge: the red goes round the opening as a
  // ring, where tapering it would be a tent.
  const double outside = upper ? smooth_step(kLipContactRing, kLipBorderRing, v.ring) : 0.0;
  const double late = 0.55 * outside * smooth_step(0.95, 0.60, to_corner);
  // The edge of the lips is a trace squarer than an ellipse, for the web in the corner narrows it;
  // so is the border of the lower red, which else runs straight from the corner to the chin.
  const double outline =
      mix(upper ? 2.0 : 2.4, 2.12, smooth_step(kLipBorderRing + 1, kLipContactRing, v.ring));
  const double jaw =
      mix(upper ? 0.0 : 1.0, kCorner, power(towards_corner(to_corner, outline), 1 + late));
  vertex[Map::Jaw] = mix(vertex[Map::Jaw], jaw, blend);
  const double lower = smooth_step(9.5, 14.5, v.spoke);
  // Near the corner the lower lip stays with the upper one.
  vertex[Map::LowerLip] = mix(vertex[Map::LowerLip], smooth_step(12.5, 15.4, v.spoke), blend);
  // The levators lift the ends of the lip less than the rest, or it opens as a box, and the middle,
  // which the septum holds, less than beside it, or it becomes a beak.
  const double from_middle = from_lip_middle(v.spoke);
  const double lift =
      (1 - 0.9 * smooth_step(2.5, 11.5, from_middle)) * (1 - 0.07 * bell(from_middle, 2.6));
  vertex[Map::UpperLip] = mix(vertex[Map::UpperLip], (1 - lower) * lift, blend);
  const double red = smooth_step(kLipBorderRing - 5, kLipBorderRing, v.ring);
  vertex[Map::UpperRed] = red * (1 - lower);
  vertex[Map::LowerRed] = red * lower;
}

}  // namespace

double jaw_field(const Vec3& p) {
  // From the hinge to the line of the mouth.
  const double line = mix(kJawHinge.y, -2.50, saturate((p.z - kJawHinge.z) / 6.0));
  const double below = smooth_step(-1.15, 1.25, line - p.y);
  const double not_throat = smooth_step(0.8, 6.0, p.z + 0.35 * (p.y + 5.5));
  return below * not_throat;
}

double head_field(const Vec3& p) {
  // The plus matters: with the slope the other way the chin is squashed when the head turns.
  return mix(kShoulders, 1.0, smooth_step(-9.0, -3.9, p.y + 0.45 * (p.z - 1)));
}

void weigh_by_position(const Identity& who, Vertex& vertex) {
  const Vec3& p = vertex.position;
  vertex[Map::Muscle] = 1;
  vertex[Map::Jaw] = jaw_field(p);
  vertex[Map::Head] = head_field(p);
  vertex[Map::LidAngle] = 0;
  vertex[Map::Smile] = smile_field(p);
  vertex[Map::Forehead] = forehead_field(p);
  vertex[Map::LowerLip] = lower_lip_field(who, p);
  vertex[Map::UpperLip] = (1 - vertex[Map::LowerLip]) * (1 - 0.30 * nose_tip_field(p)) *
                          (1 - 0.40 * nose_wing_field(p));
  vertex[Map::UpperRed] = 0;
  vertex[Map::LowerRed] = 0;
  vertex[Map::Nasolabial] = nasolabial_field(p);
  vertex[Map::Glabella] = glabella_field(p);
}

void weigh_skin(const Identity& who, Skin& skin) {
  const auto elevation = margin_elevation(who.form, skin.half);
  for (std::size_t i = 0; i < skin.part.vertices.size(); ++i) {
    const HalfVertex& v = skin.half.vertices[skin.source[i]];
    Vertex& vertex = skin.part.vertices[i];
    weigh_by_position(who, vertex);
    if (v.patch == Patch::Eye) weigh_lid(vertex, v, elevation);
    if (v.patch == Patch::Mouth) weigh_mouth(vertex, v);
  }
}

}  // namespace aucast::facegen

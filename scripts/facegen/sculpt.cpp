#include "scripts/facegen/sculpt.h"

#include <array>

#include "scripts/facegen/anatomy.h"
#include "scripts/facegen/distance.h"
#include "scripts/facegen/polyline.h"

namespace aucast::facegen {

double round_cone(const Vec3& p, const Vec3& a, const Vec3& b, double radius_a, double radius_b) {
  // After Quilez' "round cone": the exact distance in the plane through the axis and the point.
  const Vec3 axis = b - a;
  const double length2 = glm::dot(axis, axis);
  const double slope = radius_a - radius_b;
  const double a2 = length2 - slope * slope;
  const Vec3 from_a = p - a;
  const double y = glm::dot(from_a, axis);
  const double z = y - length2;
  const Vec3 across = from_a * length2 - axis * y;
  const double x2 = glm::dot(across, across);
  const double y2 = y * y * length2;
  const double z2 = z * z * length2;
  const double sign = slope > 0 ? 1 : slope < 0 ? -1 : 0;
  const double k = sign * slope * slope * x2;
  if ((z > 0 ? 1 : -1) * a2 * z2 > k) return std::sqrt(x2 + z2) / length2 - radius_b;
  if ((y > 0 ? 1 : -1) * a2 * y2 < k) return std::sqrt(x2 + y2) / length2 - radius_a;
  return (std::sqrt(x2 * a2 / length2) + y * slope) / length2 - radius_a;
}

namespace {

double cranium(const Form& form, const Vec3& p) {
  double d = ellipsoid(p - Vec3{0, 4.75, 1.35}, {5.05, 5.75, 6.6});
  const Vec3 boss{1.7 - form.forehead_round, 5.6, 5.1 + 0.25 * form.forehead_round};
  d = melt(d, ellipsoid(p - boss, {2.5, 2.3, 2.45}), 1.4);                    // forehead
  d = melt(d, ellipsoid(p - Vec3{0, 2.9, -1.0}, {4.1, 3.9, 3.9}), 1.8);       // back of the head
  return melt(d, ellipsoid(p - Vec3{2.6, 3.2, 3.4}, {1.95, 2.8, 2.9}), 1.6);  // temple
}

/// Cheeks, jaw and chin. The wide seams matter: narrow ones give a bony, alien cheek.
double face_mass(const Form& form, const Vec3& p) {
  double d = ellipsoid(p - Vec3{0, 0.1, 3.5}, {4.0, 5.0, 4.35});
  d = melt(d, ellipsoid(p - Vec3{0, -2.25, 5.9}, {2.35, 2.35, 2.6 + form.muzzle}), 1.6);  // muzzle
  d = melt(d, ellipsoid(p - Vec3{2.1, -0.8, 5.6}, Vec3{1.75, 2.2, 1.95} + form.cheek),
           1.6);  // cheek
  d = melt(d,
           ellipsoid(rotated_y(p - Vec3{2.9 + form.cheekbone, 0.80, 5.3}, 0.5), {1.45, 1.25, 1.4}),
           1.5);
  d = melt(d, round_cone(p, {3.6 + form.cheekbone, 1.2, 4.6}, {4.0, 1.4, 1.8}, 0.55, 0.55),
           1.6);  // zygomatic arch
  const Vec3 angle{2.48 + form.jaw_width, -2.15 - form.jaw_drop, 2.7};
  d = melt(d, round_cone(p, {3.2, 1.0, 1.6}, angle, 1.03, 0.85), 1.6);  // ramus
  const Vec3 chin{0, -4.52 - form.chin_drop, 7.25 + form.chin_forward};
  const Vec3 mandible{0.60 + 0.8 * form.chin_width, chin.y + 0.05, chin.z - 0.4};
  // A wide jaw shows its edge.
  const double seam = 1.6 - 0.6 * std::max(0.0, form.jaw_width);
  // Between them it bows out: straight, the face is a wedge from the front.
  const Vec3 body = mix(angle, mandible, 0.70) + Vec3{0.40, -0.50, 0.20} * form.jaw_bow;
  d = melt(d, round_cone(p, angle, body, 0.84, 0.81), seam);
  d = melt(d, round_cone(p, body, mandible, 0.81, 0.78), seam);
  d = melt(d, ellipsoid(p - Vec3{2.2, -1.5, 4.2}, {1.28, 1.9, 2.2}), 1.5);  // below the cheekbone
  d = melt(d, ellipsoid(rotated_x(p - Vec3{2.75, -0.9, 3.1}, -0.25), {1.1, 2.1, 1.3}),
           1.2);  // masseter
  d = melt(d, ellipsoid(p - chin, {0.95 + form.chin_width, 0.92, 1.02}), 1.1);
  d = melt(d, ellipsoid(p - chin - Vec3{0, -0.02, 0.44}, {0.6 + form.chin_width, 0.55, 0.62}),
           0.7);  // its pad
  return melt(d, ellipsoid(p - Vec3{0, -3.8 - form.throat_drop, 4.5}, {2.0, 1.1, 2.7}),
              1.2);  // floor of the mouth
}

double with_brow_ridge(const Form& form, double d, const Vec3& p) {
  const double ridge = form.brow_ridge;
  constexpr Vec3 kArch{2.4, 4.25, 7.05};
  d = melt(d, round_cone(p, {0.75, 3.95, 7.55}, kArch, 0.55 + ridge, 0.55 + ridge), 0.8);
  d = melt(d, round_cone(p, kArch, {3.75, 3.55, 5.6}, 0.55 + ridge, 0.5), 0.8);
  return melt(d, ellipsoid(p - Vec3{0, 3.85, 7.4}, Vec3{0.85, 0.95, 0.82} + ridge), 0.9);
}

/// It leans forward: the column of the muscles behind, the throat in front of it, trapezius and
/// shoulder.
double neck_column(const Form& form, const Vec3& p) {
  const double wide = form.neck_width;
  double d = round_cone(p, {0, -1.0, 0.3}, {0, -11.5, -1.9}, 2.96 * wide, 2.90 * wide);
  const Vec3 throat{0, -4.4, 2.5 * wide - 0.4};
  d = melt(d, round_cone(p, throat, {0, -11.5, 1.75 * wide - 1.6}, 1.55 * wide, 1.45 * wide), 1.2);
  d = melt(d, ellipsoid(p - Vec3{1.9, -1.2, -0.9}, {1.6, 2.6, 2.0}), 1.5);  // splenius
  constexpr Vec3 kNape{0.9, -6.6, -2.2};
  d = melt(d, round_cone(p, {0.5, -2.2, -1.7}, kNape, 1.7, 1.8), 1.6);
  d = melt(d, round_cone(p, kNape, {3.8, -12.0, -4.4}, 1.8, 2.1), 1.6);
  return melt(d, round_cone(p, {2.2, -12.6, -1.9}, {8.0, -14.2, -1.9}, 2.3, 2.0), 2.5);
}

/// The column with the rope from behind the ear to the pit of the throat and the larynx.
double neck(const Form& form, const Vec3& p) {
  const double wide = form.neck_width;
  const auto [behind_ear, pit] = neck_rope(form);
  const double rope = round_cone(p, behind_ear, pit, 0.80 * wide, 0.58 * wide);
  const Vec3 larynx{0, -6.8, 3.75 * wide - 1.15};
  return melt(melt(neck_column(form, p), rope, 0.26),
              ellipsoid(p - larynx, Vec3{0.55, 1.1, 0.5} + form.larynx), 0.9);
}

/// The hollow of the eye, then the lids as a shell over the eyeball.
double with_orbit(const Form& form, double d, const Vec3& p) {
  const Vec3 hollow = rotated_y(p - kOrbit, 0.32);
  d = carve(d, ellipsoid(hollow, {1.45, 0.66, 1.18 + form.socket}), 0.8);
  // Thinner towards the temple: there the edge of the lids must lie far behind the cornea, or the
  // eye is a sliver from the side.
  const double thickness =
      mix(0.09, 0.03, smooth_step(2.3, 3.4, p.x) * smooth_step(0.85, 0.45, std::abs(p.y - 2.85)));
  // Below, the lid runs into the cheek without a step.
  const double seam =
      mix(mix(0.32, 0.80, smooth_step(2.4, 1.8, p.y)), 0.12, smooth_step(2.6, 3.4, p.x));
  return melt(d, glm::length(p - eye_centre(form)) - (kEyeRadius + thickness), seam);
}

/// The cheek falls back beside the wing of the nose, and the lip below it as far as the furrow:
/// else nose, cheek and lip are one sheet.
double beside_wing(const Vec3& p) {
  static constexpr std::array<Vec3, 3> kBelow{
      {{.70, -.70, .9}, {1.20, -.82, 1.0}, {1.50, -1.22, .30}}};
  const Vec3 beside{(p.x - 1.36) / 0.58, (p.y - 0.10) / 0.80, 0};
  return (0.36 * bell(beside) + 0.13 * Polyline(kBelow).strength({p.x, p.y}, 0.36)) *
         smooth_step(5.5, 6.8, p.z);
}

double with_nose(const Form& form, double d, const Vec3& p) {
  // The bridge melts widely into the cheeks, tip and wings closely; one seam for all makes a column
  // of the bridge or a blob of the tip.
  const double wide = form.bridge_width;
  const Vec3 hump{0, 1.6, 8.18 + form.nose_hump};
  const Vec3 low{0, 0.5, 8.78 + 0.5 * std::max(0.0, form.nose_forward)};
  double bridge = round_cone(p, {0, 3.05, 7.46}, hump, 0.36, 0.44 + wide);
  bridge = melt(bridge, round_cone(p, hump, low, 0.44 + wide, 0.52), 0.9);
  bridge = melt(bridge,
                round_cone(p, {0.12 + wide, 2.3, 7.00}, {0.62 + 0.5 * wide, 0.1, 7.78}, 0.38, 0.60),
                0.8);
  // Below the eyes it widens; the lids must stay where they are.
  const double flank =
      round_cone(p, {0.48 + wide, 1.10, 7.38}, {0.70 + 0.5 * wide, 0.35, 7.54}, 0.54, 0.78);
  bridge = melt(bridge, flank + 0.5 * smooth_step(1.4, 2.3, p.y), 0.9);
  d = melt(d, bridge, 1.2);
  const Vec3 q{p.x / form.nose_width, p.y, p.z};
  const Vec3 at{0, form.nose_up, form.nose_forward};
  double tip = ellipsoid(q - (Vec3{0, 0.06, 9.00} + at), Vec3{0.53, 0.46, 0.58} + form.nose_tip);
  tip = melt(tip, round_cone(q, Vec3{0, -0.40, 9.00} + at, {0, -0.66, 8.40}, 0.20, 0.21), 0.35);
  d = melt(d, tip, 0.60);
  // From the tip back to the cheek, thickest in the middle, its end below.
  const Vec3 front{0.46, 0.00 + 0.6 * form.nose_up, 8.82 + 0.6 * form.nose_forward};
  constexpr Vec3 kMiddle{0.75, -0.15, 8.42};
  double wing = round_cone(q, front, kMiddle, 0.25, 0.37);
  wing = melt(wing, round_cone(q, kMiddle, {0.84, -0.34, 8.10}, 0.37, 0.26), 0.3);
  return melt(d, wing, 0.17);
}

/// Depth of the fold of the upper lid and of the groove under the eye.
double lid_relief(const Identity& who, const Vec3& p) {
  const Vec3 eye = eye_centre(who.form);
  const double x = std::abs(p.x) - eye.x;
  const double y = p.y - eye.y;
  const double window =
      smooth_step(-1.35, -0.7, x) * (1 - smooth_step(0.9, 1.5, x)) * smooth_step(5.5, 6.3, p.z);
  const double inside = std::clamp(x, kInnerCanthus + 0.1, kOuterCanthus - 0.1);
  const double fold = lid_fold(who, inside);
  const double groove = lower_lid(who, inside) - 0.40;
  // Shallow where the lid is thin.
  const double deep = mix(0.09, 0.04, smooth_step(0.5, 1.1, x));
  return window * (deep * bell(y - fold, 0.10) + who.form.eye_bag * bell(y - groove, 0.16));
}

/// Depth of the groove round the wing of the nose.
double alar_groove(const Form& form, const Vec3& p) {
  const double x = std::abs(p.x) / form.nose_width;
  if (p.z <= 7.2 || x >= 1.9 || p.y >= 1.0 || p.y <= -1.4) return 0;
  static constexpr std::array<Vec3, 8> kLine{{{.46, .02, .012},
                                              {.61, .22, .045},
                                              {.82, .33, .076},
                                              {1.00, .24, .092},
                                              {1.115, .02, .104},
                                              {1.155, -.28, .104},
                                              {1.06, -.55, .075},
                                              {.92, -.72, .010}}};
  return 0.85 * Polyline(kLine).strength({x, p.y}, 0.16) * smooth_step(7.2, 7.7, p.z);
}

/// Depth (negative: height) of everything about the lips.
double mouth_relief(const Identity& who, const Vec3& p) {
  if (p.z <= 5.5 || p.y >= 0.2 || p.y <= -5) return 0;
  const double x = std::abs(p.x);
  const double y = p.y;
  const double on_lip = std::min(x, kMouthCorner);
  const double contact = lip_contact(who, on_lip);
  const double upper_height = std::max(upper_lip_border(who, on_lip) - contact, 0.05);
  const double lower_height = std::max(contact - lower_lip_border(who, on_lip), 0.05);
  const double t = saturate(x / kMouthCorner);
  const double fullness = power(1 - t * t, 0.6);
  double depth = 0;
  const double up = (y - contact) / upper_height;
  if (up > -0.5) depth -= 0.25 * who.form.lip_bulge * fullness * bell(up - 0.42, 0.60);
  const double down = (contact - y) / lower_height;
  if (down > -0.5) depth -= 0.30 * who.form.lip_bulge * fullness * bell(down - 0.45, 0.55);
  const double past_corner = smooth_step(kMouthCorner - 0.06, kMouthCorner + 0.20, x);
  depth += 0.14 * bell(y - contact, 0.085) * (1 - past_corner);
  depth += 0.020 * bell(Vec3{x - kMouthCorner - 0.02, y - contact, 0} / 0.30);  // dimple
  const double philtrum = who.form.philtrum * smooth_step(kPhiltrumFoot, kPhiltrumFoot + 0.40, y) *
                          smooth_step(kPhiltrumTop, kPhiltrumTop - 0.30, y);
  depth += philtrum * (0.055 * bell(x, 0.22) - 0.030 * bell(x - kPhiltrumRidge, 0.16));
  depth +=
      who.form.chin_fold * bell(y + 3.45, 0.35) * bell(x, 1.3);  // fold between lower lip and chin
  return depth * smooth_step(5.5, 6.8, p.z);
}

/// Depth of what falls back: the forehead above the brows, the root of the nose, the hollow below
/// the arch of the cheekbone.
double bony_hollows(const Form& form, const Vec3& p) {
  if (p.z < 1) return 0;
  const double x = std::abs(p.x);
  const double root = form.nose_root * bell(p.y - 2.9, 0.80) * smooth_step(0.85, 0.1, x) *
                      smooth_step(6.0, 7.2, p.z);
  // Between the inner corner of the eye and the root of the nose, or the root is a broad plateau.
  const double beside_root = form.inner_socket *
                             bell(Vec3{(x - 0.90) / 0.40, (p.y - 2.95) / 0.70, 0}) *
                             smooth_step(6.0, 7.0, p.z);
  const double below_arch = p.y + 0.75 - 0.28 * (p.z - 4.2);
  const double slope =
      form.forehead_slope * smooth_step(4.8, 7.6, p.y) * smooth_step(3.0, 6.5, p.z);
  return root + slope + beside_root +
         form.cheek_hollow * bell(Vec3{below_arch / 0.85, (p.z - 4.3) / 1.5, 0}) *
             smooth_step(1.5, 2.6, x);
}

/// Depth of the lines that a face keeps from its expressions: beside nose and mouth, and from the
/// corner of the mouth down.
double set_lines(const Form& form, const Vec3& p) {
  if (p.z <= 5 || p.y >= 0.6 || p.y <= -4.6) return 0;
  static constexpr std::array<Vec3, 3> kJowl{
      {{1.95, -2.75, 0.0}, {2.02, -3.30, 1.0}, {1.92, -3.95, 0.2}}};
  const double x = std::abs(p.x);
  return (form.furrow * Polyline(kFurrow).strength({x, p.y}, 0.22) +
          form.jowl * Polyline(kJowl).strength({x, p.y}, 0.26)) *
         smooth_step(5.0, 6.0, p.z);
}

}  // namespace

double fold_depth(const Identity& who, const Vec3& p) {
  return alar_groove(who.form, p) + set_lines(who.form, p);
}

double head_distance(const Identity& who, const Vec3& p) {
  // The face below the cheekbones is narrowed a little; it did more for the looks than any other
  // single number. The neck is not, or it is a tube that widens downwards.
  const double narrowing = smooth_step(1.6, -4.2, p.y) * smooth_step(-10.5, -8.0, p.y);
  const Vec3 q{soft_abs(p.x * (1 + who.form.narrowing * narrowing), 0.10), p.y, p.z};
  const Vec3 beside{soft_abs(p.x, 0.10), p.y, p.z};
  double d = melt(cranium(who.form, q), face_mass(who.form, q), 1.2);
  d = with_brow_ridge(who.form, d, q);
  d = melt(d, neck(who.form, beside), 1.3);
  d = with_orbit(who.form, d, q);
  d += lid_relief(who, p) + beside_wing(q);
  d = with_nose(who.form, d, q);
  return d + fold_depth(who, p) + mouth_relief(who, p) + bony_hollows(who.form, p);
}

double torso_distance(const Form& form, const Vec3& p) {
  const Vec3 q{soft_abs(p.x, 0.2), p.y, p.z};
  const double collar = neck_column(form, q) - 0.22;
  const double wide = form.neck_width;
  double body = round_cone(q, {2.4, -11.6, -1.5}, {9.2 + 2.5 * wide, -12.2, -1.9}, 2.6, 2.3);
  // The slope from neck to shoulder.
  body = melt(body, round_cone(q, {1.2, -8.9, -2.6}, {8.5, -11.2, -2.2}, 0.9, 1.3), 1.6);
  body = melt(body, ellipsoid(q - Vec3{0, -16.5, -0.1}, {9.5, 5.2, 4.4}), 2.0);
  return melt(collar, body, 1.4);
}

Distance head_of(const Identity& who) {
  return [&who](const Vec3& p) { return head_distance(who, p); };
}

Vec3 head_normal(const Identity& who, const Vec3& p, double step) {
  // Four corners of a tetrahedron give the gradient with four evaluations instead of six.
  static constexpr std::array<Vec3, 4> kCorners{{{1, -1, -1}, {-1, -1, 1}, {-1, 1, -1}, {1, 1, 1}}};
  Vec3 sum{0};
  for (const Vec3& corner : kCorners) sum += corner * head_distance(who, p + corner * step);
  return glm::normalize(sum);
}

Vec3 on_skin(const Identity& who, Vec3 p, int steps) {
  for (int i = 0; i < steps; ++i) {
    const double d = head_distance(who, p);
    p -= head_normal(who, p) * (d * 0.9);
    if (std::abs(d) < 1e-6) break;
  }
  return p;
}

double face_z(const Identity& who, double x, double y) {
  double z = 12;
  for (int i = 0; i < 400 && z > -6; ++i) {
    const double d = head_distance(who, {x, y, z});
    if (d < 1e-6) break;
    z -= d * 0.6;
  }
  return z;
}

Vec3 leave(const Vec3& origin, const Vec3& direction, const Distance& distance) {
  const Vec3 unit = glm::normalize(direction);
  double t = 16;
  for (int i = 0; i < 400 && t > 0; ++i) {
    const double d = distance(origin + unit * t);
    if (d < 1e-6) break;
    t -= d * 0.6;
  }
  return origin + unit * t;
}

}  // namespace aucast::facegen

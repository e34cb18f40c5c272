#include "scripts/facegen/anatomy.h"
#include "scripts/facegen/layout_builder.h"
#include "scripts/facegen/sculpt.h"

namespace aucast::facegen {
namespace {

using Ring = LayoutBuilder::Ring;

/// A spoke's place on the lid margin, in the front plane.
Vec3 lid_margin(const Identity& who, int spoke) {
  const int k = from_canthus(spoke);
  const bool upper = k < kLidSteps;
  const double t = (upper ? k : kEyeSpokes - k) / double{kLidSteps};
  const double eased = mix(t, 0.5 - 0.5 * std::cos(kPi * t), 0.55);
  const double dx = mix(kInnerCanthus, kOuterCanthus, eased);
  const Vec3 eye = eye_centre(who.form);
  return {eye.x + dx, eye.y + (upper ? upper_lid(who, dx) : lower_lid(who, dx)), 0};
}

/// Away from the opening: along the spoke at the corners, more and more upright between them.
Vec3 out_of_lid(const Identity& who, int spoke, const Vec3& border) {
  const int k = from_canthus(spoke);
  const Vec3 margin = lid_margin(who, spoke);
  const double upright = 0.6 * bell((k % kLidSteps) / (kLidSteps / 2.0) - 1, 0.9);
  const Vec3 along = glm::normalize(Vec3{border.x - margin.x, border.y - margin.y, 0});
  return glm::normalize(Vec3{along.x * (1 - upright),
                             along.y * (1 - upright) + upright * (k < kLidSteps ? 1 : -1), 0});
}

/// z of the front of a ball of radius `radius` about the eye's centre; far back beside it.
double ball_z(const Vec3& eye, const Vec3& p, double radius) {
  const double dx = p.x - eye.x;
  const double dy = p.y - eye.y;
  const double q = radius * radius - dx * dx - dy * dy;
  return q > 0 ? eye.z + std::sqrt(q) : -9.0;
}

/// The rings of a lid's edge: its outer edge, its inner edge on the eyeball, and two tucked in
/// behind it, so that no gap shows whatever the lid does.
Vec3 lid_edge(const Identity& who, int which, int spoke, const Vec3& border) {
  const Vec3 eye = eye_centre(who.form);
  const Vec3 margin = lid_margin(who, spoke);
  const Vec3 out = out_of_lid(who, spoke, border);
  const Vec3 outer = margin + out * 0.05;
  const double outer_z = face_z(who, outer.x, outer.y);
  // Near the corners the ball is far behind the skin; the edge does not follow it there.
  const double inner_z = std::max(ball_z(eye, margin, kEyeRadius + 0.02), outer_z - 0.17);
  const auto tucked = [&](double way, double clearance, double depth) {
    const Vec3 p = margin + out * way;
    return Vec3{p.x, p.y, std::max(ball_z(eye, p, kEyeRadius + clearance), inner_z - depth)};
  };
  switch (which) {
    case 0:
      return {outer.x, outer.y, outer_z};
    case 1:
      return {margin.x, margin.y, inner_z};
    case 2:
      return tucked(0.10, 0.01, 0.30);
    default:
      return tucked(0.30, 0.0, 0.7);
  }
}

/// A spoke's place on the border of the red of the lips, in the front plane.
Vec3 lip_border(const Identity& who, int spoke) {
  const double t = along_lip(spoke);
  const double x = t * kMouthCorner;
  const double y = spoke <= kMouthCornerSpoke ? upper_lip_border(who, x) : lower_lip_border(who, x);
  return {x + (spoke == kMouthCornerSpoke ? 0.03 : 0.0), y, 0};
}

Vec3 lip_contact_point(const Identity& who, int spoke) {
  const double x = along_lip(spoke) * (kMouthCorner - 0.05);
  return {x, lip_contact(who, x), 0};
}

/// Contact line, wet line and two rings inside the mouth.
Vec3 inner_lip(const Identity& who, int which, int spoke) {
  const Vec3 c = lip_contact_point(who, spoke);
  const double z = face_z(who, c.x, c.y);
  const double up = spoke < kMouthCornerSpoke ? 1 : spoke > kMouthCornerSpoke ? -1 : 0;
  const double t = along_lip(spoke);
  const double fade = 1 - 0.75 * t * t;
  // Between the lips a web of skin rounds off the corner of an open mouth.
  const double web = spoke == kMouthCornerSpoke ? 1 : 0;
  switch (which) {
    // The lips overlap by a trace here: if they only touched, rounding and the bend of the skin
    // would show the teeth through a slit.
    case 0:
      return {c.x, c.y - up * 0.030 * fade - (up > 0 ? 0.02 * bell(c.x, 0.36) : 0), z - 0.05};
    case 1:
      return {c.x * (0.985 - 0.040 * web), c.y, z - 0.22};
    case 2:
      return {c.x * (0.96 - 0.055 * web), c.y + up * 0.28 * fade, z - 0.42 - 0.1 * t};
    default:
      return {c.x * (0.93 - 0.065 * web), c.y + up * 0.75 * fade, z - 0.62 - 0.2 * t};
  }
}

/// A spoke's place on the rim of the nostril, in the front plane: a drop that leans outwards, seen
/// from the front as large as a face shows it.
Vec3 nostril_rim(const Identity& who, int spoke, double size) {
  const Form& form = who.form;
  const double angle = radians(135 - 45.0 * spoke);
  const Vec3 along{-0.172, 0.072, 0};
  const Vec3 across{0.092, 0.098, 0};
  const Vec3 at = Vec3{0.46, -0.55 + 0.5 * form.nose_up, 0} +
                  (along * std::sin(angle) + across * std::cos(angle)) * size;
  return {at.x * form.nose_width, at.y, 0};
}

/// Ring 1 lies on the skin round the rim, ring 2 is the rim, the others lead inwards.
Vec3 nostril_place(const Identity& who, int ring, int spoke, const Vec3& border) {
  const auto on_face = [&who](Vec3 p) {
    p.z = face_z(who, p.x, p.y);
    return p;
  };
  const Vec3 rim = on_face(nostril_rim(who, spoke, 1));
  switch (ring) {
    case 1:
      return on_skin(who, mix(rim, border, 0.40));
    case 2:
      return rim + Vec3{0, 0.02, -0.03};
    case 3:
      return on_face(nostril_rim(who, spoke, 0.9)) + Vec3{0, 0.12, -0.14};
    default:
      return on_face(nostril_rim(who, spoke, 0.7)) + Vec3{0, 0.36, -0.30};
  }
}

}  // namespace

void add_eye_patch(LayoutBuilder& builder) {
  const Identity& who = builder.who();
  const Ring border = builder.nodes(border_of(kEyeBlock));
  Ring outer = border;
  for (int ring = 1; ring <= kLidLastRing; ++ring) {
    Ring inner;
    for (int spoke = 0; spoke < kEyeSpokes; ++spoke) {
      const Vec3& from = builder.position(border[static_cast<std::size_t>(spoke)]);
      Vec3 p;
      if (ring < kLidMarginRing) {
        const Vec3 edge = lid_margin(who, spoke) + out_of_lid(who, spoke, from) * 0.05;
        p = mix(edge, from, kEyeRings[static_cast<std::size_t>(ring)]);
        p.z = face_z(who, p.x, p.y);
      } else {
        p = lid_edge(who, ring - kLidMarginRing, spoke, from);
      }
      inner.push_back(builder.add(p, Patch::Eye, ring, spoke));
    }
    builder.add_strip(outer, inner, true);
    outer = std::move(inner);
  }
}

void add_mouth_patch(LayoutBuilder& builder) {
  const Identity& who = builder.who();
  static constexpr std::array kRedRings{0.0, 0.22, 0.48, 0.75};  // border to contact line
  const Ring border = builder.nodes(border_of(kMouthBlock));
  Ring outer = border;
  for (int ring = 1; ring <= kLipLastRing; ++ring) {
    Ring inner;
    for (int spoke = 0; spoke < kMouthSpokes; ++spoke) {
      Vec3 p;
      if (ring < kLipBorderRing) {
        p = mix(lip_border(who, spoke), builder.position(border[static_cast<std::size_t>(spoke)]),
                kMouthRings[static_cast<std::size_t>(ring)]);
        p.z = face_z(who, p.x, p.y);
      } else if (ring < kLipContactRing) {
        p = mix(lip_border(who, spoke), lip_contact_point(who, spoke),
                kRedRings[static_cast<std::size_t>(ring - kLipBorderRing)]);
        p.z = face_z(who, p.x, p.y);
      } else {
        p = inner_lip(who, ring - kLipContactRing, spoke);
      }
      if (spoke == 0 || spoke == kMouthSpokes - 1) p.x = 0;
      inner.push_back(builder.add(p, Patch::Mouth, ring, spoke));
    }
    builder.add_strip(outer, inner, false);
    outer = std::move(inner);
  }
}

void add_nostril_patch(LayoutBuilder& builder) {
  const Identity& who = builder.who();
  constexpr int kSpokes = 8;
  const Ring border = builder.nodes(border_of(kNostrilBlock));
  Ring outer = border;
  for (int ring = 1; ring <= 4; ++ring) {
    Ring inner;
    for (int spoke = 0; spoke < kSpokes; ++spoke) {
      const Vec3& from = builder.position(border[static_cast<std::size_t>(spoke)]);
      inner.push_back(
          builder.add(nostril_place(who, ring, spoke, from), Patch::Nostril, ring, spoke));
    }
    builder.add_strip(outer, inner, true);
    outer = std::move(inner);
  }
  Vec3 middle{0};
  for (const std::uint32_t i : outer) middle += builder.position(i) / static_cast<double>(kSpokes);
  builder.add_lid(outer, builder.add(middle + Vec3{0, 0.1, -0.1}, Patch::Nostril, 5));
}

}  // namespace aucast::facegen

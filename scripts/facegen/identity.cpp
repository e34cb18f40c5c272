#include "scripts/facegen/identity.h"

#include <array>

#include "scripts/facegen/anatomy.h"

namespace aucast::facegen {
namespace {

/// The lids and the balls below them keep their form.
double away_from_eyes(const Vec3& p) {
  const Vec3 from_eye{std::abs(p.x) - kEyeCentre.x, p.y - kEyeCentre.y, 0};
  return p.z < 3.5 ? 1 : smooth_step(1.55, 2.6, glm::length(from_eye));
}

Vec3 shaped(const Identity& who, const Vec3& p) {
  const double free = away_from_eyes(p);
  Vec3 q = p;
  const double jaw = smooth_step(1.0, -3.2, p.y) * smooth_step(-9.0, -6.0, p.y);
  // The mouth keeps its width, or its inside would no longer fit.
  const double beside_mouth = smooth_step(1.6, 3.0, std::abs(p.x));
  q.x *= 1 + (who.jaw_width - 1) * jaw * beside_mouth * free;
  const double throat = smooth_step(-3.0, -9.0, p.y) * smooth_step(0.3, 2.0, std::abs(p.x));
  q.x *= 1 + (who.neck_width - 1) * throat;
  const double chin = smooth_step(-3.3, -4.6, p.y) * smooth_step(2.0, 5.0, p.z);
  q.y -= who.chin_length * chin;
  const double nose = bell(Vec3{p.x / 1.5, (p.y + 0.1) / 0.9, 0}) * smooth_step(7.4, 8.3, p.z);
  q.x *= 1 + (who.nose_width - 1) * nose;
  q.z += who.nose_length * bell(Vec3{p.x / 0.8, (p.y - 0.1) / 0.9, 0}) * smooth_step(7.6, 8.8, p.z);
  const double above = smooth_step(6.0, 9.0, p.y);
  q.y += (who.crown_height - 1) * (p.y - 6.0) * above;
  return q;
}

void tint(Vertex& vertex, const Vec3& factor) {
  for (int i = 0; i < 3; ++i) vertex.colour[i] = saturate(vertex.colour[i] * factor[i]);
}

void colour(const Identity& who, Part& part) {
  for (Vertex& vertex : part.vertices) {
    switch (part.material) {
      case face::Material::Skin:
        tint(vertex,
             mix(who.skin, who.lips, std::max(vertex[Map::UpperRed], vertex[Map::LowerRed])));
        break;
      case face::Material::Hair:
      case face::Material::Brow:
        tint(vertex, who.hair);
        break;
      case face::Material::Cloth:
        tint(vertex, who.cloth);
        break;
      case face::Material::Eye: {
        // Only the iris is strongly coloured.
        const Vec3& c = vertex.colour;
        if (std::max({c.x, c.y, c.z}) < 0.55) tint(vertex, who.iris);
        break;
      }
      default:
        break;
    }
  }
}

constexpr std::array<Identity, 1> kIdentities{{
    {"marek",
     1.12,
     0.30,
     1.18,
     0.10,
     1.10,
     0.97,
     {0.50, 0.42, 0.36},
     {0.58, 0.50, 0.46},
     {0.16, 0.17, 0.20},
     {0.42, 0.24, 0.14},
     {0.55, 1.0, 0.75}},
}};

}  // namespace

std::optional<Identity> identity_named(std::string_view name) {
  for (const Identity& identity : kIdentities) {
    if (identity.name == name) return identity;
  }
  return std::nullopt;
}

void apply(const Identity& identity, std::vector<Part>& parts) {
  for (Part& part : parts) {
    colour(identity, part);
    if (part.material == face::Material::Eye || part.material == face::Material::Teeth) continue;
    for (Vertex& vertex : part.vertices) vertex.position = shaped(identity, vertex.position);
  }
}

}  // namespace aucast::facegen

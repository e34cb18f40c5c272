#include "scripts/facegen/skin.h"

#include <utility>

#include "common/check.h"

namespace aucast::facegen {

std::uint32_t Skin::find(Patch patch, int ring, int spoke, int on_side) const {
  for (std::uint32_t i = 0; i < source.size(); ++i) {
    const HalfVertex& v = half.vertices[source[i]];
    if (v.patch == patch && v.ring == ring && v.spoke == spoke && side[i] != -on_side) return i;
  }
  AUCAST_CHECK(false);
  return 0;
}

Skin make_skin(HalfHead half) {
  Skin skin;
  skin.part.name = "skin";
  skin.part.material = face::Material::Skin;
  std::vector<std::uint32_t> mirror(half.vertices.size());
  for (std::uint32_t i = 0; i < half.vertices.size(); ++i) {
    mirror[i] = skin.part.add(half.vertices[i].position);
    skin.source.push_back(i);
    skin.side.push_back(half.vertices[i].on_midline ? 0 : 1);
  }
  for (std::uint32_t i = 0; i < half.vertices.size(); ++i) {
    if (half.vertices[i].on_midline) continue;
    mirror[i] = skin.part.add(half.vertices[i].position * Vec3{-1, 1, 1});
    skin.source.push_back(i);
    skin.side.push_back(-1);
  }
  for (const Quad& q : half.quads) {
    skin.part.add_quad(q[0], q[1], q[2], q[3]);
    skin.part.add_quad(mirror[q[0]], mirror[q[3]], mirror[q[2]], mirror[q[1]]);
  }
  skin.half = std::move(half);
  return skin;
}

}  // namespace aucast::facegen

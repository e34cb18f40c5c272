#include "scripts/facegen/head.h"

#include <utility>

#include "scripts/facegen/asymmetry.h"
#include "scripts/facegen/brows_lashes.h"
#include "scripts/facegen/creases.h"
#include "scripts/facegen/eyes.h"
#include "scripts/facegen/hair.h"
#include "scripts/facegen/mouth_inside.h"
#include "scripts/facegen/occlusion.h"
#include "scripts/facegen/paint.h"
#include "scripts/facegen/proportions.h"
#include "scripts/facegen/relax.h"
#include "scripts/facegen/shirt.h"
#include "scripts/facegen/skin.h"
#include "scripts/facegen/weights.h"

namespace aucast::facegen {

std::vector<Part> make_head(const Identity& who) {
  HalfHead half = lay_out_half_head(who);
  relax(who, half);
  Skin skin = make_skin(std::move(half));
  weigh_skin(who, skin);
  paint_skin(who, skin);
  Part left_eye = make_eye(who, 1);
  Part right_eye = make_eye(who, -1);
  Part hair = make_hair(who);
  Part shirt = make_shirt(who);
  tint_scalp(who, skin, scalp_of(who));
  {
    // Rays from the skin to the hair give blocky patches along the hairline: shade_under_hair.
    const RayScene body(std::array<const Part*, 4>{&skin.part, &left_eye, &right_eye, &shirt});
    const RayScene skin_only(std::array<const Part*, 1>{&skin.part});
    const RayScene outside(std::array<const Part*, 3>{&skin.part, &hair, &shirt});
    bake_occlusion(skin.part, body, {128, 4.0, 0.34, 3});
    lighten_sockets(skin);
    shade_inner_lips(skin);
    shade_under_hair(who, skin, hair);
    bake_occlusion(left_eye, skin_only, {96, 3.0, 0.60, 1});
    bake_occlusion(right_eye, skin_only, {96, 3.0, 0.60, 1});
    bake_occlusion(hair, outside, {96, 4.0, 0.40, 1});
    bake_occlusion(shirt, outside, {96, 6.0, 0.25, 1});
  }
  std::vector<Part> parts;
  Part bag = make_mouth_bag(skin);
  Part lashes = make_lashes(who, skin);
  std::vector<Part> creases = make_creases(who, skin);
  parts.push_back(std::move(skin.part));
  parts.push_back(std::move(left_eye));
  parts.push_back(std::move(right_eye));
  parts.push_back(make_teeth(Jawbone::Upper));
  parts.push_back(make_teeth(Jawbone::Lower));
  parts.push_back(make_tongue());
  parts.push_back(std::move(bag));
  parts.push_back(std::move(shirt));
  parts.push_back(std::move(hair));
  parts.push_back(make_brow(who, 1));
  parts.push_back(make_brow(who, -1));
  parts.push_back(std::move(lashes));
  for (Part& crease : creases) parts.push_back(std::move(crease));
  make_uneven(who.askew, parts);
  shorten_middle(who.form, parts);
  return parts;
}

std::string head_file(const std::vector<Part>& parts) {
  face::FaceMesh mesh;
  std::vector<face::Polygon> polygons;
  for (const Part& part : parts) {
    face::MeshPart range;
    range.name = part.name;
    range.material = part.material;
    range.vertex_begin = static_cast<std::uint32_t>(mesh.positions.size());
    range.vertex_count = static_cast<std::uint32_t>(part.vertices.size());
    for (const Vertex& v : part.vertices) {
      mesh.positions.emplace_back(v.position);
      mesh.colours.emplace_back(glm::vec3{v.colour}, static_cast<float>(v.alpha));
      mesh.occlusion.push_back(static_cast<float>(v.occlusion));
      mesh.gloss.push_back(static_cast<float>(v.gloss));
      for (std::size_t m = 0; m < kMapNames.size(); ++m) {
        mesh.maps[std::string{kMapNames[m]}].push_back(static_cast<float>(v.maps[m]));
      }
    }
    for (face::Polygon polygon : part.polygons) {
      for (std::uint32_t& corner : polygon.corners) corner += range.vertex_begin;
      polygons.push_back(polygon);
    }
    mesh.parts.push_back(std::move(range));
  }
  return face::format_ply(mesh, polygons);
}

}  // namespace aucast::facegen

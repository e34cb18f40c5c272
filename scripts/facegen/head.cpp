#include "scripts/facegen/head.h"

#include <algorithm>
#include <array>
#include <cmath>
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

namespace {

bool is_finite(double number) {
  return std::isfinite(static_cast<float>(number));  // as the file has it
}

bool is_finite(const Vertex& vertex) {
  for (int axis = 0; axis < 3; ++axis) {
    if (!is_finite(vertex.position[axis]) || !is_finite(vertex.colour[axis])) return false;
  }
  return is_finite(vertex.alpha) && is_finite(vertex.occlusion) && is_finite(vertex.gloss) &&
         std::all_of(vertex.maps.begin(), vertex.maps.end(),
                     [](double value) { return is_finite(value); });
}

Result<void> check_finite(const Part& part) {
  const bool good = std::all_of(part.vertices.begin(), part.vertices.end(),
                                [](const Vertex& vertex) { return is_finite(vertex); });
  if (good) return {};
  const bool line = part.material == face::Material::Crease;
  return Error{ErrorKind::BadData,
               "these measures give no head, and no mesh was written: the part '" + part.name +
                   (line ? "' is not on the skin everywhere; lower 'uneven' or 'forehead_up' of "
                           "[lines], or bring the measures of [form] nearer to those in people/"
                         : "' has a place that is no number; bring the measures of [form] and "
                           "[hair] nearer to those in people/")};
}

}  // namespace

Result<std::vector<Part>> make_head(const Identity& who) {
  HalfHead half = lay_out_half_head(who);
  relax(who, half);
  Skin skin = make_skin(std::move(half));
  weigh_skin(who, skin);
  paint_skin(who, skin);
  Part left_eye = make_eye(who, 1);
  Part right_eye = make_eye(who, -1);
  Part hair = make_hair(who);
  Part shirt = make_shirt(who);
  // Before rays go there: among places that are no numbers they would not come to an end.
  for (const Part* const part : std::array<const Part*, 3>{&skin.part, &hair, &shirt}) {
    if (auto good = check_finite(*part); !good) return good.error();
  }
  std::vector<Part> creases = make_creases(who, skin);
  for (const Part& crease : creases) {
    if (auto good = check_finite(crease); !good) return good.error();
  }
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
  for (const Part& part : parts) {
    if (auto good = check_finite(part); !good) return good.error();
  }
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

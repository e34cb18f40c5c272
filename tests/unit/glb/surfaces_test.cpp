#include "client/glb/surfaces.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/unit/face/small_face.h"
#include "tests/unit/glb/added_parts.h"

namespace aucast::glb {
namespace {

using test::add_part;

TEST(SurfacesOf, AFaceWithHairOfBothColoursHasASurfaceOfEach) {
  face::Face face = face::test::small_face();
  const face::MeshPart skin = face.mesh.parts.front();
  add_part(face, "hair", face::Material::Hair);
  add_part(face, "temples", face::Material::GreyHair);
  const std::vector<Surface> surfaces = surfaces_of(face);
  for (const Look look : {Look::Hair, Look::GreyHair}) {
    const auto found = std::find_if(surfaces.begin(), surfaces.end(),
                                    [look](const Surface& one) { return one.look == look; });
    ASSERT_NE(found, surfaces.end());
    EXPECT_EQ(found->vertices.size(), skin.vertex_count);
  }
}

TEST(ColoursOf, ACreaseIsSeenAsFarAsTheSkinKeepsIt) {
  face::Face face = face::test::small_face();
  add_part(face, "crease_brow", face::Material::Crease);
  face.channels.push_back({"crease_brow", Side::Both, 1});
  for (glm::vec4& colour : face.mesh.colours) colour = {0.25F, 0.5F, 0.75F, 0.5F};
  for (const float kept : {0.0F, 0.4F}) {
    face.channels.back().kept = kept;
    const std::vector<Surface> surfaces = surfaces_of(face);
    const auto creases = std::find_if(surfaces.begin(), surfaces.end(),
                                      [](const Surface& one) { return one.look == Look::Creases; });
    ASSERT_NE(creases, surfaces.end());
    ASSERT_EQ(creases->vertices.size(), face.mesh.parts.back().vertex_count);
    for (const glm::vec4& colour : colours_of(face, *creases)) {
      EXPECT_EQ(colour, glm::vec4(0, 0, 0, kept * 0.25F));
    }
  }
}

const Surface& named(const std::vector<Surface>& surfaces, std::string_view name) {
  static const Surface kNone;
  const auto found = std::find_if(surfaces.begin(), surfaces.end(),
                                  [name](const Surface& one) { return one.name == name; });
  EXPECT_NE(found, surfaces.end()) << name;
  return found == surfaces.end() ? kNone : *found;
}

TEST(SurfacesOf, PartsOfOneLookAreOneSurfaceAndEyeballsEachTheirOwn) {
  face::Face face = face::test::small_face();
  add_part(face, "teeth", face::Material::Teeth);
  add_part(face, "gums", face::Material::Mouth);
  add_part(face, "brows", face::Material::Brow);
  add_part(face, "lashes", face::Material::Lash);
  add_part(face, "shirt", face::Material::Cloth);
  const std::vector<Surface> surfaces = surfaces_of(face);
  EXPECT_EQ(surfaces.front().name, "skin");
  ASSERT_EQ(surfaces.size(), 6U);
  const std::size_t skin = surfaces.front().vertices.size();
  EXPECT_EQ(named(surfaces, "mouth").vertices.size(), 2 * skin);
  EXPECT_EQ(named(surfaces, "brows").vertices.size(), 2 * skin);
  EXPECT_EQ(named(surfaces, "clothes").vertices.size(), skin);
  EXPECT_EQ(named(surfaces, "left_eyeball").vertices.front(), face.mesh.parts[1].vertex_begin);
  EXPECT_TRUE(named(surfaces, "mouth").morphs());
  EXPECT_FALSE(named(surfaces, "clothes").morphs());
  EXPECT_FALSE(named(surfaces, "left_eyeball").morphs());
}

TEST(SurfacesOf, TrianglesNameTheSurfacesOwnVertices) {
  face::Face face = face::test::small_face();
  add_part(face, "teeth", face::Material::Teeth);
  add_part(face, "gums", face::Material::Mouth);
  for (const Surface& surface : surfaces_of(face)) {
    for (const auto& triangle : surface.triangles) {
      for (const std::uint32_t corner : triangle) ASSERT_LT(corner, surface.vertices.size());
    }
  }
  // The second part's come behind the first one's.
  const std::vector<Surface> surfaces = surfaces_of(face);
  const Surface& mouth = named(surfaces, "mouth");
  const Surface& skin = named(surfaces, "skin");
  const auto count = static_cast<std::uint32_t>(skin.vertices.size());
  ASSERT_EQ(mouth.triangles.size(), 2 * skin.triangles.size());
  for (std::size_t i = 0; i < skin.triangles.size(); ++i) {
    EXPECT_EQ(mouth.triangles[i], skin.triangles[i]);
    for (std::size_t k = 0; k < 3; ++k) {
      ASSERT_EQ(mouth.triangles[skin.triangles.size() + i][k], skin.triangles[i][k] + count);
    }
  }
}

TEST(SurfacesOf, APartOfNothingIsNoSurfaceAndItsCreaseKeepsItsNumber) {
  face::Face face = face::test::small_face();
  face::MeshPart none;
  none.name = "crease_lost";
  none.material = face::Material::Crease;
  face.mesh.parts.push_back(none);
  add_part(face, "crease_brow", face::Material::Crease);
  const std::vector<Surface> surfaces = surfaces_of(face);
  const Surface& creases = named(surfaces, "creases");
  ASSERT_EQ(creases.creases.size(), creases.vertices.size());
  EXPECT_EQ(creases.creases.front(), 1U) << "the deformer counts the lost one too";
}

TEST(ColoursOf, ShadeIsPartOfTheColourAndAlphaIsNot) {
  face::Face face = face::test::small_face();
  for (glm::vec4& colour : face.mesh.colours) colour = {0.5F, 0.4F, 0.3F, 0.8F};
  std::fill(face.mesh.occlusion.begin(), face.mesh.occlusion.end(), 1.0F);
  face.mesh.occlusion.front() = 0;
  const std::vector<Surface> surfaces = surfaces_of(face);
  const auto colours = colours_of(face, surfaces.front());
  EXPECT_EQ(colours.back(), glm::vec4(0.5F, 0.4F, 0.3F, 0.8F));
  EXPECT_LT(colours.front().r, 0.3F);
  EXPECT_GT(colours.front().r, 0) << "some light comes from everywhere";
  EXPECT_EQ(colours.front().a, 0.8F);
}

TEST(PositionsOf, LinesLieABitOffTheSkinWhicheverWayTheyAreWound) {
  face::Face face = face::test::small_face();
  add_part(face, "brows", face::Material::Brow);
  std::vector<Surface> surfaces = surfaces_of(face);
  EXPECT_EQ(positions_of(face, named(surfaces, "skin"))[5], face.mesh.positions[5]);
  Surface brows = named(surfaces, "brows");
  for (const bool turned : {false, true}) {
    if (turned) {
      for (auto& triangle : brows.triangles) std::swap(triangle[0], triangle[1]);
    }
    const auto positions = positions_of(face, brows);
    for (std::size_t i = 0; i < positions.size(); i += 50) {
      const glm::vec3 own = face.mesh.positions[brows.vertices[i]];
      EXPECT_NEAR(glm::distance(positions[i], own), 0.035F, 1e-4F);
      EXPECT_GT(positions[i].z, own.z) << "out of the face, which looks along +z";
    }
  }
}

TEST(NormalsOf, AreMeansByAreaAndNeverNothing) {
  face::Face face;
  face.mesh.positions = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 1}, {9, 9, 9}};
  Surface surface;
  surface.vertices = {0, 1, 2, 3, 4};
  // A large triangle in the plane of x and y, and a small one in that of y and z.
  surface.triangles = {{0, 1, 2}, {0, 2, 3}};
  const auto normals = normals_of(face, surface);
  EXPECT_EQ(normals[1], glm::vec3(0, 0, 1));
  EXPECT_EQ(normals[3], glm::vec3(1, 0, 0));
  EXPECT_NEAR(normals[0].z / normals[0].x, 4, 1e-5F);
  EXPECT_NEAR(glm::length(normals[0]), 1, 1e-6F);
  EXPECT_EQ(normals[4], glm::vec3(0, 0, 1)) << "of no triangle";
}

}  // namespace
}  // namespace aucast::glb

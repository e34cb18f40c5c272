#include "client/glb/surfaces.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/unit/face/small_face.h"

namespace aucast::glb {
namespace {

TEST(SurfacesOf, AFaceWithHairOfBothColoursHasASurfaceOfEach) {
  face::Face face = face::test::small_face();
  const face::MeshPart skin = face.mesh.parts.front();
  for (const face::Material hair : {face::Material::Hair, face::Material::GreyHair}) {
    face::MeshPart part = skin;
    part.name = hair == face::Material::Hair ? "hair" : "temples";
    part.material = hair;
    face.mesh.parts.push_back(part);
  }
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
  face::MeshPart part = face.mesh.parts.front();
  part.name = "crease_brow";
  part.material = face::Material::Crease;
  face.mesh.parts.push_back(part);
  face.channels.push_back({part.name, Side::Both, 1});
  for (glm::vec4& colour : face.mesh.colours) colour = {0.25F, 0.5F, 0.75F, 0.5F};
  for (const float kept : {0.0F, 0.4F}) {
    face.channels.back().kept = kept;
    const std::vector<Surface> surfaces = surfaces_of(face);
    const auto creases = std::find_if(surfaces.begin(), surfaces.end(),
                                      [](const Surface& one) { return one.look == Look::Creases; });
    ASSERT_NE(creases, surfaces.end());
    ASSERT_EQ(creases->vertices.size(), part.vertex_count);
    for (const glm::vec4& colour : colours_of(face, *creases)) {
      EXPECT_EQ(colour, glm::vec4(0, 0, 0, kept * 0.25F));
    }
  }
}

}  // namespace
}  // namespace aucast::glb

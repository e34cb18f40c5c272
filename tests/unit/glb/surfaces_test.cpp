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

}  // namespace
}  // namespace aucast::glb

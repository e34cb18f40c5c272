#include "client/view/style.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

namespace aucast::view {
namespace {

TEST(Layers, AreNamedInAnyOrder) {
  const auto layers = parse_layers("muscles,wireframe");
  ASSERT_TRUE(layers);
  Layers wanted;
  wanted.textured = false;
  wanted.wireframe = true;
  wanted.muscles = true;
  EXPECT_EQ(*layers, wanted);
  EXPECT_EQ(parse_layers("wireframe,muscles").value(), *layers);
}

TEST(Layers, AreReadAsTheyAreWritten) {
  for (const LayerName& one : kLayerNames) {
    Layers layers;
    layers.*one.member = true;
    EXPECT_EQ(parse_layers(format_layers(layers)).value(), layers) << one.name;
  }
  EXPECT_EQ(format_layers({}), "textured");
}

TEST(Layers, ATransparentSurfaceIsTextured) {
  EXPECT_TRUE(parse_layers("transparent")->textured);
  EXPECT_FALSE(parse_layers("transparent,polygons")->textured);
}

TEST(Layers, AnotherWordIsRefusedWithAllNames) {
  for (const char* text : {"", "muscle", "muscles,", ",muscles", "muscles, wireframe", "Muscles"}) {
    const auto layers = parse_layers(text);
    ASSERT_FALSE(layers) << text;
    EXPECT_EQ(layers.error().kind, ErrorKind::Usage);
    EXPECT_NE(layers.error().message.find("jaw-tags"), std::string::npos);
  }
}

TEST(KeyLight, StandsWhereTheAnglesSay) {
  EXPECT_LT(glm::length(key_light(0, 0, 1).direction - glm::vec3(0, 0, 1)), 1e-6F);
  EXPECT_LT(glm::length(key_light(90, 0, 1).direction - glm::vec3(1, 0, 0)), 1e-6F);
  EXPECT_GT(key_light(0, 90, 1).direction.z, 0.1F);  // never quite overhead
  const glm::vec3 usual = glm::normalize(KeyLight{}.direction);
  EXPECT_LT(glm::length(key_light(-38, 34, 1).direction - usual), 0.01F);
}

}  // namespace
}  // namespace aucast::view

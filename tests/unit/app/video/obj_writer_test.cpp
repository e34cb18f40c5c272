#include "client/app/video/obj_writer.h"

#include <cstdlib>

#include <gtest/gtest.h>

namespace aucast::app {
namespace {

face::FaceMesh two_parts() {
  face::FaceMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0.1F, 1.0F / 3.0F, -8.7F}, {9, 9, 9}};
  mesh.triangles = {{0, 1, 2}, {3, 3, 3}};
  mesh.parts = {{"skin", face::Material::Skin, 0, 3, 0, 1},
                {"left_eye", face::Material::Eye, 3, 1, 1, 1}};
  return mesh;
}

TEST(FormatObj, HasTheSkinOnlyInOrderCountedFromOne) {
  const face::FaceMesh mesh = two_parts();
  const std::string text = format_obj(mesh, mesh.positions);
  EXPECT_NE(text.find("v 0.000000000 0.000000000 0.000000000\nv 1.000000000"), std::string::npos);
  EXPECT_NE(text.find("\nf 1 2 3\n"), std::string::npos);
  EXPECT_EQ(text.find("v 9"), std::string::npos);
  EXPECT_EQ(text.find("f 4"), std::string::npos);
}

TEST(FormatObj, ReadsBackBitForBit) {
  const face::FaceMesh mesh = two_parts();
  const std::string text = format_obj(mesh, mesh.positions);
  const std::size_t line = text.find("v 0.1");
  ASSERT_NE(line, std::string::npos);
  char* next = nullptr;
  EXPECT_EQ(std::strtof(text.c_str() + line + 2, &next), 0.1F);
  EXPECT_EQ(std::strtof(next, &next), 1.0F / 3.0F);
  EXPECT_EQ(std::strtof(next, &next), -8.7F);
}

}  // namespace
}  // namespace aucast::app

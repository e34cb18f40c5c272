#include "client/face/face.h"

#include <gtest/gtest.h>

#include "tests/unit/face/shipped_data.h"
#include "tests/unit/face/small_face.h"

namespace aucast::face {
namespace {

using aucast::test::TempFolder;
using test::kData;

TEST(SideAt, IsTheSubjectsOwnByTheSignOfX) {
  EXPECT_EQ(side_at(1), Side::Left);
  EXPECT_EQ(side_at(-1), Side::Right);
  EXPECT_EQ(side_at(0.049F), Side::Both);
  EXPECT_EQ(side_at(-0.049F), Side::Both);
  EXPECT_EQ(side_at(0.05F), Side::Left);
}

TEST(LoadFace, OurOwnFormatComesBeforeTheClassicOne) {
  const TempFolder folder;
  test::write_small_face(folder);
  folder.write("faceline.dat", "no points");
  const auto face = load_face(folder.path(), kData);
  ASSERT_TRUE(face.has_value()) << face.error().message;
  EXPECT_FALSE(face->classic);
}

TEST(LoadFace, AFolderThatIsNoFaceLacksTheFileOfOne) {
  const TempFolder folder;
  const auto face = load_face(folder.path(), kData);
  ASSERT_FALSE(face.has_value());
  EXPECT_EQ(face.error().kind, ErrorKind::Unreadable);
  EXPECT_NE(face.error().message.find("face.toml"), std::string::npos) << face.error().message;
}

TEST(LoadFace, AClassicFaceIsCalledAfterItsFolder) {
  const TempFolder folder;
  folder.write("faceline.dat", "3\n0 0 1\n-1 0 1\n0 1 1\n");
  folder.write("index.dat", "1\n1 2 3 1000\n");
  folder.write("muscle.dat", "0\n");
  const auto face = load_face(folder.path(), kData);
  ASSERT_TRUE(face.has_value()) << face.error().message;
  EXPECT_TRUE(face->classic);
  EXPECT_EQ(face->name, folder.path().filename().string());
  const auto same = load_face(folder.path() / "", kData);
  ASSERT_TRUE(same.has_value()) << same.error().message;
  EXPECT_EQ(same->name, face->name) << "with a slash at its end";
}

TEST(Lids, RiseSteeplyAtFirstAndEndAtTheirMost) {
  const Lids lids{0.3F};
  EXPECT_EQ(lids.raised(0), 0.0F);
  EXPECT_FLOAT_EQ(lids.raised(1), 0.3F);
  float before = 0;
  for (int percent = 1; percent <= 100; ++percent) {
    const float activation = static_cast<float>(percent) / 100;
    const float raised = lids.raised(activation);
    EXPECT_GT(raised, before) << percent;
    EXPECT_GE(raised, 0.3F * activation - 1e-6F) << percent;
    before = raised;
  }
  EXPECT_GT(lids.raised(0.25F), 1.5F * 0.25F * 0.3F) << "a 5B has to show";
}

TEST(FaceMesh, AMapThatIsMissingIsWhatIsAskedForInItsPlace) {
  FaceMesh mesh;
  mesh.maps["jaw"] = {0.25F, 1};
  EXPECT_EQ(find_map(mesh, "head"), nullptr);
  EXPECT_EQ(map_at(find_map(mesh, "head"), 7, 0.5F), 0.5F);
  ASSERT_NE(find_map(mesh, "jaw"), nullptr);
  EXPECT_EQ(map_at(find_map(mesh, "jaw"), 0, 0.5F), 0.25F);
}

TEST(FaceMesh, OnlyCreasesAreDrawnByExpressions) {
  for (std::size_t i = 0; i < kMaterialNames.size(); ++i) {
    const auto material = static_cast<Material>(i);
    EXPECT_EQ(is_crease({"part", material, 0, 0, 0, 0}), kMaterialNames[i] == "crease");
  }
}

}  // namespace
}  // namespace aucast::face

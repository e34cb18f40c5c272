#include <gtest/gtest.h>

#include "common/files.h"
#include "scripts/facegen/head.h"
#include "scripts/facegen/identity.h"
#include "tests/support/temp_folder.h"

namespace aucast::facegen {
namespace {

/// What is wrong with such a file; empty: nothing.
std::string complaint(const std::string& text) {
  const test::TempFolder folder;
  const auto read = read_identity(folder.write("anna.toml", text));
  if (read) return {};
  EXPECT_EQ(read.error().kind, ErrorKind::BadData);
  return read.error().message;
}

TEST(Person, AFileAloneMakesAThirdOne) {
  const test::TempFolder folder;
  const auto anna = read_identity(folder.write("anna.toml", R"(
like = "marek"
[form]
jaw_bow = 0.2
[hair]
grey = false
[colours]
hair = [0.2, 0.1, 0.05]
)"));
  ASSERT_TRUE(anna) << anna.error().message;
  const auto marek = identity_named("marek");
  ASSERT_TRUE(marek) << marek.error().message;
  EXPECT_EQ(anna->form.jaw_bow, 0.2);
  EXPECT_EQ(anna->form.jaw_drop, marek->form.jaw_drop);
  EXPECT_TRUE(marek->hair.grey);
  EXPECT_FALSE(anna->hair.grey);
  EXPECT_EQ(anna->hair.combed.size(), marek->hair.combed.size());
  EXPECT_EQ(anna->colours.hair, Vec3(0.2, 0.1, 0.05));

  const auto data = find_data_folder({});
  ASSERT_TRUE(data) << data.error().message;
  const auto committed = read_file(*data / "faces/marek/mesh.ply");
  ASSERT_TRUE(committed) << committed.error().message;
  const auto his = face::parse_ply(*committed, "marek");
  const auto hers = face::parse_ply(head_file(make_head(*anna)), "anna");
  ASSERT_TRUE(hers && his);
  EXPECT_TRUE(hers->triangles == his->triangles) << "one set of muscles serves both";
  EXPECT_FALSE(hers->positions == his->positions);
}

TEST(Person, MistakesAreNamedWithTheirPlace) {
  EXPECT_EQ(complaint("like = \"default\"\n"), "");
  EXPECT_NE(complaint("like = \"default\"\n[form]\njaw = 1\n").find("anna.toml:3:1: "),
            std::string::npos);
  EXPECT_NE(complaint("like = \"default\"\n[form]\nmuzzle = 99\n").find("anna.toml:3:"),
            std::string::npos);
  EXPECT_NE(complaint("like = \"default\"\n[colours]\nlip = [1, 0]\n").find("wants 3 numbers"),
            std::string::npos);
  EXPECT_NE(complaint("like = \"default\"\n[hair]\nhairline = [[1, 0, 0, 0], [1, 0, 0, 0]]\n")
                .find("ascend"),
            std::string::npos);
  EXPECT_NE(complaint("[form]\n").find("neither [hair] nor like"), std::string::npos);
}

TEST(Person, OnlyThoseInTheFolderHaveNames) {
  EXPECT_TRUE(identity_named("default"));
  EXPECT_EQ(identity_named("nobody").error().kind, ErrorKind::Usage);
}

}  // namespace
}  // namespace aucast::facegen

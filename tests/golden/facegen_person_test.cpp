#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include <glm/common.hpp>

#include "client/face/face.h"
#include "common/files.h"
#include "scripts/facegen/anatomy.h"
#include "scripts/facegen/head.h"
#include "scripts/facegen/identity.h"
#include "scripts/facegen/proportions.h"
#include "scripts/facegen/variation.h"
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
  const auto head = make_head(*anna);
  ASSERT_TRUE(head) << head.error().message;
  const auto hers = face::parse_ply(head_file(*head), "anna");
  ASSERT_TRUE(hers && his);
  EXPECT_TRUE(hers->triangles == his->triangles) << "one set of muscles serves both";
  EXPECT_FALSE(hers->positions == his->positions);
}

TEST(Person, MayBeLikeOneWhoIsLikeAThird) {
  const test::TempFolder people;
  const std::string line = "[0,0,0, 1,1,1, 2,2,2, 3,3,3, 4,4,4]";
  people.write("cleo.toml", "[hair]\nhairline = [[0, 1,1,1], [1, 2,2,2]]\ncombed = [" + line + "," +
                                line + "]\ngrey = true\n");
  people.write("anna.toml", "like = \"cleo\"\n[form]\njaw_bow = 0.2\nmuzzle = 0.1\n");
  const auto bert = read_identity(
      people.write("bert.toml", "like = \"anna\"\n[form]\nmuzzle = 0.3\n"), people.path());
  ASSERT_TRUE(bert) << bert.error().message;
  EXPECT_EQ(bert->form.muzzle, 0.3);
  EXPECT_EQ(bert->form.jaw_bow, 0.2) << "of anna";
  EXPECT_TRUE(bert->hair.grey) << "of cleo";
}

TEST(Person, LikeHerselfByAnyWayIsRefused) {
  const test::TempFolder people;
  const auto anna = people.write("anna.toml", "like = \"bert\"\n");
  people.write("bert.toml", "like = \"cleo\"\n");
  people.write("cleo.toml", "\nlike = \"anna\"\n");
  const auto round = read_identity(anna, people.path());
  ASSERT_FALSE(round);
  EXPECT_EQ(round.error().kind, ErrorKind::BadData);
  EXPECT_NE(round.error().message.find("cleo.toml:2:8: like leads back to 'anna'"),
            std::string::npos)
      << round.error().message;
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

TEST(Person, TheKeyThatIsWrongIsTheOneThatIsNamed) {
  const auto hair = [](const std::string& line) {
    return complaint("like = \"default\"\n[hair]\n" + line + "\n");
  };
  const std::string line =
      "[[1,1,1], [1,1,1], [1,1,1], [1,1,1], [1,1,1], "
      "[1,1,1], [1,1,1], [1,1,1], [1,1,1]]";
  for (const char* const key : {"hairline", "guides", "locks", "combed"}) {
    for (const char* const value : {" = \"x\"", " = 5"}) {
      EXPECT_NE(hair(key + std::string(value)).find(std::string(key) + " must be an array of rows"),
                std::string::npos)
          << hair(key + std::string(value));
    }
  }
  EXPECT_NE(hair("guides = [" + line + "]").find("guides must be two lines or more"),
            std::string::npos);
  std::string locks;
  for (std::size_t i = 0; i < kLocks; ++i) locks += "[0.5, 0, 0, 1, 0.1, 0, 0, 1],";
  EXPECT_EQ(hair("locks = [" + locks + "]"), "");
  EXPECT_NE(hair("locks = [" + locks + "[0.5, 0, 0, 1, 0.1, 0, 0, 1]]").find("must be 16 or fewer"),
            std::string::npos);
  for (const char* const measure : {"neck_width", "nose_width", "ear_size", "eye_apart"}) {
    EXPECT_NE(complaint("like = \"default\"\n[form]\n" + std::string(measure) + " = 0\n")
                  .find(std::string(measure) + " is 0, must be above 0"),
              std::string::npos);
  }
}

TEST(Person, MeasuresThatGiveNoHeadAreRefused) {
  const auto who = identity_named("default");
  ASSERT_TRUE(who) << who.error().message;
  const auto refused = [](const Identity& person) {
    const auto head = make_head(person);
    if (head) return std::string();
    EXPECT_EQ(head.error().kind, ErrorKind::BadData);
    return head.error().message;
  };
  Identity thin = *who;
  thin.form.neck_width = 0.6;
  EXPECT_NE(refused(thin).find("'left_crease_neck' is not on the skin"), std::string::npos);
  Identity flat = *who;
  flat.form.nose_width = 0;
  EXPECT_NE(refused(flat).find("'skin' has a place that is no number"), std::string::npos);
}

TEST(Person, VariesTowardsAnotherInEveryMeasureThatMayVary) {
  const auto who = identity_named("default");
  ASSERT_TRUE(who) << who.error().message;
  const auto other = identity_named(who->varies_towards);
  ASSERT_TRUE(other) << other.error().message;
  EXPECT_EQ(identity_named(other->varies_towards)->form.brow_up, who->form.brow_up);
  const Identity third = varied(*who, *other, 7);
  for (const Measure& measure : form_measures()) {
    const double before = who->form.*measure.member;
    const bool moves = measure.varies && other->form.*measure.member != before;
    EXPECT_EQ(third.form.*measure.member != before, moves) << measure.name;
  }
  EXPECT_EQ(third.form.eye_apart, who->form.eye_apart) << "it would not fit face.toml";
  EXPECT_EQ(varied(*who, *other, 0).form.brow_up, who->form.brow_up);
}

TEST(Person, EveryMeasureOfTheFormHasOneName) {
  const std::span<const Measure> measures = form_measures();
  EXPECT_EQ(measures.size() * sizeof(double), sizeof(Form)) << "one is missing in the table";
  std::set<std::string_view> names;
  for (const Measure& measure : measures) EXPECT_TRUE(names.insert(measure.name).second);
}

TEST(Person, OnlyThoseInTheFolderHaveNames) {
  EXPECT_TRUE(identity_named("default"));
  EXPECT_EQ(identity_named("nobody").error().kind, ErrorKind::Usage);
}

// What face.toml and muscles.toml say again of the head that was made.
TEST(Person, TheFacesTurnAboutTheLandmarksOfTheHead) {
  const auto data = find_data_folder({});
  ASSERT_TRUE(data) << data.error().message;
  for (const char* const name : {"default", "marek"}) {
    SCOPED_TRACE(name);
    const auto who = identity_named(name);
    ASSERT_TRUE(who) << who.error().message;
    const auto face = face::load_face(*data / "faces" / name, *data);
    ASSERT_TRUE(face) << face.error().message;
    ASSERT_TRUE(face->jaw);
    EXPECT_EQ(face->jaw->hinge, glm::vec3{kJawHinge});
    Vec3 eye = eye_centre(who->form);
    eye.y -= middle_drop(who->form, eye.y);
    ASSERT_EQ(face->eyes.size(), 2U);
    for (const int side : {1, -1}) {
      const glm::vec3 there = face->eyes[side > 0 ? 0 : 1].centre;
      EXPECT_LT(glm::length(Vec3{there} - Vec3{eye.x * side, eye.y, eye.z}), 1e-5);
    }
    const auto smiles = std::find_if(face->muscles.begin(), face->muscles.end(), [](auto& muscle) {
      return muscle.name.ends_with("zygomaticus_major");
    });
    ASSERT_NE(smiles, face->muscles.end());
    const auto* const muscle = std::get_if<face::LinearMuscle>(&smiles->shape);
    ASSERT_NE(muscle, nullptr);
    EXPECT_EQ(glm::abs(muscle->attachment), glm::vec3{kSmileAttachment});
  }
}

}  // namespace
}  // namespace aucast::facegen

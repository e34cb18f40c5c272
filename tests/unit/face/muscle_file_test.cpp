#include "client/face/muscle_file.h"

#include <gtest/gtest.h>

#include "tests/unit/face/small_face.h"

namespace aucast::face {
namespace {

/// Tables of muscles as they are read for a mesh with the map "half".
struct ReadMuscles {
  std::vector<Muscle> muscles;
  std::string complaint;  ///< after the name of the file; empty: none
};

ReadMuscles read_tables(const std::string& text) {
  const auto document = parse_toml(text, "m");
  EXPECT_TRUE(document.has_value()) << (document ? "" : document.error().message);
  if (!document) return {};
  Problems problems("m");
  TableReader reader(*document, problems);
  ReadMuscles read;
  read.muscles = read_muscles(reader, test::small_mesh(), problems);
  if (const auto result = problems.result(); !result) read.complaint = result.error().message;
  return read;
}

/// A linear muscle with a line more, which is the tenth.
std::string linear_with(const std::string& line, const std::string& zone = "45.0") {
  return "[[muscle]]\nname = \"a\"\nkind = \"linear\"\nattachment = [3.0, 1.0, 6.0]\n"
         "insertion = [1.0, -2.0, 8.0]\nzone_deg = " +
         zone + "\nfalloff_start = 0\nfalloff_finish = 4\n\n" + line + "\n";
}

std::vector<MuscleShape> one_of_each_kind() {
  LinearMuscle linear;
  linear.attachment = {3, 1, 6};
  linear.insertion = {1, -2, 8};
  linear.zone_rad = 0.8F;
  linear.falloff_finish = 6;
  MouthSphincter mouth_ring;
  mouth_ring.centre = {1, 2, 3};
  EyeSphincter eye_ring;
  eye_ring.centre = {1, 2, 3};
  SheetMuscle strip;
  strip.attachment = {2, 7, 7};
  strip.insertion = {1, 3, 8};
  LocalPull local;
  local.centre = {1, -4, 8};
  local.direction = {0.5F, 0.3F, 0.1F};
  return {linear, mouth_ring, eye_ring, strip, local};
}

TEST(MuscleFile, ASideIsThatOfTheInsertionOrTheCentre) {
  for (const MuscleShape& shape : one_of_each_kind()) {
    EXPECT_EQ(x_of(shape), 1.0F) << shape.index();
    EXPECT_EQ(x_of(mirrored(shape)), -1.0F) << shape.index();
  }
}

TEST(MuscleFile, AMirroredMuscleMovesTheMirroredPointTheMirroredWay) {
  const glm::vec3 points[] = {
      {1.1F, 2.2F, 3.1F}, {1.2F, -1.5F, 7.9F}, {1.5F, 4, 7.8F}, {0.9F, -4.1F, 8.1F}, {2, 5, 7.5F}};
  for (const MuscleShape& shape : one_of_each_kind()) {
    const MuscleShape other = mirrored(shape);
    bool moved = false;
    for (const glm::vec3& point : points) {
      const glm::vec3 way = displacement(shape, point, 1);
      const glm::vec3 mirror = displacement(other, {-point.x, point.y, point.z}, 1);
      EXPECT_EQ(mirror, glm::vec3(-way.x, way.y, way.z)) << shape.index();
      EXPECT_EQ(displacement(mirrored(other), point, 1), way) << "twice is as it was";
      moved = moved || way != glm::vec3(0);
    }
    EXPECT_TRUE(moved) << "no point lies in the zone of kind " << shape.index();
  }
}

TEST(MuscleFile, AKeyThatIsLeftOutIsTheOneThatIsNamed) {
  const std::vector<std::string> tables{
      "kind = 'linear'\nattachment = [3, 1, 6]\ninsertion = [1, -2, 8]\nzone_deg = 45\n"
      "falloff_start = 0\nfalloff_finish = 4\n",
      "kind = 'eye_sphincter'\ncentre = [1, 2, 3]\nsemi_axes = [2, 1]\ndepth = 1\n",
      "kind = 'mouth_sphincter'\ncentre = [1, 2, 3]\nsemi_axes = [2, 1]\ndepth = 1\n",
      "kind = 'sheet'\nattachment = [3, 1, 6]\ninsertion = [1, -2, 8]\nwidth = 2\ndepth = 1\n",
      "kind = 'pull'\ncentre = [1, 2, 3]\ndirection = [1, 0, 0]\nradii = [1, 1, 1]\n"};
  for (const std::string& table : tables) {
    const std::string whole = "name = 'a'\n" + table;
    EXPECT_EQ(read_tables("[[muscle]]\n" + whole).complaint, "");
    for (std::size_t begin = 0; begin < whole.size();) {
      const std::size_t end = whole.find('\n', begin) + 1;
      const std::string key = whole.substr(begin, whole.find(' ', begin) - begin);
      const std::string rest = whole.substr(0, begin) + whole.substr(end);
      const std::string said = read_tables("[[muscle]]\n" + rest).complaint;
      EXPECT_TRUE(said.ends_with("'" + key + "' is missing")) << said;
      begin = end;
    }
  }
}

TEST(MuscleFile, AMirroredTableIsTwoMusclesLeftBeforeRight) {
  const ReadMuscles read = read_tables(
      linear_with("mirrored = true\nmask = \"half\"\nmask_alone = true\nyields_to_lids = true\n"
                  "activation_max = 1.3"));
  EXPECT_EQ(read.complaint, "");
  ASSERT_EQ(read.muscles.size(), 2U);
  EXPECT_EQ(read.muscles[0].name, "left_a");
  EXPECT_EQ(read.muscles[1].name, "right_a");
  EXPECT_EQ(x_of(read.muscles[0].shape), 1.0F);
  EXPECT_EQ(x_of(read.muscles[1].shape), -1.0F);
  for (const Muscle& muscle : read.muscles) {
    EXPECT_EQ(muscle.mask, "half");
    EXPECT_TRUE(muscle.mask_alone);
    EXPECT_TRUE(muscle.yields_to_lids);
    EXPECT_EQ(muscle.activation_max, 1.3F);
  }
}

TEST(MuscleFile, WhatIsNotSaidIsAsTheFormatHasIt) {
  const ReadMuscles read = read_tables(
      linear_with("") +
      "[[muscle]]\nname = \"b\"\nkind = \"sheet\"\nattachment = [2.0, 7.0, 7.0]\n"
      "insertion = [2.0, 3.0, 8.0]\nwidth = 3\ndepth = 2\n"
      "[[muscle]]\nname = \"c\"\nkind = \"eye_sphincter\"\ncentre = [2.0, 3.0, 7.0]\n"
      "semi_axes = [2.0, 1.0]\ndepth = 2\n"
      "[[muscle]]\nname = \"d\"\nkind = \"mouth_sphincter\"\ncentre = [0.0, -2.0, 8.0]\n"
      "semi_axes = [2.0, 2.0]\ndepth = 2\n");
  EXPECT_EQ(read.complaint, "");
  ASSERT_EQ(read.muscles.size(), 4U);
  EXPECT_FALSE(read.muscles[0].mask_alone);
  EXPECT_FALSE(read.muscles[0].yields_to_lids);
  EXPECT_EQ(std::get<LinearMuscle>(read.muscles[0].shape).cap, 0.95F);
  EXPECT_EQ(std::get<SheetMuscle>(read.muscles[1].shape).peak, 0.7F);
  const auto& eye_ring = std::get<EyeSphincter>(read.muscles[2].shape);
  EXPECT_EQ(eye_ring.bulge, 30.0F);
  EXPECT_EQ(eye_ring.upper_share, 0.3F);
  EXPECT_EQ(eye_ring.lower_share, 0.7F);
  EXPECT_EQ(std::get<MouthSphincter>(read.muscles[3].shape).protrusion, 10.0F);
  for (const Muscle& muscle : read.muscles) EXPECT_EQ(muscle.activation_max, 2.0F) << muscle.name;
  EXPECT_TRUE(read_tables("").muscles.empty());
}

TEST(MuscleFile, LimitsHoldToTheLastNumberThatIsAllowed) {
  EXPECT_EQ(read_tables(linear_with("cap = 1")).complaint, "");
  EXPECT_EQ(read_tables(linear_with("cap = 0.01")).complaint, "");
  EXPECT_EQ(read_tables(linear_with("", "89.9")).complaint, "");
  EXPECT_EQ(read_tables(linear_with("cap = 0")).complaint,
            "m:10:7: cap is 0, must be above 0 to 1");
  EXPECT_EQ(read_tables(linear_with("cap = 1.01")).complaint,
            "m:10:7: cap is 1.01, must be above 0 to 1");
  EXPECT_EQ(read_tables(linear_with("activation_max = 0.1")).complaint, "");
  EXPECT_EQ(read_tables(linear_with("activation_max = 2")).complaint, "");
  EXPECT_EQ(read_tables(linear_with("activation_max = 0")).complaint,
            "m:10:18: activation_max is 0, must be above 0 to 2");
  EXPECT_EQ(read_tables(linear_with("activation_max = 2.1")).complaint,
            "m:10:18: activation_max is 2.1, must be above 0 to 2");
  EXPECT_EQ(read_tables(linear_with("", "0")).complaint,
            "m:6:12: zone_deg is 0, must be above 0 and below 90");
}

TEST(MuscleFile, ASphinctersDivisorMayBeNegativeButNotSmall) {
  const auto complaint = [](const std::string& bulge) {
    return read_tables(
               "[[muscle]]\nname = \"c\"\nkind = \"eye_sphincter\"\n"
               "centre = [2.0, 3.0, 7.0]\nsemi_axes = [2.0, 1.0]\ndepth = 2\nbulge = " +
               bulge + "\n")
        .complaint;
  };
  EXPECT_EQ(complaint("1"), "");
  EXPECT_EQ(complaint("-1"), "");
  EXPECT_EQ(complaint("0.99"), "m:7:9: bulge must be at least 1, or at most -1");
  EXPECT_EQ(complaint("-0.5"), "m:7:9: bulge must be at least 1, or at most -1");
  EXPECT_EQ(complaint("0"), "m:7:9: bulge must be at least 1, or at most -1");
}

TEST(MuscleFile, AMuscleOfTheMiddleCannotBeMirrored) {
  std::string text = linear_with("mirrored = true");
  text = test::replaced(text, "[1.0, -2.0, 8.0]", "[0.0, -2.0, 8.0]");
  EXPECT_EQ(read_tables(text).complaint,
            "m:10:12: mirrored needs the insertion or centre at x > 0, the left side");
}

TEST(MuscleFile, AMirroredMuscleMayNotMeetOneOfItsOwnName) {
  const std::string text =
      linear_with("mirrored = true") + test::replaced(linear_with(""), "\"a\"", "\"right_a\"");
  EXPECT_EQ(read_tables(text).complaint, "m:12:8: name 'right_a' is there twice");
}

}  // namespace
}  // namespace aucast::face

#include "client/face/classic_folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <sstream>

#include <glm/geometric.hpp>

#include "client/face/face_deformer.h"
#include "client/face/muscle_mixer.h"
#include "tests/support/seeded.h"
#include "tests/support/temp_folder.h"
#include "tests/unit/face/bad_file.h"
#include "tests/unit/face/shipped_data.h"
#include "tests/unit/face/small_face.h"

namespace aucast::face {
namespace {

using aucast::test::Seeded;
using aucast::test::TempFolder;
using test::BadFile;
using test::kData;
using test::replaced;

// A face of our own in the classic format: six points of half a face, two quads on the cheek and a
// triangle in the middle that is its own mirror's neighbour.
//   1 (0,2)   2 (-1,2)
//   3 (0,0)   4 (-1,0)
//   5 (0,-2)  6 (-2,-1)
constexpr std::string_view kPoints = R"(6
0.0   2.0  8.0
-1.0  2.0  7.5
0.0   0.0  9.0
-1.0  0.0  8.0
0.0  -2.0  8.5
-2.0 -1.0  6.5
)";
constexpr std::string_view kFolderRows = R"(3
1 2 4 3
1000 3 4 5
4 6 1000 5
)";
constexpr std::string_view kMuscles = R"(2

L_Zygomatic_Major
-1.0 -1.0 8.0
-2.0  2.0 6.0
0.1  6.0  60.0  1.0

R_Zygomatic_Major
1.0 -1.0 8.0
2.0  2.0 6.0
0.1  6.0  60.0  1.0
)";

struct Files {
  std::string faceline{kPoints};
  std::string index{kFolderRows};
  std::string muscle{kMuscles};
  std::string jaw;
};

Result<Face> load(const TempFolder& folder, const Files& files) {
  folder.write("faceline.dat", files.faceline);
  folder.write("index.dat", files.index);
  folder.write("muscle.dat", files.muscle);
  if (!files.jaw.empty()) folder.write("jaw.dat", files.jaw);
  return load_face(folder.path(), kData);
}

Face loaded(const Files& files = {}) {
  const TempFolder folder;
  auto face = load(folder, files);
  EXPECT_TRUE(face.has_value()) << (face.has_value() ? "" : face.error().message);
  return face.has_value() ? *std::move(face) : Face{};
}

TEST(ClassicFolder, PointsThenTheMirrorsOfThoseOffTheMiddle) {
  const Face face = loaded();
  EXPECT_TRUE(face.classic);
  EXPECT_EQ(face.mesh.positions, (std::vector<glm::vec3>{{0, 2, 8},
                                                         {-1, 2, 7.5F},
                                                         {0, 0, 9},
                                                         {-1, 0, 8},
                                                         {0, -2, 8.5F},
                                                         {-2, -1, 6.5F},
                                                         {1, 2, 7.5F},
                                                         {1, 0, 8},
                                                         {2, -1, 6.5F}}));
  EXPECT_EQ(face.mesh.triangles.size(), 2U * 4U);
  ASSERT_EQ(face.mesh.parts.size(), 1U);
  EXPECT_EQ(face.mesh.parts[0].triangle_count, 8U);
}

TEST(ClassicFolder, TrianglesLookOutwardsWhicheverWayTheRowsRun) {
  Files turned;
  turned.index = "3\n3 4 2 1\n1000 5 4 3\n5 6 1000 4\n";
  for (const Files& files : {Files{}, turned}) {
    const Face face = loaded(files);
    for (const auto& [a, b, c] : face.mesh.triangles) {
      const auto& p = face.mesh.positions;
      EXPECT_GT(glm::cross(p[b] - p[a], p[c] - p[a]).z, 0);
    }
  }
}

TEST(ClassicFolder, RepeatedPolygonsAreDroppedWithAWord) {
  Files files;
  files.index = "4\n1 2 4 3\n1000 3 4 5\n4 6 1000 5\n4 3 1 2\n";
  const Face face = loaded(files);
  EXPECT_EQ(face.mesh.triangles.size(), 8U);
  ASSERT_FALSE(face.remarks.empty());
  EXPECT_EQ(face.remarks[0], "index.dat: 2 repeated polygons were dropped");
}

TEST(ClassicFolder, NamesStayAndSidesGoByTheSignOfX) {
  const Face face = loaded();
  ASSERT_EQ(face.channels.size(), 2U);
  EXPECT_EQ(face.channels[0].name, "L_Zygomatic_Major");
  EXPECT_EQ(face.channels[0].side, Side::Right);
  EXPECT_EQ(face.channels[1].side, Side::Left);
  EXPECT_EQ(face.channels[0].activation_max, 4.0F);
  EXPECT_FALSE(face.jaw.has_value());
}

TEST(ClassicFolder, OurActionUnitsPlayOnItsMuscles) {
  const Face face = loaded();
  std::vector<float> activations(2);
  mix(face, frame_from_terms(std::vector<AuTerm>{{12, Side::Left, 50}}), Mixer::Maximum,
      activations);
  EXPECT_FLOAT_EQ(activations[0], 0.0F);
  EXPECT_FLOAT_EQ(activations[1], 0.75F);
}

TEST(ClassicFolder, WhatHasNoMuscleIsSaidOnce) {
  const Face face = loaded();
  ASSERT_EQ(face.remarks.size(), 1U);
  EXPECT_EQ(face.remarks[0].substr(0, 49), "this face has no muscle that shows AU 1, 2, 4, 5,");
  EXPECT_FALSE(face.recordings.contains(1));
  EXPECT_TRUE(face.recordings.contains(12));
}

TEST(ClassicFolder, AJawComesFromItsTagFileOnly) {
  Files files;
  files.jaw = "2\n5 1.0\n6 0.5\n";
  const Face face = loaded(files);
  ASSERT_TRUE(face.jaw.has_value());
  EXPECT_EQ(face.mesh.maps.at("jaw"), (std::vector<float>{0, 0, 0, 0, 1, 0.5F, 0, 0, 0.5F}));
  FaceDeformer deformer(face);
  const std::vector<glm::vec3>& out = deformer.deform(test::only(face, "jaw", 4)).positions;
  const double angle = 4 * std::numbers::pi / 180;
  EXPECT_NEAR(out[4].y, -2 * std::cos(angle) - 8.5 * std::sin(angle), 1e-5);
  EXPECT_NEAR(out[4].z, -2 * std::sin(angle) + 8.5 * std::cos(angle), 1e-5);
  EXPECT_EQ(out[3], face.mesh.positions[3]);
}

class BadClassicFile : public ::testing::TestWithParam<BadFile> {};

TEST_P(BadClassicFile, IsRefusedWithPlaceAndCause) {
  const BadFile& bad = GetParam();
  Files files;
  files.jaw = "1\n5 1.0\n";
  std::string& text = bad.file == "faceline.dat" ? files.faceline
                      : bad.file == "index.dat"  ? files.index
                      : bad.file == "jaw.dat"    ? files.jaw
                                                 : files.muscle;
  text = replaced(text, bad.from, bad.to);
  const TempFolder folder;
  const auto face = load(folder, files);
  ASSERT_FALSE(face.has_value());
  EXPECT_EQ(face.error().kind, ErrorKind::BadData);
  EXPECT_EQ(face.error().message, (folder.path() / bad.file).string() + bad.message);
}

const std::vector<BadFile> kBadClassic = {
    {"faceline.dat", "6\n", "7\n", ":8:1: the file ends before x of point 7"},
    {"faceline.dat", "6\n", "5\n",
     ":7:1: the file should end here, but goes on with '-2.0': is the count in its first line "
     "right?"},
    {"faceline.dat", "6\n", "2\n", ":1:1: the number of points is 2, must be from 3 to 100000"},
    {"faceline.dat", "6\n", "six\n", ":1:1: the number of points is 'six', not a whole number"},
    {"faceline.dat", "7.5", "nan", ":3:12: z of point 2 is not a finite number"},
    {"faceline.dat", "7.5", "7,5", ":3:12: z of point 2 is '7,5', not a number"},
    {"faceline.dat", "7.5", "1e9", ":3:12: z of point 2 is 1e+09, must be from -1e+06 to 1e+06"},
    {"index.dat", "1 2 4 3", "1 2 7 3", ":2:5: a corner of row 1 is 7, but there are 6 points"},
    {"index.dat", "1 2 4 3", "1 2 0 3", ":2:5: a corner of row 1 is 0, must be from 1 to 1000"},
    {"index.dat", "1 2 4 3", "1 1 1000 3", ":2:10: row 1 has fewer than three different corners"},
    {"index.dat", "3\n", "4\n", ":5:1: the file ends before a corner of row 4"},
    {"muscle.dat", "2\n", "3\n", ":12:1: the file ends before the name of muscle 3"},
    {"muscle.dat", "R_Zyg", "L_Zyg", ":8:1: the muscle 'L_Zygomatic_Major' is there twice"},
    {"muscle.dat", "60.0", "90",
     ":6:11: the zone of L_Zygomatic_Major is 90, must be above 0 "
     "and below 90"},
    {"muscle.dat", "0.1  6.0", "6.1  6.0",
     ":6:6: the fall-off finish of L_Zygomatic_Major must be above its start"},
    {"muscle.dat", "-2.0  2.0 6.0", "-1.0 -1.0 8.0",
     ":5:11: insertion and attachment of L_Zygomatic_Major are the same point"},
    {"muscle.dat", "L_Zyg", "L\x01Zyg",
     ":3:1: the name of muscle 1 'L\\x01Zygomatic_Major' must be plain text of at most 64 "
     "letters"},
    {"jaw.dat", "5 1.0", "7 1.0", ":2:1: the point of row 1 is 7, must be from 1 to 6"},
    {"jaw.dat", "5 1.0", "5 1.5", ":2:3: the weight of row 1 is 1.5, must be from 0 to 1"},
};
INSTANTIATE_TEST_SUITE_P(All, BadClassicFile, ::testing::ValuesIn(kBadClassic));

TEST(ClassicFolder, AMissingFileIsUnreadable) {
  for (const auto* name : {"index.dat", "muscle.dat"}) {
    const TempFolder folder;
    ASSERT_TRUE(load(folder, {}).has_value());
    std::filesystem::remove(folder.path() / name);
    const auto face = load_face(folder.path(), kData);
    ASSERT_FALSE(face.has_value());
    EXPECT_EQ(face.error().kind, ErrorKind::Unreadable);
  }
}

TEST(ClassicFolder, CountsHaveTheirLimits) {
  const auto complaint = [](const Files& files) {
    const TempFolder folder;
    const auto face = load(folder, files);
    EXPECT_FALSE(face.has_value());
    return face.has_value() ? std::string()
                            : face.error().message.substr(folder.path().string().size() + 1);
  };
  Files files;
  files.faceline = "100001\n";
  EXPECT_EQ(complaint(files),
            "faceline.dat:1:1: the number of points is 100001, must be from 3 to 100000");
  files = {};
  files.index = "0\n";
  EXPECT_EQ(complaint(files), "index.dat:1:1: the number of rows is 0, must be from 1 to 200000");
  files.index = "200001\n";
  EXPECT_EQ(complaint(files),
            "index.dat:1:1: the number of rows is 200001, must be from 1 to 200000");
  files = {};
  files.muscle = "1001\n";
  EXPECT_EQ(complaint(files),
            "muscle.dat:1:1: the number of muscles is 1001, must be from 0 to 1000");
  files = {};
  files.jaw = "7\n";
  EXPECT_EQ(complaint(files), "jaw.dat:1:1: the number of jaw points is 7, must be from 1 to 6");
}

TEST(ClassicFolder, PointThousandMarksATriangleThoughThereIsOne) {
  Files files;
  std::string points = "1002\n";
  for (int i = 1; i <= 1002; ++i) {
    points += "-" + std::to_string(i) + " " + std::to_string(i % 7) + " 1\n";
  }
  files.faceline = points;
  files.index = "2\n1000 999 1001 1002\n1 2 3 1001\n";
  const Face face = loaded(files);
  EXPECT_EQ(face.mesh.positions.size(), 2U * 1002U);
  EXPECT_EQ(face.mesh.triangles.size(), 2U * 3U) << "a triangle and a quad, and their mirrors";
}

TEST(ClassicFolder, AMuscleMayNotBeCalledAsTheJaw) {
  Files files;
  files.jaw = "1\n5 1.0\n";
  files.muscle = replaced(files.muscle, "L_Zygomatic_Major", "jaw");
  const TempFolder folder;
  const auto face = load(folder, files);
  ASSERT_FALSE(face.has_value());
  EXPECT_NE(face.error().message.find("there is a muscle named jaw beside the jaw"),
            std::string::npos);
}

/// A table of AUs for classic faces of our own.
Result<Face> loaded_with(const std::string& table, const Files& files = {}) {
  const TempFolder folder;
  const TempFolder data;
  std::filesystem::create_directory(data.path() / "faces");
  data.write("faces/classic_aus.toml", table);
  static_cast<void>(load(folder, files));
  return load_face(folder.path(), data.path());
}

TEST(ClassicFolder, AMusclesNameMayHaveItsSideInFrontAndAnyCapitals) {
  const std::string table =
      "format = 1\n[muscles]\nsmile = [\"Zygomatic_Major\", \"Zygomaticus\"]\n"
      "[[au]]\nnumber = 12\ndrive = { smile = 1.5 }\n";
  for (const auto* name : {"Left_Zygomatic_Major", "right_zygomatic_major", "L_ZYGOMATICUS",
                           "r_Zygomaticus", "zygomaticus"}) {
    Files files;
    files.muscle = replaced(files.muscle, "L_Zygomatic_Major", name);
    const auto face = loaded_with(table, files);
    ASSERT_TRUE(face.has_value()) << face.error().message;
    EXPECT_EQ(face->recordings.at(12).activation, (std::vector<float>{1.5F, 1.5F})) << name;
  }
  Files files;
  files.muscle = replaced(files.muscle, "L_Zygomatic_Major", "Lower_Zygomatic_Major");
  const auto face = loaded_with(table, files);
  ASSERT_TRUE(face.has_value()) << face.error().message;
  EXPECT_EQ(face->recordings.at(12).activation, (std::vector<float>{0, 1.5F}))
      << "another muscle, not one of the left";
}

TEST(ClassicFolder, ATableOfAusThatIsWrongIsRefusedWithPlaceAndCause) {
  const std::pair<const char*, const char*> wrong[] = {
      {"format = 1\n[muscles]\nsmile = \"Zygomatic_Major\"\n",
       "classic_aus.toml:3:1: smile must be a list of muscle.dat's names"},
      {"format = 1\n[muscles]\nsmile = []\n",
       "classic_aus.toml:3:1: smile must be a list of muscle.dat's names"},
      {"format = 1\n[muscles]\nsmile = [\"a\"]\n[[au]]\nnumber = 12\ndrive = { smlie = 1 }\n",
       "classic_aus.toml:6:11: AU12 drives 'smlie', which this face does not have; did you mean "
       "smile?"},
      {"format = 2\n", "classic_aus.toml:1:10: format is 2, must be from 1 to 1"},
  };
  for (const auto& [table, message] : wrong) {
    const auto face = loaded_with(table);
    ASSERT_FALSE(face.has_value()) << table;
    EXPECT_EQ(face.error().kind, ErrorKind::BadData);
    EXPECT_TRUE(face.error().message.ends_with(message)) << face.error().message;
  }
}

TEST(ClassicFolder, WithoutTheTableOfAusItCannotBeLoaded) {
  const TempFolder folder;
  const TempFolder data;
  static_cast<void>(load(folder, {}));
  const auto face = load_face(folder.path(), data.path());
  ASSERT_FALSE(face.has_value());
  EXPECT_EQ(face.error().kind, ErrorKind::Unreadable);
}

/// Waters' released loop over one muscle, written down anew in double: vertices within the zone and
/// the fall-off go by val (1 - cos th / cos zone) r of the way from the attachment.
glm::dvec3 waters_moved(const LinearMuscle& muscle, double activation, const glm::dvec3& point) {
  const glm::dvec3 head = glm::dvec3(muscle.insertion) - glm::dvec3(muscle.attachment);
  const glm::dvec3 arm = point - glm::dvec3(muscle.attachment);
  const double zone = muscle.zone_rad;
  const double length = glm::length(arm);
  const double cosine = glm::dot(head, arm) / (glm::length(head) * length);
  if (cosine < std::cos(zone) || length > muscle.falloff_finish) return point;
  double pull = activation * (1 - cosine / std::cos(zone));
  if (length >= muscle.falloff_start) {
    pull *= std::cos((length - muscle.falloff_start) /
                     (double{muscle.falloff_finish} - double{muscle.falloff_start}) *
                     std::numbers::pi / 2);
  }
  return point + arm * pull;
}

/// Nine pairs of muscles in the classic frame at random, on a dense random half face.
Files generated(Seeded& seeded) {
  Files files;
  constexpr int kPointCount = 240;
  std::ostringstream points;
  points << kPointCount << "\n";
  for (int i = 0; i < kPointCount; ++i) {
    const bool middle = i % 8 == 0;
    points << (middle ? 0.0 : seeded.real(-4.4, -0.05)) << " " << seeded.real(-8, 7.5) << " "
           << seeded.real(2, 9.8) << "\n";
  }
  files.faceline = points.str();
  std::ostringstream rows;
  rows << kPointCount - 2 << "\n";
  for (int i = 1; i + 1 < kPointCount; ++i) rows << i << " " << i + 1 << " 1000 " << i + 2 << "\n";
  files.index = rows.str();
  std::ostringstream muscles;
  muscles << "18\n";
  for (int i = 0; i < 9; ++i) {
    const double x = seeded.real(0.3, 3.5);
    const double y = seeded.real(-3, 5);
    const double to_x = x + seeded.real(-0.5, 1.5);
    const double to_y = y + seeded.real(1, 3);
    const double zone = seeded.real(30, 70);
    const double finish = seeded.real(3, 5.5);
    for (const int side : {-1, 1}) {
      muscles << (side < 0 ? "Left_" : "Right_") << "Muscle_" << i << "\n"
              << side * x << " " << y << " 8.1\n"
              << side * to_x << " " << to_y << " 6.9\n0.1 " << finish << " " << zone << " 1.0\n";
    }
  }
  files.muscle = muscles.str();
  return files;
}

/// The largest distance between the deformer and Waters' formula over all muscles of a face.
double largest_error(const Face& face) {
  FaceDeformer deformer(face);
  double largest = 0;
  for (const float activation : {0.5F, 1.0F, 2.0F, 4.0F}) {
    for (const Muscle& muscle : face.muscles) {
      const std::vector<glm::vec3>& out =
          deformer.deform(test::only(face, muscle.name, activation)).positions;
      for (std::size_t i = 0; i < out.size(); ++i) {
        const glm::dvec3 expected = waters_moved(std::get<LinearMuscle>(muscle.shape), activation,
                                                 glm::dvec3(face.mesh.positions[i]));
        largest = std::max(largest, glm::distance(glm::dvec3(out[i]), expected));
      }
    }
  }
  return largest;
}

TEST(ClassicFolder, MovesAsWatersReleasedFormula) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  const Face face = loaded(generated(seeded));
  ASSERT_EQ(face.muscles.size(), 18U);
  EXPECT_LT(largest_error(face), 1e-4);
}

/// Set AUCAST_WATERS_FOLDER to a folder with Waters' own files to check against those too.
TEST(ClassicFolder, MovesWatersOwnFaceAsWatersProgram) {
  const char* folder = std::getenv("AUCAST_WATERS_FOLDER");
  if (folder == nullptr) GTEST_SKIP() << "AUCAST_WATERS_FOLDER is not set";
  const auto face = load_face(folder, kData);
  ASSERT_TRUE(face.has_value()) << face.error().message;
  EXPECT_EQ(face->mesh.positions.size(), 478U);
  EXPECT_EQ(face->muscles.size(), 18U);
  const double error = largest_error(*face);
  RecordProperty("largest_error", std::to_string(error));
  EXPECT_LT(error, 1e-4) << "largest error " << error;
}

}  // namespace
}  // namespace aucast::face

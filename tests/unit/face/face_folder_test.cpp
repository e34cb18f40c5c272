#include "client/face/face_folder.h"

#include <gtest/gtest.h>

#include <cstring>

#include "client/face/face.h"
#include "tests/unit/face/bad_file.h"
#include "tests/unit/face/small_face.h"

namespace aucast::face {
namespace {

using aucast::test::TempFolder;
using test::BadFile;
using test::case_name;
using test::replaced;

std::vector<std::string> names_of(const std::vector<Channel>& channels) {
  std::vector<std::string> names;
  for (const Channel& channel : channels) names.push_back(channel.name);
  return names;
}

TEST(FaceFolder, ChannelsComeInTheDocumentedOrder) {
  const Face face = test::small_face();
  EXPECT_EQ(names_of(face.channels), (std::vector<std::string>{"left_zygomaticus_major",
                                                               "right_zygomaticus_major",
                                                               "left_depressor",
                                                               "right_depressor",
                                                               "orbicularis_oris",
                                                               "left_orbicularis_oculi",
                                                               "right_orbicularis_oculi",
                                                               "left_frontalis_sheet",
                                                               "right_frontalis_sheet",
                                                               "mentalis",
                                                               "jaw",
                                                               "left_lid_close",
                                                               "right_lid_close",
                                                               "left_lid_raise",
                                                               "right_lid_raise",
                                                               "left_gaze_left",
                                                               "left_gaze_right",
                                                               "left_gaze_up",
                                                               "left_gaze_down",
                                                               "right_gaze_left",
                                                               "right_gaze_right",
                                                               "right_gaze_up",
                                                               "right_gaze_down",
                                                               "head_turn_left",
                                                               "head_turn_right",
                                                               "head_up",
                                                               "head_down",
                                                               "head_tilt_left",
                                                               "head_tilt_right",
                                                               "head_forward",
                                                               "head_back"}));
  EXPECT_EQ(face.name, "small");
  EXPECT_EQ(face.muscles.size(), 10U);
  EXPECT_FALSE(face.classic);
  EXPECT_EQ(face.channel_index("jaw"), 10U);
  EXPECT_FALSE(face.channel_index("left_jaw").has_value());
}

TEST(FaceFolder, ChannelsHaveTheirSideAndMaximum) {
  const Face face = test::small_face();
  const auto channel = [&](std::string_view name) {
    return face.channels[*face.channel_index(name)];
  };
  EXPECT_EQ(channel("left_depressor").side, Side::Left);
  EXPECT_EQ(channel("right_orbicularis_oculi").side, Side::Right);
  EXPECT_EQ(channel("orbicularis_oris").side, Side::Both);
  EXPECT_EQ(channel("mentalis").activation_max, 2.0F);
  EXPECT_EQ(channel("jaw").activation_max, 4.0F);
  EXPECT_EQ(channel("jaw").side, Side::Both);
  EXPECT_EQ(channel("right_gaze_left").side, Side::Right);
  EXPECT_EQ(channel("right_lid_raise").activation_max, 1.0F);
  EXPECT_TRUE(channel("left_lid_close").takes_largest);
  EXPECT_FALSE(channel("left_lid_raise").takes_largest);
}

TEST(FaceFolder, RecordingsDriveBothSidesUnlessOneIsNamed) {
  const Face face = test::small_face();
  const AuRecording& smile = face.recordings.at(12);
  EXPECT_EQ(smile.note, "corners up");
  const auto at = [&](std::string_view name) {
    return smile.activation[*face.channel_index(name)];
  };
  EXPECT_EQ(at("left_zygomaticus_major"), 1.5F);
  EXPECT_EQ(at("right_zygomaticus_major"), 1.5F);
  EXPECT_EQ(at("left_depressor"), 0.25F);
  EXPECT_EQ(at("right_depressor"), 0.0F);
}

TEST(FaceFolder, ASidedNameWinsOverTheOneForBoth) {
  const TempFolder folder;
  test::write_small_face(folder);
  folder.write("aus.toml",
               "[[au]]\nnumber = 12\ndrive = { left_depressor = 0.5, depressor = 0.25 }\n");
  const auto face = load_face(folder.path(), {});
  ASSERT_TRUE(face.has_value()) << face.error().message;
  const auto& activation = face->recordings.at(12).activation;
  EXPECT_EQ(activation[*face->channel_index("left_depressor")], 0.5F);
  EXPECT_EQ(activation[*face->channel_index("right_depressor")], 0.25F);
}

TEST(FaceFolder, AFaceWithoutMoversHasItsMusclesOnly) {
  const TempFolder folder;
  test::write_small_face(folder);
  folder.write("face.toml",
               "format = 1\nname = \"bare\"\nmesh = \"mesh.ply\"\nmuscles = \"muscles.toml\"\n"
               "aus = \"aus.toml\"\n");
  folder.write("aus.toml", "");
  const auto face = load_face(folder.path(), {});
  ASSERT_TRUE(face.has_value()) << face.error().message;
  EXPECT_EQ(face->channels.size(), face->muscles.size());
  EXPECT_TRUE(face->recordings.empty());
}

TEST(FaceFolder, EyesComeLeftFirstWhateverTheFilesOrder) {
  const TempFolder folder;
  test::write_small_face(folder);
  std::string text = test::small_face_toml();
  text = replaced(text, "left_eye", "here_eye");
  text = replaced(text, "right_eye", "left_eye");
  text = replaced(text, "here_eye", "right_eye");
  text = replaced(text, "[2.2", "[-9.9");
  text = replaced(text, "[-2.2", "[2.2");
  text = replaced(text, "[-9.9", "[-2.2");
  folder.write("face.toml", text);
  const auto face = load_face(folder.path(), {});
  ASSERT_TRUE(face.has_value()) << face.error().message;
  ASSERT_EQ(face->eyes.size(), 2U);
  EXPECT_EQ(face->eyes[0].part, "left_eye");
}

TEST(FaceFolder, ACopyWithoutTheFaceThatItSharesAFileWithSaysWhich) {
  const TempFolder folder;
  test::write_small_face(folder);
  folder.write("face.toml", replaced(test::small_face_toml(), "\"muscles.toml\"",
                                     "\"../no-such-face/muscles.toml\""));
  const auto face = load_face(folder.path(), {});
  ASSERT_FALSE(face.has_value());
  EXPECT_EQ(face.error().kind, ErrorKind::Unreadable);
  EXPECT_NE(face.error().message.find("shares it with no-such-face"), std::string::npos);
}

TEST(FaceFolder, AMissingFileIsUnreadable) {
  for (const auto* name : {"face.toml", "muscles.toml", "aus.toml", "mesh.ply"}) {
    const TempFolder folder;
    test::write_small_face(folder);
    std::filesystem::remove(folder.path() / name);
    const auto face = load_face(folder.path(), {});
    ASSERT_FALSE(face.has_value()) << name;
    EXPECT_EQ(face.error().kind, ErrorKind::Unreadable);
    EXPECT_NE(face.error().message.find(name), std::string::npos) << face.error().message;
  }
}

TEST(FaceFolder, AMuscleMayGoLessFarThanOthers) {
  const TempFolder folder;
  test::write_small_face(folder);
  const std::string muscles = replaced(test::small_muscles_toml(), "falloff_finish = 4.8",
                                       "falloff_finish = 4.8\nactivation_max = 1.5");
  folder.write("muscles.toml", muscles);
  const auto face = load_face(folder.path(), {});  // its AU 12 drives the muscle by 1.5
  ASSERT_TRUE(face) << face.error().message;
  for (const Channel& channel : face->channels) {
    if (!channel.name.ends_with("zygomaticus_major")) continue;
    EXPECT_EQ(channel.activation_max, 1.5F) << channel.name;
  }
  folder.write("muscles.toml", replaced(muscles, "activation_max = 1.5", "activation_max = 1.4"));
  const auto refused = load_face(folder.path(), {});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message, (folder.path() / "aus.toml").string() +
                                         ":3:31: zygomaticus_major is 1.5, must be from 0 to 1.4");
}

std::string text_of(const std::string& file) {
  if (file == "face.toml") return test::small_face_toml();
  return file == "muscles.toml" ? test::small_muscles_toml() : test::small_aus_toml();
}

class BadFaceFile : public ::testing::TestWithParam<BadFile> {};

TEST_P(BadFaceFile, IsRefusedWithPlaceAndCause) {
  const BadFile& bad = GetParam();
  const TempFolder folder;
  test::write_small_face(folder);
  folder.write(bad.file, replaced(text_of(bad.file), bad.from, bad.to));
  const auto face = load_face(folder.path(), {});
  ASSERT_FALSE(face.has_value()) << bad.message;
  EXPECT_EQ(face.error().kind, ErrorKind::BadData);
  EXPECT_EQ(face.error().message, (folder.path() / bad.file).string() + bad.message);
}

const std::vector<BadFile> kBadFaceToml = {
    {"face.toml", "format = 1", "format = 2", ":1:10: format is 2, must be from 1 to 1"},
    {"face.toml", "name = \"small\"\n", "", ":1:1: 'name' is missing"},
    {"face.toml", "name = \"small\"", "name = small",
     ":2:8: Error while parsing value: could not determine value type"},
    {"face.toml", "[lids]", "[lid]", ":12:2: unknown key 'lid'; did you mean lids?"},
    {"face.toml", "raise_max", "raise_min",
     ":13:1: unknown key 'raise_min'; did you mean raise_max?"},
    {"face.toml", "5.5", "0", ":9:20: degrees_per_unit is 0, must be above 0 to 22.5"},
    {"face.toml", "[0.0, 0.9, 1.5]", "[0.0, 0.9]", ":8:9: hinge must have 3 numbers"},
    {"face.toml", "[0.0, 0.9, 1.5]", "[0.0, nan, 1.5]", ":8:15: hinge is not a finite number"},
    {"face.toml", "[0.0, 0.9, 1.5]", "[0.0, \"x\", 1.5]", ":8:15: hinge must be a number"},
    {"face.toml", "[0.0, 0.9, 1.5]", "4", ":8:9: hinge must be a list"},
    {"face.toml", "\"left_eye\"", "\"left_eyes\"",
     ":16:8: part 'left_eyes' is no part of the mesh; did you mean left_eye?"},
    {"face.toml", "[-2.2, 2.7", "[1.2, 2.7", ":19:1: there are two eyes on one side"},
    {"face.toml", "\"right_eye\"", "\"left_eye\"",
     ":19:1: the two eyes are one part of the mesh: each turns its own"},
    {"face.toml", "[head]", "[[head]]", ":23:1: head must be a table"},
    {"face.toml", "[head]", "[lines]\ncrease_chin = 0.5\n[head]",
     ":24:1: unknown key 'crease_chin'"},
    {"face.toml", "[head]", "[hair]\nhinge = [0.0, 4.0, 0.0]\nswing_deg = 16\n[head]",
     ":25:13: swing_deg is 16, must be from 0 to 15"},
    {"face.toml", "[head]\npivot = [0.0, -4.6, -0.6]", "[hair]\nhinge = [0.0, 4.0, 0.0]",
     ":23:1: hair needs a [head] to swing after"},
};

const std::vector<BadFile> kBadMuscles = {
    {"muscles.toml", "\"linear\"", "\"liner\"",
     ":4:8: kind 'liner' is unknown; did you mean linear?"},
    {"muscles.toml", "kind = \"linear\"\n", "", ":1:1: 'kind' is missing"},
    {"muscles.toml", "zone_deg", "zone_degree",
     ":7:1: unknown key 'zone_degree'; did you mean zone_deg?"},
    {"muscles.toml", "45.0", "90.0", ":7:12: zone_deg is 90, must be above 0 and below 90"},
    {"muscles.toml", "45.0", "inf", ":7:12: zone_deg is not a finite number"},
    {"muscles.toml", "4.8", "0.1", ":9:18: falloff_finish must be above falloff_start"},
    {"muscles.toml", "falloff_start = 0.1", "falloff_start = -0.1",
     ":8:17: falloff_start is -0.1, must be at least 0"},
    {"muscles.toml", "[1.57, -2.221, 7.82]", "[3.805, 0.868, 6.6]",
     ":6:13: insertion must differ from the attachment"},
    {"muscles.toml", "mirrored = true", "mirrored = 1", ":3:12: mirrored must be true or false"},
    {"muscles.toml", "[1.57, -2.221, 7.82]", "[-1.57, -2.221, 7.82]",
     ":3:12: mirrored needs the insertion or centre at x > 0, the left side"},
    {"muscles.toml", "\"half\"", "\"halve\"",
     ":20:8: mask 'halve' is no map of the mesh; did you mean half?"},
    {"muscles.toml", "mask = \"half\"", "mask_alone = true", ":20:14: mask_alone needs a mask"},
    {"muscles.toml", "\"depressor\"", "\"zygomaticus_major\"",
     ":12:8: name 'left_zygomaticus_major' is there twice"},
    {"muscles.toml", "\"mentalis\"", "\"chin raise\"",
     ":47:8: name must be made of letters, digits and _"},
    {"muscles.toml", "\"mentalis\"", "\"jaw\"",
     ": the muscle name 'jaw' is taken: it is a channel of its own"},
    {"muscles.toml", "[2.6, 1.9]", "[1.6, 1.9]",
     ":26:13: semi_axes must have the longer one first"},
    {"muscles.toml", "depth = 3.0", "depth = 0", ":27:9: depth is 0, must be above 0"},
    {"muscles.toml", "depth = 3.0", "depth = 3.0\nprotrusion = 0.5",
     ":28:14: protrusion must be at least 1, or at most -1"},
    {"muscles.toml", "width = 3.6", "width = 3.6\npeak = 1.0",
     ":44:8: peak is 1, must be above 0 and below 1"},
    {"muscles.toml", "[0.0, 0.35, 0.10]", "[0.0, 0.0, 0.0]", ":50:13: direction must not be zero"},
    {"muscles.toml", "[1.2, 0.9, 1.5]", "[1.2, 0.9, 0]", ":51:20: radii is 0, must be above 0"},
    {"muscles.toml", "[[muscle]]", "[[muscles]]",
     ":1:3: unknown key 'muscles'; did you mean muscle?"},
};

const std::vector<BadFile> kBadAus = {
    {"aus.toml", "zygomaticus_major", "zygomatic_major",
     ":3:11: AU12 drives 'zygomatic_major', which this face does not have; did you mean "
     "zygomaticus_major?"},
    {"aus.toml", "1.5", "2.5", ":3:31: zygomaticus_major is 2.5, must be from 0 to 2"},
    {"aus.toml", "1.5", "-1.5", ":3:31: zygomaticus_major is -1.5, must be from 0 to 2"},
    {"aus.toml", "number = 15", "number = 12", ":7:10: number 12 is there twice"},
    {"aus.toml", "number = 15", "number = 100", ":7:10: number is 100, must be from 0 to 99"},
    {"aus.toml", "number = 15", "number = 1.5", ":7:10: number must be a whole number"},
    {"aus.toml", "note", "notes", ":4:1: unknown key 'notes'; did you mean note?"},
    {"aus.toml", "{ jaw = 2.2 }", "[ 2.2 ]", ":12:9: drive must be a table"},
};

INSTANTIATE_TEST_SUITE_P(FaceToml, BadFaceFile, ::testing::ValuesIn(kBadFaceToml), case_name);
INSTANTIATE_TEST_SUITE_P(Muscles, BadFaceFile, ::testing::ValuesIn(kBadMuscles), case_name);
INSTANTIATE_TEST_SUITE_P(Aus, BadFaceFile, ::testing::ValuesIn(kBadAus), case_name);

TEST(FaceFolder, AMeshWithoutTheMapThatAMoverNeedsIsRefused) {
  const std::pair<std::string, std::string> cases[] = {
      {"jaw", ":7:1"}, {"lid_angle", ":12:1"}, {"head", ":23:1"}};
  for (const auto& [map, place] : cases) {
    const TempFolder folder;
    test::write_small_face(folder);
    FaceMesh mesh = test::small_mesh();
    mesh.maps.erase(map);
    folder.write("mesh.ply", format_ply(mesh, test::small_polygons()));
    const auto face = load_face(folder.path(), {});
    ASSERT_FALSE(face.has_value()) << map;
    EXPECT_EQ(face.error().message, (folder.path() / "face.toml").string() + place +
                                        ": this needs the map '" + map + "', which the mesh lacks");
  }
}

TEST(FaceFolder, ACreaseWithTheNameOfAnotherChannelIsTheMeshsFault) {
  const TempFolder folder;
  test::write_small_face(folder);
  FaceMesh mesh = test::small_mesh();
  const auto begin = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.parts.push_back({"jaw", Material::Crease, begin, 3, 0, 0});
  for (const float x : {0.0F, 1.0F, 2.0F}) mesh.positions.emplace_back(x, x * x, 0.0F);
  mesh.colours.resize(mesh.positions.size(), {0.5F, 0.4F, 0.3F, 1.0F});
  for (auto& [name, map] : mesh.maps) map.resize(mesh.positions.size());
  std::vector<Polygon> polygons = test::small_polygons();
  polygons.push_back({{begin, begin + 1, begin + 2, 0}, 3});
  folder.write("mesh.ply", format_ply(mesh, polygons));
  const auto face = load_face(folder.path(), {});
  ASSERT_FALSE(face.has_value());
  EXPECT_EQ(face.error().message,
            (folder.path() / "mesh.ply").string() +
                ": the name of the crease 'jaw' is taken: it is a channel of its own");
}

TEST(FaceFolder, AMeshWithANanIsRefusedByVertex) {
  const TempFolder folder;
  test::write_small_face(folder);
  std::string bytes = folder.read("mesh.ply");
  const std::uint32_t nan = 0x7fc00000;
  std::memcpy(bytes.data() + bytes.find("end_header\n") + 11, &nan, sizeof nan);
  folder.write("mesh.ply", bytes);
  const auto face = load_face(folder.path(), {});
  ASSERT_FALSE(face.has_value());
  EXPECT_EQ(face.error().message,
            (folder.path() / "mesh.ply").string() + ": vertex 0: x is not a finite number");
}

}  // namespace
}  // namespace aucast::face

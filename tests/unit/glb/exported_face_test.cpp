// A face in a file, read back as a viewer reads it.
#include <cmath>
#include <cstring>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include "client/face/face_deformer.h"
#include "client/glb/face_glb.h"
#include "client/glb/units.h"
#include "tests/unit/face/small_face.h"
#include "tests/unit/glb/added_parts.h"
#include "tests/unit/glb/read_glb.h"

namespace aucast::glb {
namespace {

using face::test::only;
using face::test::small_face;
using test::add_crease;
using test::add_part;
using test::ReadGlb;

glm::vec3 vec3(const std::vector<float>& row) {
  return {row.at(0), row.at(1), row.at(2)};
}

/// The small face with brows, hair of two colours, a shirt and a mouth.
face::Face dressed_face() {
  face::Face face = small_face();
  add_part(face, "brows", face::Material::Brow);
  add_part(face, "lashes", face::Material::Lash);
  add_part(face, "hair", face::Material::Hair);
  add_part(face, "temples", face::Material::GreyHair);
  add_part(face, "shirt", face::Material::Cloth);
  add_part(face, "teeth", face::Material::Teeth);
  return face;
}

/// A motion of one pose after the other, half a second apart.
Motion motion_of(const face::Face& face, const FaceRig& rig, const MorphTargets& targets,
                 const std::vector<std::vector<float>>& poses) {
  Motion motion;
  motion.name = "moves";
  for (std::size_t i = 0; i < poses.size(); ++i) {
    motion.seconds.push_back(0.5F * static_cast<float>(i));
    const auto weights = targets.weights(face, {{}, poses[i]});
    motion.weights.insert(motion.weights.end(), weights.begin(), weights.end());
    motion.joints.push_back(rig.pose(poses[i]));
  }
  return motion;
}

struct Exported {
  explicit Exported(face::Face from, Basis basis = Basis::Muscles,
                    const std::vector<std::vector<float>>& poses = {})
      : face(std::move(from)), rig(face, basis == Basis::Muscles), targets(face, basis, rig) {
    const Motion motion = motion_of(face, rig, targets, poses);
    const auto bytes = face_glb(face, targets, rig, poses.empty() ? nullptr : &motion, {});
    EXPECT_TRUE(bytes.has_value());
    if (bytes) glb.emplace(*bytes);
  }

  face::Face face;
  FaceRig rig;
  MorphTargets targets;
  std::optional<ReadGlb> glb;
};

TEST(ExportedFace, EveryNumberLiesInTheFileWhereItMay) {
  const face::Face face = dressed_face();
  const Exported exported(dressed_face(), Basis::Muscles,
                          {only(face, "jaw", 1), only(face, "head_up", 1)});
  const ReadGlb& glb = *exported.glb;
  const std::size_t length = glb.document["buffers"][0]["byteLength"];
  EXPECT_LE(length, glb.binary.size());
  std::size_t end = 0;
  for (const Json& view : glb.document["bufferViews"]) {
    const std::size_t begin = view["byteOffset"];
    EXPECT_EQ(begin % 4, 0U) << "of the widest number";
    EXPECT_GE(begin, end) << "views overlap";
    end = begin + view["byteLength"].get<std::size_t>();
    EXPECT_LE(end, length);
  }
  const auto fits = [&](const Json& view, std::size_t from, int type, std::size_t numbers) {
    const std::size_t bytes = ReadGlb::bytes_of(type);
    EXPECT_EQ(from % bytes, 0U);
    const Json& whole = glb.document["bufferViews"].at(view.get<std::size_t>());
    EXPECT_LE(from + bytes * numbers, whole["byteLength"].get<std::size_t>());
  };
  for (const Json& accessor : glb.document["accessors"]) {
    const std::size_t width = ReadGlb::width_of(accessor["type"].get<std::string>());
    const std::size_t count = accessor["count"];
    if (accessor.contains("bufferView")) {
      fits(accessor["bufferView"], 0, accessor["componentType"], width * count);
    }
    if (!accessor.contains("sparse")) continue;
    const Json& sparse = accessor["sparse"];
    const std::size_t changed = sparse["count"];
    EXPECT_LE(changed, count);
    fits(sparse["indices"]["bufferView"], sparse["indices"]["byteOffset"],
         sparse["indices"]["componentType"], changed);
    fits(sparse["values"]["bufferView"], sparse["values"]["byteOffset"], accessor["componentType"],
         width * changed);
  }
}

TEST(ExportedFace, ARangeIsThatOfTheNumbers) {
  const Exported exported(dressed_face());
  const ReadGlb& glb = *exported.glb;
  std::size_t ranges = 0;
  for (std::size_t i = 0; i < glb.document["accessors"].size(); ++i) {
    const Json& accessor = glb.document["accessors"][i];
    if (!accessor.contains("min")) continue;
    ++ranges;
    const float unit = accessor.value("normalized", false) ? 32'767.0F : 1.0F;
    const ReadGlb::Rows rows = glb.rows(i);
    for (std::size_t k = 0; k < accessor["min"].size(); ++k) {
      float low = rows.front()[k];
      float high = low;
      for (const auto& row : rows) {
        low = std::min(low, row[k]);
        high = std::max(high, row[k]);
      }
      EXPECT_FLOAT_EQ(accessor["min"][k].get<float>(), unit * low) << i;
      EXPECT_FLOAT_EQ(accessor["max"][k].get<float>(), unit * high) << i;
    }
  }
  EXPECT_GT(ranges, exported.targets.all().size());
}

TEST(ExportedFace, TrianglesNameVerticesThatAreThereAndAllOfThemAreThere) {
  const Exported exported(dressed_face());
  const ReadGlb& glb = *exported.glb;
  std::size_t triangles = 0;
  for (const Json& mesh : glb.document["meshes"]) {
    const Json& primitive = mesh["primitives"][0];
    const std::size_t vertices = glb.rows(primitive["attributes"]["POSITION"]).size();
    const ReadGlb::Rows indices = glb.rows(primitive["indices"]);
    EXPECT_EQ(indices.size() % 3, 0U);
    triangles += indices.size() / 3;
    for (const auto& index : indices) ASSERT_LT(index[0], static_cast<float>(vertices));
    for (const auto& [name, attribute] : primitive["attributes"].items()) {
      EXPECT_EQ(glb.rows(attribute).size(), vertices) << name;
    }
  }
  std::size_t wanted = 0;
  for (const face::MeshPart& part : exported.face.mesh.parts) wanted += part.triangle_count;
  EXPECT_EQ(triangles, wanted);
}

TEST(ExportedFace, NormalsAreOfUnitLengthAndPointOut) {
  const Exported exported(small_face());
  const ReadGlb& glb = *exported.glb;
  const Json& attributes = glb.primitive("skin")["attributes"];
  const ReadGlb::Rows normals = glb.rows(attributes["NORMAL"]);
  for (const auto& row : normals) EXPECT_NEAR(glm::length(vec3(row)), 1, 1e-4F);
  EXPECT_GT(normals[normals.size() / 2][2], 0.5F) << "the face looks along +z";
}

TEST(ExportedFace, SkinStandsWhereTheFaceHasItInMetres) {
  const Exported exported(small_face());
  const ReadGlb& glb = *exported.glb;
  EXPECT_FALSE(glb.node("skin").contains("translation")) << "its skin says where it is";
  const ReadGlb::Rows positions = glb.rows(glb.primitive("skin")["attributes"]["POSITION"]);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    EXPECT_EQ(vec3(positions[i]), kMetresPerUnit * exported.face.mesh.positions[i]) << i;
  }
}

TEST(ExportedFace, AnEyeballHangsOnItsJointAndComesToLieInTheFace) {
  const Exported exported(small_face());
  const ReadGlb& glb = *exported.glb;
  const ReadGlb::Rows positions = glb.rows(glb.primitive("left_eyeball")["attributes"]["POSITION"]);
  // From the scene to the joint: body, neck, head, eye.
  glm::vec3 joint(0);
  for (const char* name : {"body", "neck", "head", "left_eye"}) {
    const Json& by = glb.node(name)["translation"];
    joint += glm::vec3(by[0].get<float>(), by[1].get<float>(), by[2].get<float>());
  }
  EXPECT_LT(glm::distance(joint, kMetresPerUnit * exported.face.eyes.front().centre), 1e-6F);
  const face::MeshPart& part = exported.face.mesh.parts.at(1);
  ASSERT_EQ(positions.size(), part.vertex_count);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const glm::vec3 own = exported.face.mesh.positions[part.vertex_begin + i];
    EXPECT_LT(glm::distance(joint + vec3(positions[i]), kMetresPerUnit * own), 1e-6F);
  }
  EXPECT_FALSE(glb.primitive("left_eyeball")["attributes"].contains("JOINTS_0"));
}

TEST(ExportedFace, ATargetAddsWhatItsPoseChanges) {
  const Exported exported(small_face());
  const ReadGlb& glb = *exported.glb;
  const Json& primitive = glb.primitive("skin");
  ASSERT_EQ(primitive["targets"].size(), exported.targets.all().size());
  for (std::size_t k = 0; k < primitive["targets"].size(); ++k) {
    const Target& target = exported.targets.all()[k];
    std::map<std::uint32_t, glm::vec3> wanted;
    for (const Change& change : target.positions) {
      wanted[change.vertex] = kMetresPerUnit * glm::vec3(change.by);
    }
    const ReadGlb::Rows changes = glb.rows(primitive["targets"][k]["POSITION"]);
    for (std::uint32_t i = 0; i < changes.size(); ++i) {
      const auto found = wanted.find(i);
      const glm::vec3 by = found == wanted.end() ? glm::vec3(0) : found->second;
      EXPECT_LT(glm::distance(vec3(changes[i]), by), 1e-6F) << target.name << " " << i;
    }
    const ReadGlb::Rows turned = glb.rows(primitive["targets"][k]["NORMAL"]);
    for (const Change& change : target.normals) {
      const glm::vec3 kept = glm::clamp(glm::vec3(change.by), -1.0F, 1.0F);
      EXPECT_LT(glm::distance(vec3(turned[change.vertex]), kept), 0.01F)
          << "127 steps for each part of a normal";
    }
  }
}

/// The skin's positions with all targets at the weights of this pose, before joints carry them.
ReadGlb::Rows morphed_skin(const Exported& exported, const std::vector<float>& pose) {
  const ReadGlb& glb = *exported.glb;
  const Json& primitive = glb.primitive("skin");
  ReadGlb::Rows positions = glb.rows(primitive["attributes"]["POSITION"]);
  const auto weights = exported.targets.weights(exported.face, {{}, pose});
  for (std::size_t k = 0; k < weights.size(); ++k) {
    const ReadGlb::Rows changes = glb.rows(primitive["targets"][k]["POSITION"]);
    for (std::size_t i = 0; i < positions.size(); ++i) {
      for (std::size_t c = 0; c < 3; ++c)
        positions[i][c] += changes[i][c] * static_cast<float>(weights[k]) / 255;
    }
  }
  return positions;
}

TEST(ExportedFace, WithSkinAndTargetsTheFileShowsTheDeformersFace) {
  // All in one pose: a muscle, the jaw's joint, head and neck.
  const face::Face face = small_face();
  std::vector<float> pose = only(face, "left_zygomaticus_major", 2);
  pose[*face.channel_index("head_turn_left")] = 1;
  pose[*face.channel_index("jaw")] = 2;
  const Exported exported(small_face(), Basis::Muscles, {pose, pose});
  const ReadGlb& glb = *exported.glb;
  const Json& attributes = glb.primitive("skin")["attributes"];
  const ReadGlb::Rows positions = morphed_skin(exported, pose);
  // The joints as the animation's first sample has them.
  std::map<std::size_t, glm::quat> rotations;
  std::map<std::size_t, glm::vec3> translations;
  const Json& animation = glb.document["animations"][0];
  for (const Json& channel : animation["channels"]) {
    const std::size_t node = channel["target"]["node"];
    const Json& sampler = animation["samplers"].at(channel["sampler"].get<std::size_t>());
    const auto row = glb.rows(sampler["output"]).front();
    if (channel["target"]["path"] == "rotation") rotations[node] = {row[3], row[0], row[1], row[2]};
    if (channel["target"]["path"] == "translation") translations[node] = vec3(row);
  }
  const Json& nodes = glb.document["nodes"];
  std::map<std::size_t, std::size_t> parents;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    for (const Json& child : nodes[i].value("children", Json::array())) parents[child] = i;
  }
  const auto stands = [&](auto& self, std::size_t node) -> glm::mat4 {
    const Json& by = nodes[node]["translation"];
    const glm::vec3 rest(by[0].get<float>(), by[1].get<float>(), by[2].get<float>());
    const glm::vec3 at = translations.contains(node) ? translations[node] : rest;
    const glm::quat rotation =
        rotations.contains(node) ? rotations[node] : glm::identity<glm::quat>();
    const glm::mat4 own = glm::translate(glm::mat4(1), at) * glm::mat4_cast(rotation);
    return parents.contains(node) ? self(self, parents[node]) * own : own;
  };
  const Json& skin = glb.document["skins"][0];
  const ReadGlb::Rows inverse = glb.rows(skin["inverseBindMatrices"]);
  std::vector<glm::mat4> carriers;
  for (std::size_t k = 0; k < skin["joints"].size(); ++k) {
    glm::mat4 back(1);
    for (std::size_t n = 0; n < 16; ++n) {
      back[static_cast<glm::length_t>(n / 4)][static_cast<glm::length_t>(n % 4)] = inverse[k][n];
    }
    carriers.push_back(stands(stands, skin["joints"][k]) * back);
  }
  const ReadGlb::Rows joints = glb.rows(attributes["JOINTS_0"]);
  const ReadGlb::Rows joint_weights = glb.rows(attributes["WEIGHTS_0"]);
  face::FaceDeformer deformer(exported.face);
  const auto& real = deformer.deform(pose).positions;
  float worst = 0;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    float sum = 0;
    glm::vec4 at(0);
    for (std::size_t k = 0; k < 4; ++k) {
      sum += joint_weights[i][k];
      at += joint_weights[i][k] * (carriers.at(static_cast<std::size_t>(joints[i][k])) *
                                   glm::vec4(vec3(positions[i]), 1));
    }
    ASSERT_NEAR(sum, 1, 1e-4F);
    worst = std::max(worst, glm::distance(glm::vec3(at), kMetresPerUnit * real[i]));
  }
  // The skin bends by means of joints, which is not the deformer's way: millimetres at the neck.
  EXPECT_LT(worst, 0.004F);
}

TEST(ExportedFace, AnAnimationHasASampleOfEverythingAtEachTime) {
  const face::Face face = small_face();
  const std::vector<float> rest(face.channels.size());
  const Exported exported(small_face(), Basis::Muscles,
                          {rest, only(face, "jaw", 2), only(face, "head_forward", 1)});
  const ReadGlb& glb = *exported.glb;
  const Json& animation = glb.document["animations"][0];
  std::set<std::string> paths;
  for (const Json& channel : animation["channels"]) {
    const std::string path = channel["target"]["path"];
    const std::string name =
        glb.document["nodes"].at(channel["target"]["node"].get<std::size_t>())["name"];
    paths.insert(name + "." + path);
    const Json& sampler = animation["samplers"].at(channel["sampler"].get<std::size_t>());
    EXPECT_EQ(glb.rows(sampler["input"]), (ReadGlb::Rows{{0}, {0.5F}, {1}}));
    const ReadGlb::Rows output = glb.rows(sampler["output"]);
    EXPECT_EQ(output.size(), 3 * (path == "weights" ? exported.targets.all().size() : 1));
    if (path != "rotation") continue;
    for (const auto& q : output) {
      EXPECT_NEAR(std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3])), 1, 1e-5F);
    }
  }
  EXPECT_EQ(paths, (std::set<std::string>{"skin.weights", "jaw.rotation", "jaw.translation",
                                          "neck.translation", "head.translation"}));
}

TEST(ExportedFace, WhatStandsStillIsNotAnimated) {
  const std::vector<float> rest(small_face().channels.size());
  const Exported exported(small_face(), Basis::Muscles, {rest, rest});
  const Json& channels = exported.glb->document["animations"][0]["channels"];
  ASSERT_EQ(channels.size(), 1U);
  EXPECT_EQ(channels[0]["target"]["path"], "weights");
}

TEST(ExportedFace, SurfacesLookAsTheirMaterialsDo) {
  const Exported exported(dressed_face());
  const ReadGlb& glb = *exported.glb;
  EXPECT_FALSE(glb.material("skin").contains("alphaMode"));
  EXPECT_EQ(glb.material("brows")["alphaMode"], "BLEND");
  EXPECT_EQ(glb.material("hair")["alphaMode"], "MASK");
  EXPECT_EQ(glb.material("clothes")["doubleSided"], true);
  EXPECT_TRUE(glb.material("mouth").contains("doubleSided"));
  for (const Json& material : glb.document["materials"]) {
    EXPECT_EQ(material["pbrMetallicRoughness"]["metallicFactor"], 0) << material["name"];
    EXPECT_FALSE(material.contains("extensions")) << "nothing is unlit but creases";
  }
  EXPECT_EQ(glb.document["extensionsUsed"], Json{"KHR_mesh_quantization"});
}

TEST(ExportedFace, ACreaseIsBlackAndShownByItsTargetAlone) {
  face::Face creased = small_face();
  add_crease(creased, "crease_brow");
  for (glm::vec4& colour : creased.mesh.colours) colour = {0.25F, 0.5F, 0.75F, 0.5F};
  const Exported exported(std::move(creased));
  const ReadGlb& glb = *exported.glb;
  EXPECT_TRUE(glb.material("creases")["extensions"].contains("KHR_materials_unlit"));
  EXPECT_EQ(glb.material("creases")["alphaMode"], "BLEND");
  EXPECT_EQ(glb.document["extensionsUsed"], (Json{"KHR_materials_unlit", "KHR_mesh_quantization"}));
  const Json& primitive = glb.primitive("creases");
  EXPECT_FALSE(primitive["attributes"].contains("NORMAL")) << "no light falls on it";
  const std::vector<float> clear(4);
  for (const auto& colour : glb.rows(primitive["attributes"]["COLOR_0"])) EXPECT_EQ(colour, clear);
  std::size_t shown = 0;
  for (std::size_t k = 0; k < exported.targets.all().size(); ++k) {
    const bool own = exported.targets.all()[k].name == "crease_brow";
    for (const auto& change : glb.rows(primitive["targets"][k]["COLOR_0"])) {
      EXPECT_EQ(change, own ? (std::vector<float>{0, 0, 0, 0.25F}) : clear);
      shown += own ? 1 : 0;
    }
  }
  EXPECT_EQ(shown, 100U);
}

TEST(ExportedFace, ACreaseLiesOffTheSkinThatWouldCoverIt) {
  face::Face creased = small_face();
  add_crease(creased, "crease_brow");
  const Exported exported(std::move(creased));
  const ReadGlb& glb = *exported.glb;
  const face::MeshPart& part = exported.face.mesh.parts.back();
  const auto joint = exported.rig.carried(part.vertex_begin).wholly();
  ASSERT_TRUE(joint) << "the head carries it, from whose joint its positions count";
  const glm::vec3 from = exported.rig.joints()[*joint].position;
  const ReadGlb::Rows positions = glb.rows(glb.primitive("creases")["attributes"]["POSITION"]);
  ASSERT_EQ(positions.size(), part.vertex_count);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const glm::vec3 own =
        kMetresPerUnit * (exported.face.mesh.positions[part.vertex_begin + i] - from);
    EXPECT_NEAR(glm::distance(vec3(positions[i]), own), 0.05F * kMetresPerUnit, 1e-5F);
    EXPECT_GT(positions[i][2], own.z) << "towards the viewer";
  }
}

TEST(ExportedFace, SparseIndicesAscendAndLieInTheMesh) {
  const Exported exported(dressed_face());
  const ReadGlb& glb = *exported.glb;
  std::size_t sparse_ones = 0;
  for (const Json& accessor : glb.document["accessors"]) {
    if (!accessor.contains("sparse")) continue;
    ++sparse_ones;
    const Json& sparse = accessor["sparse"];
    const Json& view =
        glb.document["bufferViews"].at(sparse["indices"]["bufferView"].get<std::size_t>());
    const std::size_t begin =
        view["byteOffset"].get<std::size_t>() + sparse["indices"]["byteOffset"].get<std::size_t>();
    int last = -1;
    for (std::size_t k = 0; k < sparse["count"].get<std::size_t>(); ++k) {
      std::uint16_t index = 0;
      ASSERT_EQ(sparse["indices"]["componentType"], 5123);
      std::memcpy(&index, glb.binary.data() + begin + 2 * k, sizeof index);
      ASSERT_GT(index, last);
      last = index;
    }
    EXPECT_LT(last, accessor["count"].get<int>());
  }
  EXPECT_GT(sparse_ones, exported.targets.all().size());
}

TEST(ExportedFace, HairOfEachColourHasItsOwnPictureOfStrands) {
  const Exported exported(dressed_face());
  const ReadGlb& glb = *exported.glb;
  ASSERT_EQ(glb.document["images"].size(), 2U);
  ASSERT_EQ(glb.document["textures"].size(), 2U);
  std::set<std::string> pictures;
  for (const Json& image : glb.document["images"]) {
    const Json& view = glb.document["bufferViews"].at(image["bufferView"].get<std::size_t>());
    const std::string bytes = glb.binary.substr(view["byteOffset"], view["byteLength"]);
    EXPECT_EQ(bytes.substr(0, 8), "\x89PNG\r\n\x1a\n");
    EXPECT_EQ(image["mimeType"], "image/png");
    pictures.insert(bytes);
  }
  EXPECT_EQ(pictures.size(), 2U);
  std::size_t textured = 0;
  for (const Json& mesh : glb.document["meshes"]) {
    const Json& primitive = mesh["primitives"][0];
    const bool hair = mesh["name"] == "hair";
    EXPECT_EQ(primitive["attributes"].contains("TEXCOORD_0"), hair) << mesh["name"];
    EXPECT_EQ(primitive.contains("targets"),
              mesh["name"] == "skin" || mesh["name"] == "brows" || mesh["name"] == "mouth")
        << mesh["name"];
    textured += hair ? 1 : 0;
  }
  EXPECT_EQ(textured, 2U);
}

TEST(ExportedFace, WithoutMusclesThereIsNothingToQuantize) {
  face::Face still = small_face();
  still.recordings.clear();
  const Exported exported(std::move(still), Basis::Aus);
  const ReadGlb& glb = *exported.glb;
  EXPECT_TRUE(exported.targets.all().empty());
  EXPECT_FALSE(glb.document.contains("extensionsRequired"));
  EXPECT_FALSE(glb.document.contains("extensionsUsed"));
  EXPECT_FALSE(glb.mesh("skin").contains("weights"));
  EXPECT_FALSE(glb.document["asset"].contains("copyright"));
}

TEST(ExportedFace, WithoutJointsThatTurnAllHangsOnTheBody) {
  face::Face bust = small_face();
  bust.head.reset();
  bust.jaw.reset();
  bust.eyes.clear();
  const Exported exported(std::move(bust));
  const ReadGlb& glb = *exported.glb;
  EXPECT_FALSE(glb.document.contains("skins"));
  EXPECT_FALSE(glb.primitive("skin")["attributes"].contains("JOINTS_0"));
  const Json& body = glb.node("body");
  EXPECT_EQ(body["children"].size(), glb.document["meshes"].size());
  EXPECT_EQ(glb.document["scenes"][0]["nodes"], Json{0});
}

}  // namespace
}  // namespace aucast::glb

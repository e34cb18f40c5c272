#include "client/glb/face_glb.h"

#include <limits>
#include <optional>

#include <glm/geometric.hpp>

#include "client/face/face_deformer.h"
#include "client/glb/strand_picture.h"
#include "client/glb/surfaces.h"
#include "client/glb/units.h"

namespace aucast::glb {
namespace {

constexpr const char* kUnlit = "KHR_materials_unlit";
constexpr std::size_t kBytesMax = std::numeric_limits<std::uint32_t>::max();

Json material(const Surface& surface) {
  const auto matt = [](double roughness) {
    return Json{{"metallicFactor", 0}, {"roughnessFactor", roughness}};
  };
  Json made{{"name", surface.name}};
  switch (surface.look) {
    case Look::Skin:
      made["pbrMetallicRoughness"] = matt(0.55);
      break;
    case Look::Mouth:
      made["pbrMetallicRoughness"] = matt(0.4);
      made["doubleSided"] = true;
      break;
    case Look::Eye:
      made["pbrMetallicRoughness"] = matt(0.12);
      break;
    case Look::Brows:
      made["pbrMetallicRoughness"] = matt(0.9);
      made["alphaMode"] = "BLEND";
      made["doubleSided"] = true;
      break;
    case Look::Creases:
      made["pbrMetallicRoughness"] = matt(1);
      made["alphaMode"] = "BLEND";
      made["doubleSided"] = true;
      made["extensions"][kUnlit] = Json::object();
      break;
    case Look::Hair:
    case Look::GreyHair:
      made["pbrMetallicRoughness"] = matt(0.65);
      made["alphaMode"] = "MASK";
      made["alphaCutoff"] = 0.5;
      break;
    case Look::Cloth:
      made["pbrMetallicRoughness"] = matt(0.95);
      made["doubleSided"] = true;
      break;
  }
  return made;
}

/// One file being put together.
class FaceFile {
 public:
  FaceFile(const face::Face& face, const MorphTargets& targets, const FaceRig& rig)
      : face_(face), targets_(targets), rig_(rig) {
    face::FaceDeformer deformer(face);
    normals_ = deformer.deform(std::vector<float>(face.channels.size())).normals;
    for (std::size_t i = 0; i < rig.joints().size(); ++i) {
      const Joint& joint = rig.joints()[i];
      nodes_.push_back(
          {{"name", joint.name}, {"translation", vector_of(kMetresPerUnit * rig.from_parent(i))}});
      if (i != 0) nodes_[joint.parent]["children"].push_back(i);
    }
    scene_nodes_.push_back(0);
    for (const Target& target : targets.all()) names_.push_back(target.name);
  }

  Result<void> add(const Surface& surface);
  void add(const Motion& motion);
  std::string finish(const About& about);

 private:
  std::optional<std::size_t> only_joint(const Surface& surface) const;
  Json attributes(const Surface& surface, std::optional<std::size_t> joint);
  Json targets(const Surface& surface);
  void hang(const Surface& surface, std::optional<std::size_t> joint, std::size_t mesh);
  void need_skin();
  Result<int> strands(bool grey);

  const face::Face& face_;
  const MorphTargets& targets_;
  const FaceRig& rig_;
  GlbFile file_;
  std::vector<glm::vec3> normals_;  ///< of the neutral face
  Json nodes_ = Json::array();
  Json scene_nodes_ = Json::array();
  Json meshes_ = Json::array();
  Json materials_ = Json::array();
  Json textures_ = Json::array();
  Json animation_;
  Json names_ = Json::array();
  std::vector<std::size_t> morphing_;  ///< nodes
  std::optional<int> inverse_;         ///< matrices of the skin
  bool unlit_ = false;
};

std::optional<std::size_t> FaceFile::only_joint(const Surface& surface) const {
  const auto joint = rig_.carried(surface.vertices.front()).wholly();
  for (const std::uint32_t i : surface.vertices) {
    if (rig_.carried(i).wholly() != joint) return std::nullopt;
  }
  return joint;
}

Json FaceFile::attributes(const Surface& surface, std::optional<std::size_t> joint) {
  const glm::vec3 from = joint ? rig_.joints()[*joint].position : glm::vec3(0);
  std::vector<glm::vec3> positions = positions_of(face_, surface);
  for (glm::vec3& position : positions) position = kMetresPerUnit * (position - from);
  std::vector<glm::vec4> colours = colours_of(face_, surface);
  if (surface.hair()) {
    const float gain = strand_picture_gain(surface.look == Look::GreyHair);
    for (glm::vec4& colour : colours) colour *= glm::vec4(gain, gain, gain, 1);
  }
  Json attributes{{"POSITION", file_.positions(positions)}};
  if (surface.look != Look::Creases) {
    std::vector<glm::vec3> normals;
    for (const std::uint32_t i : surface.vertices) normals.push_back(normals_[i]);
    attributes["NORMAL"] = file_.normals(normals);
  }
  attributes["COLOR_0"] = file_.colours(colours);
  if (surface.hair()) {
    attributes["TEXCOORD_0"] = file_.texture_coordinates(strand_coordinates(face_, surface));
  }
  if (joint) return attributes;
  std::vector<std::array<std::uint8_t, 4>> joints;
  std::vector<std::array<float, 4>> weights;
  for (const std::uint32_t i : surface.vertices) {
    const Carried carried = rig_.carried(i);
    joints.push_back(carried.joints);
    weights.push_back(carried.weights);
  }
  attributes["JOINTS_0"] = file_.joints(joints);
  attributes["WEIGHTS_0"] = file_.joint_weights(weights);
  return attributes;
}

/// All targets in each mesh, so that one list of weights moves them all.
Json FaceFile::targets(const Surface& surface) {
  constexpr std::uint32_t kElsewhere = std::numeric_limits<std::uint32_t>::max();
  const std::size_t count = surface.vertices.size();
  std::vector<std::uint32_t> own(face_.mesh.positions.size(), kElsewhere);
  for (std::uint32_t i = 0; i < count; ++i) own[surface.vertices[i]] = i;
  const auto here = [&](const std::vector<Change>& changes, float factor) {
    std::vector<Change> all;
    for (const Change& change : changes) {
      if (own[change.vertex] != kElsewhere) all.push_back({own[change.vertex], factor * change.by});
    }
    return all;
  };
  const std::vector<float> darkness =
      surface.look == Look::Creases ? darkness_of(face_, surface) : std::vector<float>();
  Json all = Json::array();
  for (const Target& target : targets_.all()) {
    const auto positions = here(target.positions, kMetresPerUnit);
    Json one{{"POSITION", file_.position_changes(positions, count)}};
    if (surface.look == Look::Creases) {
      std::vector<Change> shown;
      for (std::uint32_t i = 0; i < count; ++i) {
        const float dark = target.creases[surface.creases[i]] * darkness[i];
        if (dark > 0) shown.push_back({i, {0, 0, 0, dark}});
      }
      one["COLOR_0"] = file_.colour_changes(shown, count);
    } else if (surface.look != Look::Brows) {  // hairs too thin for their light to tell
      one["NORMAL"] = file_.normal_changes(here(target.normals, 1), count);
    }
    all.push_back(std::move(one));
  }
  return all;
}

/// All skinned meshes have the same joints: there is one skin.
void FaceFile::need_skin() {
  if (inverse_) return;
  std::vector<std::array<float, 16>> matrices;
  for (const Joint& joint : rig_.joints()) {
    const glm::vec3 back = -kMetresPerUnit * joint.position;
    matrices.push_back({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, back.x, back.y, back.z, 1});
  }
  inverse_ = file_.inverse_bind_matrices(matrices);
}

void FaceFile::hang(const Surface& surface, std::optional<std::size_t> joint, std::size_t mesh) {
  const std::size_t node = nodes_.size();
  nodes_.push_back({{"name", surface.name}, {"mesh", mesh}});
  if (surface.morphs() && !names_.empty()) morphing_.push_back(node);
  if (joint) {
    nodes_[*joint]["children"].push_back(node);
  } else {
    need_skin();
    nodes_[node]["skin"] = 0;
    scene_nodes_.push_back(node);
  }
}

Result<int> FaceFile::strands(bool grey) {
  const auto png = view::png_bytes(strand_picture(grey));
  if (!png) return png.error();
  textures_.push_back({{"source", file_.png(*png)}, {"sampler", 0}});
  return static_cast<int>(textures_.size()) - 1;
}

Result<void> FaceFile::add(const Surface& surface) {
  const auto joint = only_joint(surface);
  Json primitive{{"attributes", attributes(surface, joint)},
                 {"indices", file_.triangles(surface.triangles, surface.vertices.size())},
                 {"material", materials_.size()}};
  Json mesh{{"name", surface.name}};
  if (surface.morphs() && !names_.empty()) {
    primitive["targets"] = targets(surface);
    mesh["weights"] = std::vector<int>(names_.size(), 0);
    mesh["extras"]["targetNames"] = names_;
  }
  mesh["primitives"] = Json::array({std::move(primitive)});
  materials_.push_back(material(surface));
  if (surface.hair()) {
    const auto texture = strands(surface.look == Look::GreyHair);
    if (!texture) return texture.error();
    materials_.back()["pbrMetallicRoughness"]["baseColorTexture"]["index"] = *texture;
  }
  unlit_ = unlit_ || surface.look == Look::Creases;
  hang(surface, joint, meshes_.size());
  meshes_.push_back(std::move(mesh));
  return {};
}

void FaceFile::add(const Motion& motion) {
  const int input = file_.sample_times(motion.seconds);
  animation_ = {{"name", motion.name}, {"samplers", Json::array()}, {"channels", Json::array()}};
  const auto sampler = [&](int output) {
    animation_["samplers"].push_back({{"input", input}, {"output", output}});
    return animation_["samplers"].size() - 1;
  };
  const auto channel = [&](std::size_t sampled, std::size_t node, const char* path) {
    animation_["channels"].push_back(
        {{"sampler", sampled}, {"target", {{"node", node}, {"path", path}}}});
  };
  if (!morphing_.empty()) {
    const std::size_t weights = sampler(file_.morph_weights(motion.weights));
    for (const std::size_t node : morphing_) channel(weights, node, "weights");
  }
  for (std::size_t k = 0; k < rig_.joints().size(); ++k) {
    const glm::vec3 from_parent = rig_.from_parent(k);
    std::vector<glm::quat> rotations;
    std::vector<glm::vec3> translations;
    bool rotates = false;
    bool translates = false;
    for (const std::vector<JointPose>& poses : motion.joints) {
      rotates = rotates || poses[k].rotation != JointPose{}.rotation;
      translates = translates || poses[k].translation != JointPose{}.translation;
      rotations.push_back(glm::normalize(poses[k].rotation));
      translations.push_back(kMetresPerUnit * (from_parent + poses[k].translation));
    }
    if (rotates) channel(sampler(file_.rotations(rotations)), k, "rotation");
    if (translates) channel(sampler(file_.translations(translations)), k, "translation");
  }
}

std::string FaceFile::finish(const About& about) {
  Json& document = file_.document();
  document["asset"]["generator"] = "face-player";
  if (!about.licence.empty()) document["asset"]["copyright"] = about.licence;
  Json extensions = Json::array();
  if (unlit_) extensions.push_back(kUnlit);
  if (!names_.empty()) {
    extensions.push_back(kQuantization);
    document["extensionsRequired"] = {kQuantization};
  }
  if (!extensions.empty()) document["extensionsUsed"] = std::move(extensions);
  document["scene"] = 0;
  document["scenes"] = {{{"name", face_.name},
                         {"nodes", std::move(scene_nodes_)},
                         {"extras", {{"aucast", face_notes(face_, targets_, rig_, about)}}}}};
  document["nodes"] = std::move(nodes_);
  if (inverse_) {
    std::vector<std::size_t> joints;
    for (std::size_t i = 0; i < rig_.joints().size(); ++i) joints.push_back(i);
    document["skins"] = {
        {{"inverseBindMatrices", *inverse_}, {"skeleton", 0}, {"joints", std::move(joints)}}};
  }
  document["meshes"] = std::move(meshes_);
  document["materials"] = std::move(materials_);
  if (!textures_.empty()) {
    document["textures"] = std::move(textures_);
    document["samplers"] = {{{"minFilter", 9987}, {"magFilter", 9729}}};  // mipmaps; linear
  }
  if (!animation_.is_null()) document["animations"] = Json::array({std::move(animation_)});
  return file_.bytes();
}

}  // namespace

Result<std::string> face_glb(const face::Face& face, const MorphTargets& targets,
                             const FaceRig& rig, const Motion* motion, const About& about) {
  FaceFile file(face, targets, rig);
  for (const Surface& surface : surfaces_of(face)) {
    if (auto added = file.add(surface); !added) return added.error();
  }
  if (motion != nullptr) file.add(*motion);
  std::string bytes = file.finish(about);
  if (bytes.size() > kBytesMax) {
    return Error{ErrorKind::Failed, "the animation is more than a GLB can hold, 4 GB"};
  }
  return bytes;
}

}  // namespace aucast::glb

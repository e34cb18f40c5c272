#include "client/glb/morph_targets.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "client/face/drawn_blocks.h"
#include "client/face/face_deformer.h"
#include "client/face/muscle_mixer.h"
#include "client/glb/units.h"

namespace aucast::glb {
namespace {

constexpr float kLeastWay = 0.0036F;  ///< mesh units: 0.05 mm
constexpr float kLeastTurn = 0.035F;  ///< of a normal: two degrees, which no light shows
constexpr float kLeastArc = 0.015F;   ///< mesh units: what a target of its own is worth, 0.2 mm

std::vector<Target> of_channels(const face::Face& face, const FaceRig& rig) {
  std::vector<Target> targets;
  for (std::size_t i = 0; i < face.channels.size(); ++i) {
    if (rig.takes(i) && i != rig.jaw_channel()) continue;
    Target& target = targets.emplace_back();
    target.name = face.channels[i].name;
    target.channel = i;
    target.pose.resize(face.channels.size());
    target.pose[i] = face.channels[i].activation_max;
  }
  return targets;
}

std::vector<Target> of_aus(const face::Face& face, const FaceRig& rig) {
  std::vector<Target> targets;
  for (const auto& [number, recording] : face.recordings) {
    if (number == 0) continue;
    for (const Side side : {Side::Left, Side::Right}) {
      Target& target = targets.emplace_back();
      target.name = "AU" + std::to_string(number) + (side == Side::Left ? "_L" : "_R");
      target.au = number;
      target.side = side;
      target.pose = side_of_au(face, number, side);
      for (std::size_t i = 0; i < target.pose.size(); ++i) {
        if (rig.takes(i)) target.pose[i] = 0;
      }
    }
  }
  return targets;
}

/// The vertices that targets may change.
std::vector<bool> changeable(const face::FaceMesh& mesh) {
  std::vector<bool> all(mesh.positions.size());
  for (const face::MeshPart& part : mesh.parts) {
    const bool still =
        part.material == face::Material::Hair || part.material == face::Material::GreyHair ||
        part.material == face::Material::Cloth || part.material == face::Material::Eye;
    std::fill_n(all.begin() + part.vertex_begin, part.vertex_count, !still);
  }
  return all;
}

std::vector<Change> differences(const std::vector<glm::vec3>& now,
                                const std::vector<glm::vec3>& rest, const std::vector<bool>& which,
                                float least) {
  std::vector<Change> changes;
  for (std::size_t i = 0; i < now.size(); ++i) {
    const glm::vec3 by = now[i] - rest[i];
    if (which[i] && glm::dot(by, by) > least * least) {
      changes.push_back({static_cast<std::uint32_t>(i), glm::vec4(by, 0)});
    }
  }
  return changes;
}

/// The same for positions, in the steps that the file has.
std::vector<Change> position_differences(const std::vector<glm::vec3>& now,
                                         const std::vector<glm::vec3>& rest,
                                         const std::vector<bool>& which) {
  std::vector<Change> changes = differences(now, rest, which, kLeastWay);
  for (Change& change : changes) {
    const glm::vec3 stored = stored_position_change(kMetresPerUnit * glm::vec3(change.by));
    change.by = glm::vec4(stored / kMetresPerUnit, 0);
  }
  return changes;
}

/// Turns poses into targets.
class Sculptor {
 public:
  Sculptor(const face::Face& face, const FaceRig& rig)
      : rig_(rig), deformer_(face), drawn_(face.channels.size()), kept_(face::kept_depths(face)) {
    // A crease of depth 0 does not go along: all are drawn, at rest too.
    for (const face::MeshPart& part : face.mesh.parts) {
      const auto channel = face::is_crease(part) ? face.channel_index(part.name) : std::nullopt;
      if (channel) drawn_[*channel] = 1;
    }
    rest_ = deformer_.deform(drawn_);
    which_ = changeable(face.mesh);
  }

  /// Fills in what the target's pose changes. Returns false if that is nothing.
  bool sculpt(Target& target) {
    target.creases = deformer_.deform(target.pose).creases;
    // What the skin keeps is there without a target.
    for (std::size_t i = 0; i < kept_.size(); ++i) target.creases[i] -= kept_[i];
    target.positions = position_differences(posed(target.pose), rest_.positions, which_);
    target.normals = differences(normals_, rest_.normals, which_, kLeastTurn);
    return !target.positions.empty() || std::any_of(target.creases.begin(), target.creases.end(),
                                                    [](float depth) { return depth > 0; });
  }

  /// The target for what half the pose does beyond half of the target; nullopt if that is little.
  std::optional<Target> arc_of(const Target& target) {
    Target arc = target;
    arc.name += "_arc";
    arc.arc = true;
    for (float& activation : arc.pose) activation /= 2;
    std::vector<glm::vec3> straight = rest_.positions;
    for (const Change& change : target.positions)
      straight[change.vertex] += 0.5F * glm::vec3(change.by);
    const std::vector<glm::vec3> half = posed(arc.pose);
    if (differences(half, straight, which_, kLeastArc).empty()) return std::nullopt;
    arc.positions = position_differences(half, straight, which_);
    arc.normals.clear();
    std::fill(arc.creases.begin(), arc.creases.end(), 0.0F);
    return arc;
  }

 private:
  /// Where the pose puts the vertices, without what joints do. Keeps the normals of the pose.
  std::vector<glm::vec3> posed(std::vector<float> pose) {
    const std::vector<JointPose> joints = rig_.pose(pose);
    // Not asked of the carriers, which at rest are identities but for their last digits.
    const bool carried = std::any_of(joints.begin(), joints.end(),
                                     [](const JointPose& joint) { return joint.moved(); });
    const std::vector<glm::mat4> carriers = rig_.carriers(joints);
    for (std::size_t i = 0; i < pose.size(); ++i) pose[i] = std::max(pose[i], drawn_[i]);
    const face::DeformedFace& deformed = deformer_.deform(pose);
    std::vector<glm::vec3> positions = deformed.positions;
    normals_ = carried ? rest_.normals : deformed.normals;
    for (std::size_t i = 0; carried && i < positions.size(); ++i) {
      const Carried by = rig_.carried(i);
      glm::mat4 carrier(0);
      for (std::size_t k = 0; k < by.joints.size(); ++k) {
        carrier += by.weights[k] * carriers[by.joints[k]];
      }
      positions[i] = glm::vec3(glm::inverse(carrier) * glm::vec4(positions[i], 1));
    }
    return positions;
  }

  const FaceRig& rig_;
  face::FaceDeformer deformer_;
  std::vector<float> drawn_;  ///< activations of the creases alone
  std::vector<float> kept_;
  face::DeformedFace rest_;
  std::vector<bool> which_;
  std::vector<glm::vec3> normals_;
};

}  // namespace

std::vector<float> side_of_au(const face::Face& face, int number, Side side) {
  AuFrame aus;
  const bool alone = shows_on_one_side(number);
  const auto at = static_cast<std::size_t>(number);
  aus.left[at] = !alone || side == Side::Left ? 1.0F : 0.0F;
  aus.right[at] = !alone || side == Side::Right ? 1.0F : 0.0F;
  std::vector<float> activations(face.channels.size());
  face::mix(face, aus, face::Mixer::Maximum, activations);
  for (std::size_t i = 0; i < activations.size(); ++i) {
    if (face.channels[i].side == opposite(side)) activations[i] = 0;
    if (face.channels[i].side == Side::Both && !alone) activations[i] /= 2;
  }
  return activations;
}

MorphTargets::MorphTargets(const face::Face& face, Basis basis, const FaceRig& rig)
    : basis_(basis) {
  Sculptor sculptor(face, rig);
  for (Target& target : basis == Basis::Muscles ? of_channels(face, rig) : of_aus(face, rig)) {
    if (!sculptor.sculpt(target)) continue;
    // Of AUs there are none: who drives by hand wants one number for each.
    auto arc = basis == Basis::Muscles ? sculptor.arc_of(target) : std::nullopt;
    targets_.push_back(std::move(target));
    if (arc) targets_.push_back(std::move(*arc));
  }
}

std::vector<std::uint8_t> MorphTargets::weights(const face::Face& face,
                                                const pipeline::FaceState& state) const {
  std::vector<std::uint8_t> weights;
  for (const Target& target : targets_) {
    const auto at = static_cast<std::size_t>(target.au);
    const float weight =
        target.au == 0
            ? state.activations[target.channel] / face.channels[target.channel].activation_max
            : (target.side == Side::Left ? state.aus.left : state.aus.right)[at];
    const float own = target.weight(std::clamp(weight, 0.0F, 1.0F));
    weights.push_back(static_cast<std::uint8_t>(std::lround(255 * own)));
  }
  return weights;
}

}  // namespace aucast::glb

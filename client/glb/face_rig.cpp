#include "client/glb/face_rig.h"

#include <algorithm>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

namespace aucast::glb {
namespace {

const glm::vec3 kX(1, 0, 0);
const glm::vec3 kY(0, 1, 0);
const glm::vec3 kZ(0, 0, 1);

/// How much of the head's turn the neck has. Between joints vertices go straight: with this share
/// shoulders, which hardly turn, and the neck are both close to where they really go.
constexpr float kNeckShare = 0.35F;

/// A smaller weight would be 0 in 16 bits.
constexpr float kLeastWeight = 1e-4F;

/// First tilted to the left, then what is in front goes up, then to the left (face/block_turns.h).
glm::quat turned(float tilt_rad, float up_rad, float left_rad) {
  return glm::angleAxis(left_rad, kY) * glm::angleAxis(-up_rad, kX) * glm::angleAxis(-tilt_rad, kZ);
}

}  // namespace

std::optional<std::size_t> Carried::wholly() const {
  return weights[1] == 0 ? std::optional<std::size_t>(joints[0]) : std::nullopt;
}

FaceRig::FaceRig(const face::Face& face, bool with_jaw) : face_(face) {
  add("body", 0, {0, 0, 0});
  if (face.head) add_head();
  const std::size_t parent = head_.value_or(0);
  if (face.jaw && with_jaw) add_jaw(parent);
  for (const face::Eye& eye : face.eyes) add_eye(eye, parent);
}

std::size_t FaceRig::add(std::string name, std::size_t parent, const glm::vec3& position) {
  joints_.push_back({std::move(name), parent, position});
  return joints_.size() - 1;
}

face::OpposedChannels FaceRig::take(const face::OpposedNames& names, Side side) {
  const face::OpposedChannels channels = face::opposed(face_, names, side);
  for (const auto& channel : {channels.plus, channels.minus}) {
    if (channel) taken_.push_back(*channel);
  }
  return channels;
}

void FaceRig::add_head() {
  turn_ = take(face::kHeadTurn);
  pitch_ = take(face::kHeadPitch);
  tilt_ = take(face::kHeadTilt);
  shift_ = take(face::kHeadShift);
  head_ = add("head", add("neck", 0, face_.head->pivot), face_.head->pivot);
}

void FaceRig::add_jaw(std::size_t parent) {
  jaw_channel_ = face_.channel_index("jaw");
  if (!jaw_channel_) return;
  taken_.push_back(*jaw_channel_);
  jaw_ = add("jaw", parent, face_.jaw->hinge);
}

void FaceRig::add_eye(const face::Eye& eye, std::size_t parent) {
  const Side side = face::side_at(eye.centre.x);
  EyeJoint joint{.joint = add(eye.part, parent, eye.centre),
                 .yaw = take(face::kGazeYaw, side),
                 .pitch = take(face::kGazePitch, side),
                 .yaw_rad = glm::radians(eye.yaw_deg),
                 .pitch_rad = glm::radians(eye.pitch_deg)};
  for (const face::MeshPart& part : face_.mesh.parts) {
    if (part.name != eye.part) continue;
    joint.vertex_begin = part.vertex_begin;
    joint.vertex_end = part.vertex_begin + part.vertex_count;
  }
  eyes_.push_back(joint);
}

bool FaceRig::takes(std::size_t channel) const {
  return std::find(taken_.begin(), taken_.end(), channel) != taken_.end();
}

Carried FaceRig::carried(std::size_t vertex) const {
  for (const EyeJoint& eye : eyes_) {
    if (vertex >= eye.vertex_begin && vertex < eye.vertex_end) {
      return {{static_cast<std::uint8_t>(eye.joint)}, {1, 0, 0, 0}};
    }
  }
  const float jaw =
      jaw_ ? std::clamp(face::map_at(face::find_map(face_.mesh, "jaw"), vertex, 0), 0.0F, 1.0F) : 0;
  const float head =
      head_ ? std::clamp(face::map_at(face::find_map(face_.mesh, "head"), vertex, 0), 0.0F, 1.0F)
            : 0;
  // From body to neck, then from neck to head; what goes with the head may go with the jaw.
  const float above = head_ ? std::max(head - kNeckShare, 0.0F) / (1 - kNeckShare) : 1;
  const float below = head_ ? std::max(kNeckShare - head, 0.0F) / kNeckShare : 0;
  const std::size_t top = head_.value_or(0);
  const std::array<std::pair<std::size_t, float>, 4> all{{{jaw_.value_or(0), jaw * above},
                                                          {top, (1 - jaw) * above},
                                                          {head_ ? top - 1 : 0, 1 - above - below},
                                                          {0, below}}};
  Carried carried{{}, {}};
  std::size_t next = 0;
  float left = 1;
  for (const auto& [joint, weight] : all) {
    if (weight < kLeastWeight) continue;
    carried.joints[next] = static_cast<std::uint8_t>(joint);
    carried.weights[next++] = weight;
    left -= weight;
  }
  carried.weights[0] += left;
  return carried;
}

std::vector<JointPose> FaceRig::pose(std::span<const float> activations) const {
  std::vector<JointPose> poses(joints_.size());
  if (head_) {
    const face::HeadPose& most = *face_.head;
    const glm::vec3 angles = glm::radians(glm::vec3(most.tilt_deg * tilt_.of(activations),
                                                    most.pitch_deg * pitch_.of(activations),
                                                    most.turn_deg * turn_.of(activations)));
    const glm::vec3 forward = most.shift * shift_.of(activations) * kZ;
    const glm::vec3 part = kNeckShare * angles;
    const glm::quat neck = turned(part.x, part.y, part.z);
    poses[*head_ - 1] = {neck, kNeckShare * forward};
    poses[*head_] = {glm::inverse(neck) * turned(angles.x, angles.y, angles.z),
                     glm::inverse(neck) * ((1 - kNeckShare) * forward)};
  }
  if (jaw_) {
    const float down = glm::radians(face_.jaw->degrees_per_unit) * activations[*jaw_channel_];
    poses[*jaw_] = {glm::angleAxis(down, kX), face_.jaw->forward_per_rad * down * kZ};
  }
  for (const EyeJoint& eye : eyes_) {
    poses[eye.joint].rotation =
        turned(0, eye.pitch_rad * eye.pitch.of(activations), eye.yaw_rad * eye.yaw.of(activations));
  }
  return poses;
}

glm::vec3 FaceRig::from_parent(std::size_t joint) const {
  const Joint& own = joints_[joint];
  return joint == 0 ? own.position : own.position - joints_[own.parent].position;
}

std::vector<glm::mat4> FaceRig::carriers(std::span<const JointPose> poses) const {
  std::vector<glm::mat4> stands;  // of the joints themselves
  std::vector<glm::mat4> carriers;
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const Joint& joint = joints_[i];
    const glm::mat4 here = glm::translate(glm::mat4(1), from_parent(i) + poses[i].translation) *
                           glm::mat4_cast(poses[i].rotation);
    stands.push_back(i == 0 ? here : stands[joint.parent] * here);
    carriers.push_back(stands.back() * glm::translate(glm::mat4(1), -joint.position));
  }
  return carriers;
}

}  // namespace aucast::glb

#include "client/face/face_deformer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>

#include "client/face/block_turns.h"
#include "client/face/face_folder.h"
#include "client/face/normal_field.h"
#include "client/face/vertex_block.h"
#include "common/check.h"

namespace aucast::face {
namespace {

constexpr float kRadPerDeg = std::numbers::pi_v<float> / 180.0F;
constexpr Lanes kAllLanes{1, 1, 1, 1, 1, 1, 1, 1};

/// What a muscle does per unit of activation, in the blocks where it does something.
struct MuscleField {
  float activation_cap = std::numeric_limits<float>::infinity();
  std::vector<std::uint32_t> blocks;
  std::vector<VertexBlock> per_unit;
};

/// Two channels that pull opposite ways; a missing one is nothing.
struct OpposedChannels {
  std::optional<std::size_t> plus;
  std::optional<std::size_t> minus;
};

struct LidField {
  std::optional<std::size_t> close;
  std::optional<std::size_t> raise;
  glm::vec3 centre{0};
  WeightedBlocks angles;  ///< radians at full closure, positive downwards
};

struct EyeField {
  OpposedChannels yaw;    ///< to the left, to the right
  OpposedChannels pitch;  ///< up, down
  float yaw_rad = 0;
  float pitch_rad = 0;
  glm::vec3 centre{0};
  float head_share = 0;  ///< how much of the head's turn the eye takes part in
  WeightedBlocks part;
};

struct HeadField {
  OpposedChannels turn;
  OpposedChannels pitch;
  OpposedChannels tilt;
  OpposedChannels shift;
  WeightedBlocks weights;
};

/// The map's value, or `missing` when the mesh does not have it.
float map_at(const std::vector<float>* map, std::size_t vertex, float missing) {
  return map == nullptr ? missing : (*map)[vertex];
}

const std::vector<float>* find_map(const FaceMesh& mesh, const std::string& map_name) {
  const auto found = mesh.maps.find(map_name);
  return found == mesh.maps.end() ? nullptr : &found->second;
}

/// Gathers the blocks in which `weight(vertex)` is not zero everywhere.
template <typename Weight>
WeightedBlocks gather(std::size_t vertex_count, Weight weight) {
  WeightedBlocks result;
  for (std::size_t block = 0; block < block_count(vertex_count); ++block) {
    Lanes lanes{};
    for (std::size_t i = 0; i < kLanes && block * kLanes + i < vertex_count; ++i) {
      lanes[i] = weight(block * kLanes + i);
    }
    if (lanes == Lanes{}) continue;
    result.blocks.push_back(static_cast<std::uint32_t>(block));
    result.weights.push_back(lanes);
  }
  return result;
}

MuscleField field_of(const Muscle& muscle, const FaceMesh& mesh) {
  MuscleField field;
  const auto* const reach = find_map(mesh, "muscle");
  const auto* const mask = muscle.mask.empty() ? nullptr : find_map(mesh, muscle.mask);
  for (std::size_t block = 0; block < block_count(mesh.positions.size()); ++block) {
    VertexBlock lanes;
    bool moves = false;
    for (std::size_t i = 0; i < kLanes && block * kLanes + i < mesh.positions.size(); ++i) {
      const std::size_t vertex = block * kLanes + i;
      const float factor = map_at(reach, vertex, 1) * map_at(mask, vertex, 1);
      if (factor == 0) continue;
      const LinearInfluence linear = influence(muscle.shape, mesh.positions[vertex]);
      if (linear.per_unit == glm::vec3(0)) continue;
      lanes.x[i] = factor * linear.per_unit.x;
      lanes.y[i] = factor * linear.per_unit.y;
      lanes.z[i] = factor * linear.per_unit.z;
      field.activation_cap = linear.activation_cap;  // the same at every vertex of a muscle
      moves = true;
    }
    if (!moves) continue;
    field.blocks.push_back(static_cast<std::uint32_t>(block));
    field.per_unit.push_back(lanes);
  }
  return field;
}

std::string sided_name(Side side, std::string_view base) {
  const std::string_view prefix = side == Side::Left    ? "left_"
                                  : side == Side::Right ? "right_"
                                                        : "";
  return std::string(prefix) + std::string(base);
}

}  // namespace

struct FaceDeformer::State {
  explicit State(const Face& driven);

  void take(std::span<const float> given);
  [[nodiscard]] float value(const std::optional<std::size_t>& channel) const {
    return channel ? activations[*channel] : 0.0F;
  }
  [[nodiscard]] float difference(const OpposedChannels& channels) const {
    return value(channels.plus) - value(channels.minus);
  }
  void move();
  void move_muscles();
  void move_jaw();
  void move_lids();
  void move_eyes();
  void move_head();
  void turn_head(VertexBlock& block, const Lanes& weights) const;
  void look(DeformedFace& out) const;
  void write(std::vector<glm::vec3>& out) const;

  const Face& face;
  std::size_t vertex_count;
  std::vector<VertexBlock> rest;
  std::vector<VertexBlock> now;
  std::vector<std::uint8_t> moved;  ///< one flag per block
  std::vector<float> activations;   ///< clamped
  std::vector<MuscleField> muscles;
  std::optional<std::size_t> jaw_channel;
  WeightedBlocks jaw;
  std::vector<LidField> lids;
  std::vector<EyeField> eyes;
  HeadField head;
  std::vector<std::optional<std::size_t>> creases;  ///< channels of the mesh's creases
  NormalField normals;
};

FaceDeformer::State::State(const Face& driven)
    : face(driven),
      vertex_count(driven.mesh.positions.size()),
      rest(block_count(vertex_count)),
      moved(rest.size()),
      activations(driven.channels.size()),
      normals(driven.mesh) {
  AUCAST_CHECK(face.muscles.size() <= face.channels.size());
  for (std::size_t i = 0; i < vertex_count; ++i) {
    VertexBlock& block = rest[i / kLanes];
    block.x[i % kLanes] = face.mesh.positions[i].x;
    block.y[i % kLanes] = face.mesh.positions[i].y;
    block.z[i % kLanes] = face.mesh.positions[i].z;
  }
  now = rest;
  for (const Muscle& muscle : face.muscles) muscles.push_back(field_of(muscle, face.mesh));

  const auto channel = [this](std::string_view name) { return face.channel_index(name); };
  const auto* const jaw_map = find_map(face.mesh, "jaw");
  if (face.jaw) {
    jaw_channel = channel("jaw");
    jaw = gather(vertex_count, [&](std::size_t i) { return map_at(jaw_map, i, 0); });
  }
  const auto* const lid_map = find_map(face.mesh, "lid_angle");
  const auto* const head_map = find_map(face.mesh, "head");
  for (const Eye& eye : face.eyes) {
    const Side side = side_at(eye.centre.x);
    if (face.lids) {
      const auto angle_here = [&](std::size_t i) {
        const bool left = face.mesh.positions[i].x >= 0;
        const bool mine = side == Side::Both || left == (side == Side::Left);
        return mine ? map_at(lid_map, i, 0) : 0.0F;
      };
      lids.push_back({channel(sided_name(side, "lid_close")),
                      channel(sided_name(side, "lid_raise")), eye.centre,
                      gather(vertex_count, angle_here)});
    }
    EyeField field;
    field.yaw = {channel(sided_name(side, "gaze_left")), channel(sided_name(side, "gaze_right"))};
    field.pitch = {channel(sided_name(side, "gaze_up")), channel(sided_name(side, "gaze_down"))};
    field.yaw_rad = kRadPerDeg * eye.yaw_deg;
    field.pitch_rad = kRadPerDeg * eye.pitch_deg;
    field.centre = eye.centre;
    for (const MeshPart& part : face.mesh.parts) {
      if (part.name != eye.part) continue;
      field.part = gather(vertex_count, [&](std::size_t i) {
        return i >= part.vertex_begin && i - part.vertex_begin < part.vertex_count ? 1.0F : 0.0F;
      });
      field.head_share = map_at(head_map, part.vertex_begin, 0);
    }
    eyes.push_back(std::move(field));
  }
  for (const MeshPart& part : face.mesh.parts) {
    if (part.material == Material::Crease) creases.push_back(channel(part.name));
  }
  if (face.head) {
    head.turn = {channel("head_turn_left"), channel("head_turn_right")};
    head.pitch = {channel("head_up"), channel("head_down")};
    head.tilt = {channel("head_tilt_left"), channel("head_tilt_right")};
    head.shift = {channel("head_forward"), channel("head_back")};
    head.weights = gather(vertex_count, [&](std::size_t i) { return map_at(head_map, i, 0); });
  }
}

void FaceDeformer::State::take(std::span<const float> given) {
  AUCAST_CHECK(given.size() == face.channels.size());
  for (std::size_t i = 0; i < given.size(); ++i) {
    activations[i] =
        std::isfinite(given[i]) ? std::clamp(given[i], 0.0F, face.channels[i].activation_max) : 0;
  }
}

void FaceDeformer::State::move() {
  now = rest;
  std::fill(moved.begin(), moved.end(), std::uint8_t{0});
  move_muscles();
  move_lids();
  move_jaw();
  move_eyes();
  move_head();
}

void FaceDeformer::State::move_muscles() {
  for (std::size_t m = 0; m < muscles.size(); ++m) {
    const MuscleField& field = muscles[m];
    const float activation = std::min(activations[m], field.activation_cap);
    if (activation == 0) continue;
    for (std::size_t k = 0; k < field.blocks.size(); ++k) {
      VertexBlock& block = now[field.blocks[k]];
      const VertexBlock& per_unit = field.per_unit[k];
      moved[field.blocks[k]] = 1;
      for (std::size_t i = 0; i < kLanes; ++i) block.x[i] += activation * per_unit.x[i];
      for (std::size_t i = 0; i < kLanes; ++i) block.y[i] += activation * per_unit.y[i];
      for (std::size_t i = 0; i < kLanes; ++i) block.z[i] += activation * per_unit.z[i];
    }
  }
}

void FaceDeformer::State::move_lids() {
  for (const LidField& lid : lids) {
    const float closure = value(lid.close) - face.lids->raise_max * value(lid.raise);
    if (closure == 0) continue;
    for (std::size_t k = 0; k < lid.angles.blocks.size(); ++k) {
      moved[lid.angles.blocks[k]] = 1;
      pitch(now[lid.angles.blocks[k]], lid.angles.weights[k], -closure, lid.centre.y, lid.centre.z);
    }
  }
}

void FaceDeformer::State::move_jaw() {
  const float angle = value(jaw_channel) * (face.jaw ? kRadPerDeg * face.jaw->degrees_per_unit : 0);
  if (angle == 0) return;
  for (std::size_t k = 0; k < jaw.blocks.size(); ++k) {
    VertexBlock& block = now[jaw.blocks[k]];
    const Lanes& weights = jaw.weights[k];
    moved[jaw.blocks[k]] = 1;
    pitch(block, weights, -angle, face.jaw->hinge.y, face.jaw->hinge.z);
    const float forward = face.jaw->forward_per_rad * angle;
    for (std::size_t i = 0; i < kLanes; ++i) block.z[i] += forward * weights[i];
  }
}

void FaceDeformer::State::move_eyes() {
  for (const EyeField& eye : eyes) {
    const float yaw_angle = eye.yaw_rad * difference(eye.yaw);
    const float pitch_angle = eye.pitch_rad * difference(eye.pitch);
    if (yaw_angle == 0 && pitch_angle == 0) continue;
    for (std::size_t k = 0; k < eye.part.blocks.size(); ++k) {
      VertexBlock& block = now[eye.part.blocks[k]];
      moved[eye.part.blocks[k]] = 1;
      pitch(block, eye.part.weights[k], pitch_angle, eye.centre.y, eye.centre.z);
      turn(block, eye.part.weights[k], yaw_angle, eye.centre.x, eye.centre.z);
    }
  }
}

/// The head tilts, nods about the axis through its own ears and then turns.
void FaceDeformer::State::turn_head(VertexBlock& block, const Lanes& weights) const {
  const HeadPose& pose = *face.head;
  const float tilt_angle = kRadPerDeg * pose.tilt_deg * difference(head.tilt);
  const float pitch_angle = kRadPerDeg * pose.pitch_deg * difference(head.pitch);
  const float turn_angle = kRadPerDeg * pose.turn_deg * difference(head.turn);
  const float shift = pose.shift * difference(head.shift);
  if (tilt_angle != 0) tilt(block, weights, tilt_angle, pose.pivot.x, pose.pivot.y);
  if (pitch_angle != 0) pitch(block, weights, pitch_angle, pose.pivot.y, pose.pivot.z);
  if (turn_angle != 0) turn(block, weights, turn_angle, pose.pivot.x, pose.pivot.z);
  for (std::size_t i = 0; i < kLanes; ++i) block.z[i] += shift * weights[i];
}

void FaceDeformer::State::move_head() {
  if (!face.head) return;
  if (difference(head.turn) == 0 && difference(head.pitch) == 0 && difference(head.tilt) == 0 &&
      difference(head.shift) == 0) {
    return;
  }
  for (std::size_t k = 0; k < head.weights.blocks.size(); ++k) {
    moved[head.weights.blocks[k]] = 1;
    turn_head(now[head.weights.blocks[k]], head.weights.weights[k]);
  }
}

void FaceDeformer::State::look(DeformedFace& out) const {
  out.eye_centres.resize(eyes.size());
  out.eye_forward.resize(eyes.size());
  for (std::size_t e = 0; e < eyes.size(); ++e) {
    const EyeField& eye = eyes[e];
    // Lane 0 is the centre, lane 1 a point one unit in front of it.
    VertexBlock block;
    for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
      block.x[i] = eye.centre.x;
      block.y[i] = eye.centre.y;
      block.z[i] = eye.centre.z + static_cast<float>(i);
    }
    pitch(block, kAllLanes, eye.pitch_rad * difference(eye.pitch), eye.centre.y, eye.centre.z);
    turn(block, kAllLanes, eye.yaw_rad * difference(eye.yaw), eye.centre.x, eye.centre.z);
    Lanes share{};
    share.fill(eye.head_share);
    if (face.head) turn_head(block, share);
    out.eye_centres[e] = {block.x[0], block.y[0], block.z[0]};
    const glm::vec3 forward{block.x[1] - block.x[0], block.y[1] - block.y[0],
                            block.z[1] - block.z[0]};
    const float length =
        std::sqrt(forward.x * forward.x + forward.y * forward.y + forward.z * forward.z);
    out.eye_forward[e] = forward / length;
  }
}

void FaceDeformer::State::write(std::vector<glm::vec3>& out) const {
  out.resize(vertex_count);
  for (std::size_t block = 0; block < now.size(); ++block) {
    const std::size_t begin = block * kLanes;
    const std::size_t count = std::min(kLanes, vertex_count - begin);
    for (std::size_t i = 0; i < count; ++i) {
      out[begin + i] = {now[block].x[i], now[block].y[i], now[block].z[i]};
    }
  }
}

FaceDeformer::FaceDeformer(const Face& face) : state_(std::make_unique<State>(face)) {}
FaceDeformer::~FaceDeformer() = default;
FaceDeformer::FaceDeformer(FaceDeformer&&) noexcept = default;
FaceDeformer& FaceDeformer::operator=(FaceDeformer&&) noexcept = default;

void FaceDeformer::deform(std::span<const float> activations, DeformedFace& out) {
  deform_positions(activations, out.positions);
  out.normals.resize(state_->vertex_count);
  state_->normals.compute(state_->moved, out.positions, out.normals);
  state_->look(out);
  out.creases.resize(state_->creases.size());
  for (std::size_t i = 0; i < out.creases.size(); ++i) {
    out.creases[i] = state_->value(state_->creases[i]);
  }
}

void FaceDeformer::deform_positions(std::span<const float> activations,
                                    std::vector<glm::vec3>& out) {
  state_->take(activations);
  state_->move();
  state_->write(out);
}

}  // namespace aucast::face

#include "client/face/face_deformer.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include <glm/geometric.hpp>

#include "client/face/block_turns.h"
#include "client/face/drawn_blocks.h"
#include "client/face/face_folder.h"
#include "client/face/head_turn.h"
#include "client/face/muscle_sums.h"
#include "client/face/normal_field.h"
#include "client/face/vertex_block.h"
#include "common/check.h"

namespace aucast::face {
namespace {

/// Two channels that pull opposite ways; a missing one is nothing.
struct OpposedChannels {
  std::optional<std::size_t> plus;
  std::optional<std::size_t> minus;
};

/// One turn about the x axis and one about the y axis; for a lid or the jaw only the first.
struct Turn {
  float pitch = 0;
  float yaw = 0;
  bool operator==(const Turn&) const = default;
};

struct LidField {
  std::optional<std::size_t> close;
  std::optional<std::size_t> raise;
  glm::vec3 centre{0};
  WeightedBlocks angles;  ///< radians at full closure, positive downwards
  Turn turn;
};

struct EyeField {
  OpposedChannels yaw;    ///< to the left, to the right
  OpposedChannels pitch;  ///< up, down
  float yaw_rad = 0;
  float pitch_rad = 0;
  glm::vec3 centre{0};
  float head_share = 0;  ///< how much of the head's turn the eye takes part in
  WeightedBlocks part;
  Turn turn;
};

struct HeadChannels {
  OpposedChannels turn;
  OpposedChannels pitch;
  OpposedChannels tilt;
  OpposedChannels shift;
};

/// Gathers the blocks in which `weight(vertex)` is not zero everywhere.
template <typename Weight>
WeightedBlocks gather(std::size_t vertex_count, Weight weight) {
  WeightedBlocks result;
  result.all = BlockSet(block_count(vertex_count));
  for (std::size_t block = 0; block < block_count(vertex_count); ++block) {
    Lanes lanes{};
    for (std::size_t i = 0; i < kLanes && block * kLanes + i < vertex_count; ++i) {
      lanes[i] = weight(block * kLanes + i);
    }
    if (lanes == Lanes{}) continue;
    result.blocks.push_back(static_cast<std::uint32_t>(block));
    result.weights.push_back(lanes);
    result.all.insert(block);
  }
  return result;
}

std::string sided_name(Side side, std::string_view base) {
  const std::string_view prefix = side == Side::Left    ? "left_"
                                  : side == Side::Right ? "right_"
                                                        : "";
  return std::string(prefix) + std::string(base);
}

/// Takes `next`; whatever is different moves the blocks.
void take_turn(Turn& turn, Turn next, const WeightedBlocks& part, BlockSet& moved) {
  if (next == turn) return;
  turn = next;
  moved |= part.all;
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
  void move(std::span<const float> given);
  void relax_yielding();
  void rest_vanished();
  void move_lids();
  void move_jaw();
  void move_eyes();
  void look();
  [[nodiscard]] HeadTurn::Pose head_pose() const;

  const Face& face;
  std::vector<float> activations;  ///< clamped
  MuscleSums muscles;
  std::vector<VertexBlock> now;  ///< before the head turns
  BlockSet moved;                ///< the blocks that are elsewhere than the last time
  BlockSet shown;                ///< likewise, with the head's turn
  std::optional<std::size_t> jaw_channel;
  WeightedBlocks jaw;
  Turn jaw_turn;
  std::vector<LidField> lids;
  std::vector<std::pair<std::size_t, std::size_t>>
      yielding;  ///< a muscle, and the lid it yields to
  std::vector<EyeField> eyes;
  HeadChannels head_channels;
  DrawnBlocks drawn;
  NormalField normals;
  std::optional<HeadTurn> head;
  DeformedFace result;
};

FaceDeformer::State::State(const Face& driven)
    : face(driven),
      activations(driven.channels.size()),
      muscles(driven),
      now(muscles.rest()),
      moved(now.size()),
      shown(now.size()),
      drawn(driven),
      normals(driven.mesh) {
  AUCAST_CHECK(face.muscles.size() <= face.channels.size());
  const std::size_t vertex_count = face.mesh.positions.size();
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
      const auto close = channel(sided_name(side, "lid_close"));
      for (std::size_t m = 0; close && m < face.muscles.size(); ++m) {
        if (!face.muscles[m].yields_to_lids || face.channels[m].side != side) continue;
        yielding.emplace_back(m, *close);
      }
      const auto angle_here = [&](std::size_t i) {
        const bool left = face.mesh.positions[i].x >= 0;
        const bool mine = side == Side::Both || left == (side == Side::Left);
        return mine ? map_at(lid_map, i, 0) : 0.0F;
      };
      lids.push_back({channel(sided_name(side, "lid_close")),
                      channel(sided_name(side, "lid_raise")),
                      eye.centre,
                      gather(vertex_count, angle_here),
                      {}});
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
  if (face.head) {
    head_channels = {{channel("head_turn_left"), channel("head_turn_right")},
                     {channel("head_up"), channel("head_down")},
                     {channel("head_tilt_left"), channel("head_tilt_right")},
                     {channel("head_forward"), channel("head_back")}};
    head.emplace(face);
  }
  result.positions = face.mesh.positions;
  result.normals.assign(vertex_count, {0, 0, 1});
  for (std::size_t block = 0; block < now.size(); ++block) shown.insert(block);
  normals.update(shown, result.normals);
}

void FaceDeformer::State::take(std::span<const float> given) {
  AUCAST_CHECK(given.size() == face.channels.size());
  for (std::size_t i = 0; i < given.size(); ++i) {
    activations[i] =
        std::isfinite(given[i]) ? std::clamp(given[i], 0.0F, face.channels[i].activation_max) : 0;
  }
  moved.clear();
  relax_yielding();
  muscles.take(activations, moved);
  for (LidField& lid : lids) {
    const float closure = value(lid.close) - face.lids->raised(value(lid.raise));
    take_turn(lid.turn, {-closure, 0}, lid.angles, moved);
  }
  if (face.jaw) {
    const float angle = value(jaw_channel) * kRadPerDeg * face.jaw->degrees_per_unit;
    take_turn(jaw_turn, {-angle, 0}, jaw, moved);
  }
  for (EyeField& eye : eyes) {
    const Turn turn{eye.pitch_rad * difference(eye.pitch), eye.yaw_rad * difference(eye.yaw)};
    take_turn(eye.turn, turn, eye.part, moved);
  }
  shown = moved;
  if (head) head->take(head_pose(), shown);
  drawn.take(activations);
  drawn.narrow(moved);
  drawn.narrow(shown);
  muscles.list(moved);
}

void FaceDeformer::State::relax_yielding() {
  for (const auto& [muscle, close] : yielding) {
    // Hardly while a lid only narrows, as it does with 6 and 7.
    activations[muscle] *= 1 - activations[close] * activations[close];
  }
}

/// Brings positions and normals to these activations.
void FaceDeformer::State::move(std::span<const float> given) {
  take(given);
  rest_vanished();
  if (shown.empty()) return;
  moved.for_each([this](std::size_t block) { muscles.at(block, now[block]); });
  move_lids();
  move_jaw();
  move_eyes();
  const auto show = [this](std::size_t block, const VertexBlock& place) {
    const std::array<Four, kLanes> points = points_of(place);
    normals.place(block, points);
    write_points(points, block_of(result.positions, block));
  };
  if (head && head->turned()) {
    shown.for_each([&](std::size_t block) {
      VertexBlock place = now[block];
      head->apply(block, place);
      show(block, place);
    });
  } else {
    shown.for_each([&](std::size_t block) { show(block, now[block]); });
  }
  normals.update(shown, result.normals);
}

/// Where a crease stays that is not drawn must not tell what was shown before.
void FaceDeformer::State::rest_vanished() {
  drawn.vanished().for_each([this](std::size_t block) {
    write_points(points_of(muscles.rest()[block]), block_of(result.positions, block));
  });
}

void FaceDeformer::State::move_lids() {
  for (const LidField& lid : lids) {
    if (lid.turn == Turn{}) continue;
    for (std::size_t k = 0; k < lid.angles.blocks.size(); ++k) {
      const std::uint32_t block = lid.angles.blocks[k];
      if (!moved.contains(block)) continue;
      pitch(now[block], lid.angles.weights[k], lid.turn.pitch, lid.centre.y, lid.centre.z);
    }
  }
}

void FaceDeformer::State::move_jaw() {
  if (jaw_turn == Turn{}) return;
  const float forward = face.jaw->forward_per_rad * -jaw_turn.pitch;
  for (std::size_t k = 0; k < jaw.blocks.size(); ++k) {
    if (!moved.contains(jaw.blocks[k])) continue;
    VertexBlock& block = now[jaw.blocks[k]];
    const Lanes& weights = jaw.weights[k];
    pitch(block, weights, jaw_turn.pitch, face.jaw->hinge.y, face.jaw->hinge.z);
    for (std::size_t i = 0; i < kLanes; ++i) block.z[i] += forward * weights[i];
  }
}

void FaceDeformer::State::move_eyes() {
  for (const EyeField& eye : eyes) {
    if (eye.turn == Turn{}) continue;
    for (std::size_t k = 0; k < eye.part.blocks.size(); ++k) {
      const std::uint32_t block = eye.part.blocks[k];
      if (!moved.contains(block)) continue;
      pitch(now[block], eye.part.weights[k], eye.turn.pitch, eye.centre.y, eye.centre.z);
      turn(now[block], eye.part.weights[k], eye.turn.yaw, eye.centre.x, eye.centre.z);
    }
  }
}

HeadTurn::Pose FaceDeformer::State::head_pose() const {
  return {difference(head_channels.turn), difference(head_channels.pitch),
          difference(head_channels.tilt), difference(head_channels.shift)};
}

/// Where the eyes look.
void FaceDeformer::State::look() {
  result.eye_centres.resize(eyes.size());
  result.eye_forward.resize(eyes.size());
  result.eye_open.assign(eyes.size(), 1);
  for (std::size_t e = 0; e < lids.size(); ++e) result.eye_open[e] = 1 - value(lids[e].close);
  for (std::size_t e = 0; e < eyes.size(); ++e) {
    const EyeField& eye = eyes[e];
    VertexBlock ahead;
    set_lane(ahead, 0, {0, 0, 1});
    Lanes wholly{};
    wholly.fill(1);
    pitch(ahead, wholly, eye.turn.pitch, 0, 0);
    turn(ahead, wholly, eye.turn.yaw, 0, 0);
    result.eye_centres[e] = eye.centre;
    result.eye_forward[e] = {ahead.x[0], ahead.y[0], ahead.z[0]};
    if (head) head->carry(eye.head_share, result.eye_centres[e], result.eye_forward[e]);
    result.eye_forward[e] = glm::normalize(result.eye_forward[e]);
  }
}

FaceDeformer::FaceDeformer(const Face& face) : state_(std::make_unique<State>(face)) {}
FaceDeformer::~FaceDeformer() = default;
FaceDeformer::FaceDeformer(FaceDeformer&&) noexcept = default;
FaceDeformer& FaceDeformer::operator=(FaceDeformer&&) noexcept = default;

const DeformedFace& FaceDeformer::deform(std::span<const float> activations) {
  State& state = *state_;
  state.move(activations);
  state.look();
  state.result.creases = state.drawn.depths();
  return state.result;
}

}  // namespace aucast::face

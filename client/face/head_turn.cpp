#include "client/face/head_turn.h"

#include <algorithm>
#include <numbers>

#include <glm/mat3x3.hpp>

#include "client/face/block_turns.h"

namespace aucast::face {
namespace {

constexpr float kRadPerDeg = std::numbers::pi_v<float> / 180.0F;
constexpr Lanes kAllLanes{1, 1, 1, 1, 1, 1, 1, 1};

glm::vec3 lane(const VertexBlock& block, std::size_t i) {
  return {block.x[i], block.y[i], block.z[i]};
}

Four four(const glm::vec3& v) {
  return Four{v.x, v.y, v.z, 0};
}

/// A block of points or directions, in registers.
void turn_rigidly(const glm::mat3& rotation, const glm::vec3& offset,
                  std::span<const glm::vec3> from, std::span<glm::vec3> to) {
  const Four x = four(rotation[0]);
  const Four y = four(rotation[1]);
  const Four z = four(rotation[2]);
  const Four all = four(offset);
  std::array<Four, kLanes> points;
  for (std::size_t i = 0; i < from.size(); ++i) {
    points[i] = all + x * from[i].x + y * from[i].y + z * from[i].z;
  }
  write_points(points, to);
}

}  // namespace

HeadTurn::HeadTurn(const Face& face, const NormalField& normals)
    : head_(*face.head), normals_(normals) {
  weights_.resize(block_count(face.mesh.positions.size()));
  const auto map = face.mesh.maps.find("head");
  if (map != face.mesh.maps.end()) {
    for (std::size_t i = 0; i < map->second.size(); ++i) {
      weights_[i / kLanes][i % kLanes] = map->second[i];
    }
  }
  for (const Lanes& weights : weights_) {
    kinds_.push_back(weights == Lanes{}     ? Kind::Not
                     : weights == kAllLanes ? Kind::Wholly
                                            : Kind::Bent);
  }
  const auto weight = [&](std::uint32_t vertex) {
    return weights_[vertex / kLanes][vertex % kLanes];
  };
  for (const auto& [a, b, c] : face.mesh.triangles) {
    const float one = weight(a);
    if ((one == 0 || one == 1) && weight(b) == one && weight(c) == one) continue;
    for (const std::uint32_t corner : {a, b, c}) kinds_[corner / kLanes] = Kind::Bent;
  }
  for (std::size_t block = 0; block < kinds_.size(); ++block) {
    if (kinds_[block] == Kind::Bent) bent_.push_back(static_cast<std::uint32_t>(block));
  }
  near_bent_ = normals_.read_by(bent_);
}

HeadTurn::Angles HeadTurn::angles_of(const Pose& pose) const {
  return {kRadPerDeg * head_.tilt_deg * pose.tilt, kRadPerDeg * head_.pitch_deg * pose.pitch,
          kRadPerDeg * head_.turn_deg * pose.turn, head_.shift * pose.shift};
}

void HeadTurn::turn(const Angles& angles, const Lanes& weights, VertexBlock& block) const {
  const glm::vec3& pivot = head_.pivot;
  if (angles.tilt != 0) aucast::face::tilt(block, weights, angles.tilt, pivot.x, pivot.y);
  if (angles.pitch != 0) aucast::face::pitch(block, weights, angles.pitch, pivot.y, pivot.z);
  if (angles.turn != 0) aucast::face::turn(block, weights, angles.turn, pivot.x, pivot.z);
  for (std::size_t i = 0; i < kLanes; ++i) block.z[i] += angles.shift * weights[i];
}

void HeadTurn::carry(const Pose& pose, float share, glm::vec3& point, glm::vec3& direction) const {
  VertexBlock block;
  set_lane(block, 0, point);
  set_lane(block, 1, point + direction);
  Lanes weights{};
  weights.fill(share);
  turn(angles_of(pose), weights, block);
  point = lane(block, 0);
  direction = lane(block, 1) - point;
}

void HeadTurn::apply(const Pose& pose, std::span<const std::uint8_t> changed,
                     std::span<const VertexBlock> blocks, const DeformedFace& still,
                     DeformedFace& turned) {
  const bool all = last_ != pose;
  last_ = pose;
  const Angles angles = angles_of(pose);
  // Where the three axes go: the turn of everything that turns wholly.
  VertexBlock axes;
  for (std::size_t i = 0; i < 3; ++i) {
    glm::vec3 axis(0);
    axis[static_cast<glm::length_t>(i)] = 1;
    set_lane(axes, i, head_.pivot + axis);
  }
  set_lane(axes, 3, head_.pivot);
  turn(angles, kAllLanes, axes);
  const glm::vec3 centre = lane(axes, 3);
  const glm::mat3 rotation(lane(axes, 0) - centre, lane(axes, 1) - centre, lane(axes, 2) - centre);
  const glm::vec3 offset = centre - rotation * head_.pivot;

  turned.positions.resize(still.positions.size());
  turned.normals.resize(still.normals.size());
  for (std::size_t block = 0; block < blocks.size(); ++block) {
    if (!all && changed[block] == 0) continue;
    const std::size_t begin = block * kLanes;
    const std::size_t count = std::min(kLanes, still.positions.size() - begin);
    if (kinds_[block] == Kind::Wholly) {
      turn_rigidly(rotation, offset, block_of(still.positions, block),
                   block_of(turned.positions, block));
      turn_rigidly(rotation, glm::vec3(0), block_of(still.normals, block),
                   block_of(turned.normals, block));
    } else if (kinds_[block] == Kind::Bent) {
      VertexBlock at = blocks[block];
      turn(angles, weights_[block], at);
      for (std::size_t i = 0; i < count; ++i) turned.positions[begin + i] = lane(at, i);
    } else {
      std::copy_n(still.positions.begin() + static_cast<std::ptrdiff_t>(begin), count,
                  turned.positions.begin() + static_cast<std::ptrdiff_t>(begin));
      std::copy_n(still.normals.begin() + static_cast<std::ptrdiff_t>(begin), count,
                  turned.normals.begin() + static_cast<std::ptrdiff_t>(begin));
    }
  }
  for (const std::uint32_t block : near_bent_) {
    normals_.place(block, points_of(block_at(turned.positions, block)));
  }
  normals_.compute(bent_, turned.normals);
}

}  // namespace aucast::face

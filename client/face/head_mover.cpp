#include "client/face/head_mover.h"

#include <glm/mat3x3.hpp>

#include "client/face/block_turns.h"

namespace aucast::face {
namespace {

constexpr Lanes kAllLanes{1, 1, 1, 1, 1, 1, 1, 1};

glm::vec3 lane(const VertexBlock& block, std::size_t i) {
  return {block.x[i], block.y[i], block.z[i]};
}

}  // namespace

HeadMover::HeadMover(const Face& face) : head_(*face.head) {
  weights_.resize(block_count(face.mesh.positions.size()));
  carried_ = BlockSet(weights_.size());
  const auto* const map = find_map(face.mesh, "head");
  for (std::size_t i = 0; i < face.mesh.positions.size(); ++i) {
    weights_[i / kLanes][i % kLanes] = map_at(map, i, 0);
  }
  for (const Lanes& weights : weights_) {
    kinds_.push_back(weights == Lanes{}     ? Kind::Not
                     : weights == kAllLanes ? Kind::Wholly
                                            : Kind::Bent);
    if (kinds_.back() != Kind::Not) carried_.insert(kinds_.size() - 1);
  }
}

void HeadMover::take(const Pose& pose, BlockSet& moved) {
  if (pose == pose_) return;
  pose_ = pose;
  angles_ = {kRadPerDeg * head_.tilt_deg * pose.tilt, kRadPerDeg * head_.pitch_deg * pose.pitch,
             kRadPerDeg * head_.turn_deg * pose.turn, head_.shift * pose.shift};
  // Where the three axes go: the turn of everything that turns wholly.
  VertexBlock axes;
  for (std::size_t i = 0; i < 3; ++i) {
    glm::vec3 axis(0);
    axis[static_cast<glm::length_t>(i)] = 1;
    set_lane(axes, i, head_.pivot + axis);
  }
  set_lane(axes, 3, head_.pivot);
  turn_by_angles(kAllLanes, axes);
  const glm::vec3 centre = lane(axes, 3);
  const glm::mat3 rotation(lane(axes, 0) - centre, lane(axes, 1) - centre, lane(axes, 2) - centre);
  const auto widened = [](const glm::vec3& v) {
    return Motion::Point{in_all_lanes(v.x), in_all_lanes(v.y), in_all_lanes(v.z)};
  };
  for (std::size_t i = 0; i < 3; ++i) {
    motion_.axes[i] = widened(rotation[static_cast<glm::length_t>(i)]);
  }
  motion_.translation = widened(centre - rotation * head_.pivot);
  moved |= carried_;
}

void HeadMover::turn_rigidly(const VertexBlock& from, VertexBlock& to) const {
  const auto& [right, up, front] = motion_.axes;
  for (std::size_t i = 0; i < kLanes; i += 4) {
    const Four x = four_at(from.x, i);
    const Four y = four_at(from.y, i);
    const Four z = four_at(from.z, i);
    set_four(to.x, i, motion_.translation.x + right.x * x + up.x * y + front.x * z);
    set_four(to.y, i, motion_.translation.y + right.y * x + up.y * y + front.y * z);
    set_four(to.z, i, motion_.translation.z + right.z * x + up.z * y + front.z * z);
  }
}

void HeadMover::turn_by_angles(const Lanes& weights, VertexBlock& block) const {
  const glm::vec3& pivot = head_.pivot;
  if (angles_.tilt != 0) tilt(block, weights, angles_.tilt, pivot.x, pivot.y);
  if (angles_.pitch != 0) pitch(block, weights, angles_.pitch, pivot.y, pivot.z);
  if (angles_.turn != 0) turn(block, weights, angles_.turn, pivot.x, pivot.z);
  for (std::size_t i = 0; i < kLanes; ++i) block.z[i] += angles_.shift * weights[i];
}

void HeadMover::apply(std::size_t block, const VertexBlock& from, VertexBlock& to) const {
  if (kinds_[block] == Kind::Wholly) {
    turn_rigidly(from, to);
    return;
  }
  copy_block(from, to);
  if (kinds_[block] == Kind::Bent) turn_by_angles(weights_[block], to);
}

void HeadMover::carry(float share, glm::vec3& point, glm::vec3& direction) const {
  VertexBlock block;
  set_lane(block, 0, point);
  set_lane(block, 1, point + direction);
  Lanes weights{};
  weights.fill(share);
  turn_by_angles(weights, block);
  point = lane(block, 0);
  direction = lane(block, 1) - point;
}

}  // namespace aucast::face

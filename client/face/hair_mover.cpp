#include "client/face/hair_mover.h"

#include <algorithm>
#include <cmath>

#include "client/face/block_turns.h"

namespace aucast::face {
namespace {

/// Ends hang far below the hinge: an angle of nod or tilt takes them twice as far as one of a turn.
constexpr float kNodShare = 0.5F;
/// Towards the head there is skin, and only as much room as hair lies above it.
constexpr float kInwardShare = 0.25F;
/// From so far on beside the hinge or behind it, in mesh units, hair counts as wholly outside. Half
/// the breadth of a neck.
constexpr float kOutside = 3;

bool is_hair(const MeshPart& part) {
  return part.material == Material::Hair || part.material == Material::GreyHair;
}

/// The factor for hair that lies `outside` on the side to which it swings.
float room(float outside) {
  const float inwards = std::clamp(-outside / kOutside, 0.0F, 1.0F);
  return 1 - (1 - kInwardShare) * inwards;
}

float share(float value) {
  return std::isfinite(value) ? std::clamp(value, -1.0F, 1.0F) : 0.0F;
}

}  // namespace

HairMover::HairMover(const Face& face)
    : hair_(*face.hair), all_(block_count(face.mesh.positions.size())) {
  const std::vector<glm::vec3>& positions = face.mesh.positions;
  float lowest = hair_.hinge.y;
  const auto for_hair = [&](const auto& visit) {
    for (const MeshPart& part : face.mesh.parts) {
      if (!is_hair(part)) continue;
      for (std::size_t i = 0; i < part.vertex_count; ++i) visit(part.vertex_begin + i);
    }
  };
  for_hair([&](std::size_t i) { lowest = std::min(lowest, positions[i].y); });
  for_hair([&](std::size_t i) {
    const glm::vec3 from_hinge = positions[i] - hair_.hinge;
    if (from_hinge.y >= 0) return;
    if (swings_.empty() || swings_.back().block != i / kLanes) swings_.push_back({i / kLanes});
    Swing& swing = swings_.back();
    all_.insert(swing.block);
    const std::size_t lane = i % kLanes;
    const float depth = from_hinge.y / (lowest - hair_.hinge.y);
    const float weight = depth * depth;  // no bend at the hinge
    swing.turn[lane] = weight;
    swing.forward[lane] = weight * room(from_hinge.z);
    swing.back[lane] = weight * room(-from_hinge.z);
    swing.left[lane] = weight * room(from_hinge.x);
    swing.right[lane] = weight * room(-from_hinge.x);
  });
}

void HairMover::take(const HairSway& sway, BlockSet& moved) {
  const HairSway wanted{share(sway.turn), share(sway.pitch), share(sway.tilt)};
  if (wanted == sway_) return;
  sway_ = wanted;
  moved |= all_;
}

void HairMover::apply(const BlockSet& moved, std::vector<VertexBlock>& blocks) const {
  if (sway_ == HairSway{}) return;
  const glm::vec3& hinge = hair_.hinge;
  const float most = kRadPerDeg * hair_.swing_deg;
  for (const Swing& swing : swings_) {
    if (!moved.contains(swing.block)) continue;
    VertexBlock& block = blocks[swing.block];
    if (sway_.tilt != 0) {
      // What is below the axis goes the other way than what is above it.
      tilt(block, sway_.tilt > 0 ? swing.right : swing.left, kNodShare * most * sway_.tilt, hinge.x,
           hinge.y);
    }
    if (sway_.pitch != 0) {
      pitch(block, sway_.pitch > 0 ? swing.forward : swing.back, kNodShare * most * sway_.pitch,
            hinge.y, hinge.z);
    }
    if (sway_.turn != 0) turn(block, swing.turn, most * sway_.turn, hinge.x, hinge.z);
  }
}

}  // namespace aucast::face

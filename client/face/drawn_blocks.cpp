#include "client/face/drawn_blocks.h"

#include "client/face/vertex_block.h"

namespace aucast::face {

std::vector<bool> crease_vertices(const FaceMesh& mesh) {
  std::vector<bool> crease(mesh.positions.size(), false);
  for (const MeshPart& part : mesh.parts) {
    if (!is_crease(part)) continue;
    for (std::size_t i = 0; i < part.vertex_count; ++i) crease[part.vertex_begin + i] = true;
  }
  return crease;
}

BlockSet always_drawn(const FaceMesh& mesh) {
  const std::vector<bool> crease = crease_vertices(mesh);
  BlockSet blocks(block_count(crease.size()));
  for (std::size_t i = 0; i < crease.size(); ++i) {
    if (!crease[i]) blocks.insert(i / kLanes);
  }
  return blocks;
}

std::vector<float> kept_depths(const Face& face) {
  std::vector<float> depths;
  for (const MeshPart& part : face.mesh.parts) {
    if (!is_crease(part)) continue;
    const auto channel = face.channel_index(part.name);
    depths.push_back(channel ? face.channels[*channel].kept : 0.0F);
  }
  return depths;
}

DrawnBlocks::DrawnBlocks(const Face& face)
    : depths_(kept_depths(face)),
      always_(always_drawn(face.mesh)),
      drawn_(always_),
      appeared_(block_count(face.mesh.positions.size())),
      vanished_(appeared_) {
  for (const MeshPart& part : face.mesh.parts) {
    if (!is_crease(part)) continue;
    Crease& crease = creases_.emplace_back();
    crease.channel = face.channel_index(part.name);
    crease.kept = depths_[creases_.size() - 1];
    crease.blocks = BlockSet(block_count(face.mesh.positions.size()));
    for (std::size_t i = 0; i < part.vertex_count; ++i) {
      crease.blocks.insert((part.vertex_begin + i) / kLanes);
    }
  }
  drawn_ = with_creases();
}

BlockSet DrawnBlocks::with_creases() const {
  BlockSet drawn = always_;
  for (std::size_t i = 0; i < creases_.size(); ++i) {
    if (depths_[i] > 0) drawn |= creases_[i].blocks;
  }
  return drawn;
}

void DrawnBlocks::take(std::span<const float> activations) {
  bool others = false;
  for (std::size_t i = 0; i < creases_.size(); ++i) {
    const Crease& crease = creases_[i];
    const float driven = crease.channel ? activations[*crease.channel] : 0.0F;
    const float depth = crease.kept + (1 - crease.kept) * driven;
    others = others || (depth > 0) != (depths_[i] > 0);
    depths_[i] = depth;
  }
  appeared_.clear();
  vanished_.clear();
  if (!others) return;
  vanished_ = drawn_;
  drawn_ = with_creases();
  appeared_ = drawn_;
  appeared_ -= vanished_;
  vanished_ -= drawn_;
}

void DrawnBlocks::narrow(BlockSet& moved) const {
  moved &= drawn_;
  moved |= appeared_;
}

}  // namespace aucast::face

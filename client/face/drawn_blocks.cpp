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

DrawnBlocks::DrawnBlocks(const Face& face)
    : always_(always_drawn(face.mesh)),
      drawn_(always_),
      appeared_(block_count(face.mesh.positions.size())),
      vanished_(appeared_) {
  for (const MeshPart& part : face.mesh.parts) {
    if (!is_crease(part)) continue;
    Crease& crease = creases_.emplace_back();
    crease.channel = face.channel_index(part.name);
    crease.blocks = BlockSet(block_count(face.mesh.positions.size()));
    for (std::size_t i = 0; i < part.vertex_count; ++i) {
      crease.blocks.insert((part.vertex_begin + i) / kLanes);
    }
  }
  depths_.resize(creases_.size());
}

void DrawnBlocks::take(std::span<const float> activations) {
  bool others = false;
  for (std::size_t i = 0; i < creases_.size(); ++i) {
    const float depth = creases_[i].channel ? activations[*creases_[i].channel] : 0.0F;
    others = others || (depth > 0) != (depths_[i] > 0);
    depths_[i] = depth;
  }
  appeared_.clear();
  vanished_.clear();
  if (!others) return;
  vanished_ = drawn_;
  drawn_ = always_;
  for (std::size_t i = 0; i < creases_.size(); ++i) {
    if (depths_[i] > 0) drawn_ |= creases_[i].blocks;
  }
  appeared_ = drawn_;
  appeared_ -= vanished_;
  vanished_ -= drawn_;
}

void DrawnBlocks::narrow(BlockSet& moved) const {
  moved &= drawn_;
  moved |= appeared_;
}

}  // namespace aucast::face

#include "client/face/muscle_sums.h"

#include <algorithm>
#include <limits>

namespace aucast::face {

MuscleSums::MuscleSums(const Face& face)
    : rest_(blocks_of(face.mesh.positions)), activations_(face.muscles.size()) {
  const FaceMesh& mesh = face.mesh;
  std::vector<std::vector<VertexBlock>> pulls(rest_.size());
  std::vector<std::vector<std::uint32_t>> numbers(rest_.size());
  for (const Muscle& muscle : face.muscles) {
    const auto* const reach = muscle.mask_alone ? nullptr : find_map(mesh, "muscle");
    const auto* const mask = muscle.mask.empty() ? nullptr : find_map(mesh, muscle.mask);
    Reach& reaches = reaches_.emplace_back();
    reaches.blocks = BlockSet(rest_.size());
    reaches.activation_cap = std::numeric_limits<float>::infinity();
    const auto number = static_cast<std::uint32_t>(reaches_.size() - 1);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      const float factor = map_at(reach, i, 1) * map_at(mask, i, 1);
      if (factor == 0) continue;
      const LinearInfluence linear = influence(muscle.shape, mesh.positions[i]);
      if (linear.per_unit == glm::vec3(0)) continue;
      reaches.activation_cap = linear.activation_cap;  // the same at every vertex of a muscle
      const std::size_t block = i / kLanes;
      if (!reaches.blocks.contains(block)) {
        reaches.blocks.insert(block);
        pulls[block].emplace_back();
        numbers[block].push_back(number);
      }
      set_lane(pulls[block].back(), i % kLanes, factor * linear.per_unit);
    }
  }
  for (std::size_t block = 0; block < rest_.size(); ++block) {
    pulls_.insert(pulls_.end(), pulls[block].begin(), pulls[block].end());
    muscles_.insert(muscles_.end(), numbers[block].begin(), numbers[block].end());
    begin_.push_back(static_cast<std::uint32_t>(pulls_.size()));
  }
}

void MuscleSums::take(std::span<const float> activations, BlockSet& moved) {
  for (std::size_t m = 0; m < reaches_.size(); ++m) {
    const float activation = std::min(activations[m], reaches_[m].activation_cap);
    if (activation == activations_[m]) continue;
    activations_[m] = activation;
    moved |= reaches_[m].blocks;
  }
}

void MuscleSums::at(std::size_t block, VertexBlock& place) const {
  // In registers; an array the compiler would load and store for every muscle.
  const VertexBlock& rest = rest_[block];
  Four x0 = four_at(rest.x, 0);
  Four x4 = four_at(rest.x, 4);
  Four y0 = four_at(rest.y, 0);
  Four y4 = four_at(rest.y, 4);
  Four z0 = four_at(rest.z, 0);
  Four z4 = four_at(rest.z, 4);
  for (std::size_t k = begin_[block]; k < begin_[block + 1]; ++k) {
    const VertexBlock& per_unit = pulls_[k];
    const float activation = activations_[muscles_[k]];
    if (activation == 0) continue;
    x0 += activation * four_at(per_unit.x, 0);
    x4 += activation * four_at(per_unit.x, 4);
    y0 += activation * four_at(per_unit.y, 0);
    y4 += activation * four_at(per_unit.y, 4);
    z0 += activation * four_at(per_unit.z, 0);
    z4 += activation * four_at(per_unit.z, 4);
  }
  set_four(place.x, 0, x0);
  set_four(place.x, 4, x4);
  set_four(place.y, 0, y0);
  set_four(place.y, 4, y4);
  set_four(place.z, 0, z0);
  set_four(place.z, 4, z4);
}

}  // namespace aucast::face

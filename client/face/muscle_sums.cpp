#include "client/face/muscle_sums.h"

#include <algorithm>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>

namespace aucast::face {
namespace {

/// How far a pull may be off its muscle's way and still count as along it, as a share of the pull:
/// rounding errors only.
constexpr double kAsideMax = 1e-6;

/// How much of `way` the pull is.
double share_of(const glm::vec3& way, const glm::vec3& pull) {
  return glm::dot(glm::dvec3(way), glm::dvec3(pull)) / glm::dot(glm::dvec3(way), glm::dvec3(way));
}

/// The longest pull if all others go along it; zero if they do not.
glm::vec3 common_way(std::span<const glm::vec3> pulls) {
  glm::vec3 way(0);
  for (const glm::vec3& pull : pulls) {
    if (glm::dot(pull, pull) > glm::dot(way, way)) way = pull;
  }
  const bool all = std::all_of(pulls.begin(), pulls.end(), [&](const glm::vec3& pull) {
    if (pull == glm::vec3(0)) return true;
    const glm::dvec3 aside = glm::dvec3(pull) - share_of(way, pull) * glm::dvec3(way);
    return glm::length(aside) <= kAsideMax * glm::length(glm::dvec3(pull));
  });
  return all ? way : glm::vec3(0);
}

}  // namespace

MuscleSums::MuscleSums(const Face& face) {
  Making making(face);
  while (!making.step()) {
  }
  *this = making.finish();
}

MuscleSums::Making::Making(const Face& face) : face_(face), pulls_(face.mesh.positions.size()) {
  sums_.rest_ = blocks_of(face.mesh.positions);
  sums_.activations_.resize(face.muscles.size());
  sums_.acts_.resize(face.muscles.size());
  sums_.listed_ = BlockSet(sums_.rest_.size());
  sums_.factors_.resize(face.muscles.size());
}

bool MuscleSums::Making::step() {
  const std::size_t next = sums_.reaches_.size();
  if (next < face_.muscles.size()) add(face_.muscles[next]);
  return sums_.reaches_.size() == face_.muscles.size();
}

void MuscleSums::Making::add(const Muscle& muscle) {
  const FaceMesh& mesh = face_.mesh;
  const auto* const reach = muscle.mask_alone ? nullptr : find_map(mesh, "muscle");
  const auto* const mask = muscle.mask.empty() ? nullptr : find_map(mesh, muscle.mask);
  const auto* const root_below = find_map(mesh, "root_below");
  const auto number = static_cast<std::uint32_t>(sums_.reaches_.size());
  Reach& reaches = sums_.reaches_.emplace_back();
  reaches.blocks = BlockSet(sums_.rest_.size());
  reaches.activation_cap = std::numeric_limits<float>::infinity();
  for (std::size_t i = 0; i < pulls_.size(); ++i) {
    pulls_[i] = glm::vec3(0);
    const float factor = map_at(reach, i, 1) * map_at(mask, i, 1);
    if (factor == 0) continue;
    const glm::vec3 root = mesh.positions[i] - glm::vec3(0, map_at(root_below, i, 0), 0);
    const LinearInfluence linear = influence(muscle.shape, root);
    if (linear.per_unit == glm::vec3(0)) continue;
    reaches.activation_cap = linear.activation_cap;  // the same at every vertex of a muscle
    reaches.blocks.insert(i / kLanes);
    pulls_[i] = factor * linear.per_unit;
  }
  const glm::vec3 way = common_way(pulls_);
  const bool has_way = way != glm::vec3(0);
  if (has_way) reaches.way = way;
  reaches.blocks.for_each([&](std::size_t block) {
    const auto place = static_cast<std::uint32_t>(block);
    const std::span<const glm::vec3> here = block_of(std::as_const(pulls_), block);
    if (!has_way) {
      free_.push_back({place, number, block_at(pulls_, block)});
      return;
    }
    Lanes shares{};
    std::transform(here.begin(), here.end(), shares.begin(),
                   [&](const glm::vec3& pull) { return static_cast<float>(share_of(way, pull)); });
    along_.push_back({place, number, shares});
  });
}

MuscleSums MuscleSums::Making::finish() {
  sums_.along_ = {sums_.rest_.size(), std::move(along_)};
  sums_.free_ = {sums_.rest_.size(), std::move(free_)};
  return std::move(sums_);
}

void MuscleSums::take(std::span<const float> activations, BlockSet& moved) {
  for (std::size_t m = 0; m < reaches_.size(); ++m) {
    const Reach& reach = reaches_[m];
    const float activation = std::min(activations[m], reach.activation_cap);
    if (activation == activations_[m]) continue;
    const std::uint32_t acts = activation != 0 ? 1 : 0;
    others_act_ = others_act_ || acts != acts_[m];
    acts_[m] = acts;
    activations_[m] = activation;
    const glm::vec3 factors = activation * reach.way;
    factors_[m] = {in_all_lanes(factors.x), in_all_lanes(factors.y), in_all_lanes(factors.z)};
    moved |= reach.blocks;
  }
}

void MuscleSums::list(const BlockSet& blocks) {
  if (!others_act_ && listed_.contains_all(blocks)) return;
  others_act_ = false;
  listed_ = blocks;
  along_.list_acting(acts_, sizeof(Factors), blocks);
  free_.list_acting(acts_, sizeof(Factors), blocks);
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
  for (const auto& acting : along_.acting(block)) {
    const Lanes& shares = along_.fetch(acting);
    const Factors& way = at_distance(factors_.data(), acting.muscle);
    const Four share0 = four_at(shares, 0);
    const Four share4 = four_at(shares, 4);
    x0 += way.x * share0;
    x4 += way.x * share4;
    y0 += way.y * share0;
    y4 += way.y * share4;
    z0 += way.z * share0;
    z4 += way.z * share4;
  }
  for (const auto& acting : free_.acting(block)) {
    const VertexBlock& per_unit = free_.fetch(acting);
    const Four& activation = at_distance(factors_.data(), acting.muscle).x;
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

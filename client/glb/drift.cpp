#include "client/glb/drift.h"

#include <algorithm>
#include <random>

#include <glm/geometric.hpp>

#include "client/glb/units.h"

namespace aucast::glb {

Drift::Drift(const face::Face& face, const MorphTargets& targets, const FaceRig& rig)
    : face_(face), targets_(targets), rig_(rig), deformer_(face) {
  for (std::size_t i = 0; i < face.mesh.positions.size(); ++i) carried_.push_back(rig.carried(i));
}

std::vector<glm::vec3> Drift::moved(const pipeline::FaceState& state) const {
  std::vector<glm::vec3> positions = face_.mesh.positions;
  const std::vector<std::uint8_t> weights = targets_.weights(face_, state);
  for (std::size_t k = 0; k < weights.size(); ++k) {
    if (weights[k] == 0) continue;
    const float weight = static_cast<float>(weights[k]) / 255;
    for (const Change& change : targets_.all()[k].positions) {
      positions[change.vertex] += weight * glm::vec3(change.by);
    }
  }
  const std::vector<glm::mat4> carriers = rig_.carriers(rig_.pose(state.activations));
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const glm::vec4 rest(positions[i], 1);
    glm::vec4 position(0);
    for (std::size_t k = 0; k < 4 && carried_[i].weights[k] > 0; ++k) {
      position += carried_[i].weights[k] * (carriers[carried_[i].joints[k]] * rest);
    }
    positions[i] = glm::vec3(position);
  }
  return positions;
}

void Drift::add(const pipeline::FaceState& state) {
  const face::DeformedFace& real = deformer_.deform(state.activations);
  const std::vector<glm::vec3> positions = moved(state);
  float worst = 0;
  std::size_t crease = 0;
  for (const face::MeshPart& part : face_.mesh.parts) {
    if (face::is_crease(part) && real.creases[crease++] == 0) continue;
    for (std::uint32_t i = part.vertex_begin; i < part.vertex_begin + part.vertex_count; ++i) {
      worst = std::max(worst, glm::distance(positions[i], real.positions[i]));
    }
  }
  worst_.push_back(worst);
}

Drift::Summary Drift::summary() const {
  if (worst_.empty()) return {};
  std::vector<float> sorted = worst_;
  std::sort(sorted.begin(), sorted.end());
  const auto mm = [](float units) { return static_cast<double>(units * kMetresPerUnit * 1000); };
  return {sorted.size(), mm(sorted[sorted.size() / 2]), mm(sorted[sorted.size() * 9 / 10]),
          mm(sorted.back())};
}

void add_random_faces(const pipeline::AuMapping& mapping, std::size_t count, std::uint64_t seed,
                      Drift& drift) {
  std::vector<std::uint8_t> numbers;
  for (const auto& [number, recording] : mapping.recordings) {
    if (number != 0) numbers.push_back(static_cast<std::uint8_t>(number));
  }
  if (numbers.empty()) return;
  // Not the library's distributions, which differ from one library to the next.
  std::mt19937_64 random(seed);
  const auto below = [&random](std::uint64_t n) { return random() % n; };
  pipeline::FaceState state{{}, std::vector<float>(mapping.face.channels.size())};
  for (std::size_t n = 0; n < count; ++n) {
    AuFrame aus;
    for (std::uint64_t k = 2 + below(5); k > 0; --k) {
      const std::uint8_t number = numbers[below(numbers.size())];
      const float intensity = static_cast<float>(20 + below(81)) / 100;
      const std::uint64_t side = below(8);  // mostly both
      set_intensity(aus, number,
                    side == 0   ? Side::Left
                    : side == 1 ? Side::Right
                                : Side::Both,
                    intensity);
    }
    state.aus = mapping.apply(aus, state.activations);
    drift.add(state);
  }
}

}  // namespace aucast::glb

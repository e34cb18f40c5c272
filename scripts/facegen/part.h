#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "client/face/ply.h"
#include "scripts/facegen/maths.h"

namespace aucast::facegen {

/// The maps: numbers of each vertex, most of them weights by which something moves it. Their names
/// in the file are in kMapNames.
enum class Map : std::uint8_t {
  Muscle,      ///< factor on all muscles
  Jaw,         ///< share of the jaw's turn
  Head,        ///< share of the head's turn
  LidAngle,    ///< radians downwards at full closure
  Smile,       ///< mask of the zygomatics: 0 on the nose, small near the cheekbone
  Forehead,    ///< mask of frontalis and corrugator: 0 below the brows
  UpperLip,    ///< mask: what moves with the upper lip
  LowerLip,    ///< mask: what moves with the lower lip
  UpperRed,    ///< mask: the red of the upper lip
  LowerRed,    ///< mask: the red of the lower lip
  LowerLid,    ///< mask: the lower lid, for its own muscle; makes up for the small Muscle there
  Nasolabial,  ///< mask: the furrow from the wing of the nose to beside the mouth
  Glabella,    ///< mask: the two upright lines between the brows
  Tongue,      ///< mask: the free part of the tongue
  Strand,      ///< position across the hair; it is the same all along a strand
  RootBelow,   ///< of brows: how far the spine lies below, in mesh units; muscles move the vertex
               ///< as they move the place there
};
inline constexpr std::array<std::string_view, 16> kMapNames{
    "muscle",    "jaw",       "head",      "lid_angle", "smile",     "forehead",
    "upper_lip", "lower_lip", "upper_red", "lower_red", "lower_lid", "nasolabial",
    "glabella",  "tongue",    "strand",    "root_below"};

using Maps = std::array<double, kMapNames.size()>;

struct Vertex {
  Vec3 position{0};
  Vec3 colour{1};  ///< linear RGB
  double alpha = 1;
  double occlusion = 1;
  double gloss = 1;
  Maps maps{};

  [[nodiscard]] double& operator[](Map map) { return maps[static_cast<std::size_t>(map)]; }
  [[nodiscard]] double operator[](Map map) const { return maps[static_cast<std::size_t>(map)]; }
};

/// A named piece of the head with its own material.
struct Part {
  std::string name;
  face::Material material = face::Material::Skin;
  std::vector<Vertex> vertices;
  std::vector<face::Polygon> polygons;

  std::uint32_t add(const Vec3& position, const Vec3& colour = Vec3{1}, double alpha = 1);
  void add_quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d);
  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);
  /// Adds the quads lower[i], lower[i+1], upper[i+1], upper[i] between two rows of the same length.
  /// Seen from outside, `upper` must lie to the left as one goes along `lower`.
  void add_band(const std::vector<std::uint32_t>& lower, const std::vector<std::uint32_t>& upper,
                bool closed);
  /// Sets a map of every vertex.
  void fill(Map map, double value);
};

/// Unit normals of a part's vertices, weighted by area.
[[nodiscard]] std::vector<Vec3> normals_of(const Part& part);

/// For each vertex of a part, the mean of a member, such as &Vertex::occlusion, at the vertices
/// that it shares an edge with, each counted once for each polygon of that edge; its own if there
/// are none.
template <typename Value>
[[nodiscard]] std::vector<Value> means_of_neighbours(const Part& part, Value Vertex::*member) {
  std::vector<Value> means(part.vertices.size(), Value{0});
  std::vector<double> count(part.vertices.size(), 0.0);
  for (const face::Polygon& polygon : part.polygons) {
    for (std::size_t k = 0; k < polygon.corner_count; ++k) {
      const std::uint32_t a = polygon.corners[k];
      const std::uint32_t b = polygon.corners[(k + 1) % polygon.corner_count];
      means[a] += part.vertices[b].*member;
      means[b] += part.vertices[a].*member;
      count[a] += 1;
      count[b] += 1;
    }
  }
  for (std::size_t i = 0; i < means.size(); ++i) {
    means[i] = count[i] > 0 ? means[i] / count[i] : part.vertices[i].*member;
  }
  return means;
}

}  // namespace aucast::facegen

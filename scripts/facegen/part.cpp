#include "scripts/facegen/part.h"

namespace aucast::facegen {

std::uint32_t Part::add(const Vec3& position, const Vec3& colour, double alpha) {
  Vertex vertex;
  vertex.position = position;
  vertex.colour = colour;
  vertex.alpha = alpha;
  vertices.push_back(vertex);
  return static_cast<std::uint32_t>(vertices.size() - 1);
}

void Part::add_quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  polygons.push_back({{a, b, c, d}, 4});
}

void Part::add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  polygons.push_back({{a, b, c, c}, 3});
}

void Part::add_band(const std::vector<std::uint32_t>& lower,
                    const std::vector<std::uint32_t>& upper, bool closed) {
  const std::size_t n = lower.size();
  for (std::size_t i = 0; i < (closed ? n : n - 1); ++i) {
    const std::size_t next = (i + 1) % n;
    add_quad(lower[i], lower[next], upper[next], upper[i]);
  }
}

void Part::fill(Map map, double value) {
  for (Vertex& vertex : vertices) vertex[map] = value;
}

std::vector<Vec3> normals_of(const Part& part) {
  std::vector<Vec3> normals(part.vertices.size(), Vec3{0});
  for (const face::Polygon& polygon : part.polygons) {
    const auto at = [&](std::size_t k) { return part.vertices[polygon.corners[k]].position; };
    // The diagonals of a quad span twice its area; for a triangle the last corner is repeated.
    const Vec3 normal = glm::cross(at(2) - at(0), at(3) - at(1));
    for (std::size_t k = 0; k < polygon.corner_count; ++k) normals[polygon.corners[k]] += normal;
  }
  for (Vec3& normal : normals) {
    const double length = glm::length(normal);
    normal = length > 1e-12 ? normal / length : Vec3{0, 0, 1};
  }
  return normals;
}

}  // namespace aucast::facegen

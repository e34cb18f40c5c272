#include "client/app/video/obj_writer.h"

#include <array>
#include <cstdio>

#include "common/check.h"

namespace aucast::app {

std::string format_obj(const face::FaceMesh& mesh, std::span<const glm::vec3> positions) {
  AUCAST_CHECK(!mesh.parts.empty() && positions.size() == mesh.positions.size());
  const face::MeshPart& skin = mesh.parts.front();
  std::string text = "# face-player: skin, 1 unit = 1.4 cm, y up, z towards the viewer\no skin\n";
  std::array<char, 160> line{};
  const auto add = [&](int length) { text.append(line.data(), static_cast<std::size_t>(length)); };
  for (const glm::vec3& p : positions.subspan(skin.vertex_begin, skin.vertex_count)) {
    add(std::snprintf(line.data(), line.size(), "v %.9f %.9f %.9f\n", static_cast<double>(p.x),
                      static_cast<double>(p.y), static_cast<double>(p.z)));
  }
  for (std::uint32_t i = 0; i < skin.triangle_count; ++i) {
    const auto& triangle = mesh.triangles[skin.triangle_begin + i];
    const std::uint32_t base = skin.vertex_begin;  // OBJ counts from 1
    add(std::snprintf(line.data(), line.size(), "f %u %u %u\n", triangle[0] - base + 1,
                      triangle[1] - base + 1, triangle[2] - base + 1));
  }
  return text;
}

}  // namespace aucast::app

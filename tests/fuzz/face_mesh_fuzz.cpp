// Any bytes as a mesh.ply: an error with the file's name, or a mesh that a deformer can take and
// that is the same after being written and read again.

#include "client/face/face_deformer.h"
#include "client/face/ply.h"
#include "common/check.h"
#include "tests/fuzz/fuzz_input.h"

using namespace aucast;
using namespace aucast::face;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  auto mesh = parse_ply(fuzz::text_of(data, size), "f");
  if (!mesh) {
    AUCAST_CHECK(mesh.error().kind == ErrorKind::BadData);
    AUCAST_CHECK(mesh.error().message.starts_with("f:"));
    return 0;
  }
  const std::size_t count = mesh->positions.size();
  AUCAST_CHECK(mesh->colours.size() == count && mesh->occlusion.size() == count);
  for (const auto& [name, weights] : mesh->maps) AUCAST_CHECK(weights.size() == count);
  std::vector<Polygon> polygons;
  for (const auto& [a, b, c] : mesh->triangles) {
    AUCAST_CHECK(a < count && b < count && c < count);
    polygons.push_back({{a, b, c, 0}, 3});
  }
  const auto again = parse_ply(format_ply(*mesh, polygons), "f");
  AUCAST_CHECK(again.has_value());
  AUCAST_CHECK(again->positions == mesh->positions && again->triangles == mesh->triangles);
  Face face;
  face.mesh = std::move(*mesh);
  FaceDeformer deformer(face);
  AUCAST_CHECK(deformer.deform({}).positions == face.mesh.positions);
  return 0;
}

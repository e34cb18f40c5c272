// Any texts as the files of a face folder of ours or of Waters' classic one: an error with a file's
// name, or a face that moves and stays finite. The first byte says which, lines of "====" lie
// between the files.

#include <cmath>
#include <filesystem>
#include <string>

#include "client/face/face_deformer.h"
#include "client/face/ply.h"
#include "common/check.h"
#include "common/files.h"
#include "tests/fuzz/fuzz_folder.h"
#include "tests/fuzz/fuzz_input.h"

using namespace aucast;
using namespace aucast::face;

namespace {

namespace fs = std::filesystem;

std::string_view next_file(std::string_view& rest) {
  constexpr std::string_view kBetween = "====\n";
  const std::size_t end = rest.find(kBetween);
  const std::string_view text = rest.substr(0, end);
  rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + kBetween.size());
  return text;
}

/// A patch of skin and two eyes, with the maps that movers and masks need.
std::string small_mesh() {
  FaceMesh mesh;
  for (int i = 0; i < 15; ++i) {
    mesh.positions.emplace_back(static_cast<float>(i % 5) - 2, static_cast<float>(i) / 5 - 1, 8);
  }
  const auto part = [](const char* name, Material material, std::uint32_t begin) {
    return MeshPart{name, material, begin * 3, begin == 0 ? 9U : 3U, begin, begin == 0 ? 3U : 1U};
  };
  mesh.parts = {part("skin", Material::Skin, 0), part("left_eye", Material::Eye, 3),
                part("right_eye", Material::Eye, 4)};
  std::vector<Polygon> polygons;
  for (std::uint32_t i = 0; i < 5; ++i) polygons.push_back({{3 * i, 3 * i + 1, 3 * i + 2, 0}, 3});
  mesh.colours.assign(15, glm::vec4(1));
  for (const char* map : {"jaw", "head", "lid_angle", "muscle", "smile"}) {
    mesh.maps[map].assign(15, 0.5F);
  }
  return format_ply(mesh, polygons);
}

void check_error(const Error& error, const fs::path& folder) {
  // face.toml may name files elsewhere, from the root on.
  AUCAST_CHECK(error.message.find(folder.string()) != std::string::npos ||
               error.message.find('/') != std::string::npos);
}

void check_face(const fuzz::Folder& folder, const fs::path& data) {
  const auto face = load_face(folder.path(), data);
  if (!face) return check_error(face.error(), folder.path());
  for (const auto& [number, recording] : face->recordings) {
    AUCAST_CHECK(recording.activation.size() == face->channels.size());
    for (const float activation : recording.activation) {
      AUCAST_CHECK(std::isfinite(activation) && activation >= 0);
    }
  }
  FaceDeformer deformer(*face);
  for (const float activation : {1.0F, 0.0F}) {
    const auto& shown = deformer.deform(std::vector<float>(face->channels.size(), activation));
    for (const glm::vec3& point : shown.positions) {
      AUCAST_CHECK(std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z));
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::Folder kOurs("_ours");
  static const fuzz::Folder kClassic("_classic");
  static const fs::path kData = AUCAST_FUZZ_DATA;
  std::string_view rest = fuzz::text_of(data, size);
  const char kind = rest.empty() ? 'o' : rest.front();
  rest.remove_prefix(rest.empty() ? 0 : 1);
  if (kind == 'c') {
    for (const char* name : {"faceline.dat", "index.dat", "muscle.dat", "jaw.dat"}) {
      kClassic.write(name, next_file(rest));
    }
    check_face(kClassic, kData);
    return 0;
  }
  static const std::string kMesh = small_mesh();
  kOurs.write("mesh.ply", kMesh);
  for (const char* name : {"face.toml", "muscles.toml", "aus.toml"}) {
    kOurs.write(name, next_file(rest));
  }
  check_face(kOurs, kData);
  return 0;
}

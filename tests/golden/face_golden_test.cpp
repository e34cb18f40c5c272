// Where named vertices of a small face go, number by number: a change of the deformer that no
// property notices shows here. AUCAST_UPDATE_GOLDEN=1 writes the numbers anew
// (scripts/update_golden.sh).

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "client/face/face_deformer.h"
#include "client/face/muscle_mixer.h"
#include "common/files.h"
#include "tests/unit/face/small_face.h"

namespace aucast::face {
namespace {

constexpr float kTolerance = 1e-5F;
constexpr std::size_t kVertexStep = 61;
const std::filesystem::path kBaseline =
    std::filesystem::path(AUCAST_GOLDEN_SOURCE) / "baselines" / "face_small.txt";

/// One vertex in one pose.
struct Line {
  std::string pose;
  std::size_t vertex = 0;
  glm::vec3 position{0};
};

/// The poses: every channel alone at 1, and every recorded AU under both mixers.
std::vector<std::pair<std::string, std::vector<float>>> poses(const Face& face) {
  std::vector<std::pair<std::string, std::vector<float>>> result;
  for (const Channel& channel : face.channels) {
    result.emplace_back(channel.name, test::only(face, channel.name, 1));
  }
  AuFrame all;
  for (const auto& [number, recording] : face.recordings) {
    AuFrame frame;
    const auto index = static_cast<std::size_t>(number);
    frame.left[index] = all.left[index] = 0.8F;
    frame.right[index] = all.right[index] = 0.5F;
    std::vector<float> activations(face.channels.size());
    mix(face, frame, Mixer::Maximum, activations);
    result.emplace_back("au" + std::to_string(number), activations);
  }
  for (const Mixer mixer : {Mixer::Maximum, Mixer::Average}) {
    std::vector<float> activations(face.channels.size());
    mix(face, all, mixer, activations);
    result.emplace_back(mixer == Mixer::Maximum ? "all_maximum" : "all_average", activations);
  }
  return result;
}

std::vector<Line> present_lines() {
  const Face face = test::small_face();
  FaceDeformer deformer(face);
  std::vector<Line> lines;
  for (const auto& [pose, activations] : poses(face)) {
    const std::vector<glm::vec3>& positions = deformer.deform(activations).positions;
    std::size_t moved = 0;
    for (std::size_t i = 0; i < positions.size(); ++i) {
      if (positions[i] == face.mesh.positions[i]) continue;
      if (moved++ % kVertexStep == 0) lines.push_back({pose, i, positions[i]});
    }
  }
  return lines;
}

std::string text_of(const std::vector<Line>& lines) {
  std::string text;
  for (const Line& line : lines) {
    char buffer[160];
    std::snprintf(buffer, sizeof buffer, "%s %zu %.7f %.7f %.7f\n", line.pose.c_str(), line.vertex,
                  static_cast<double>(line.position.x), static_cast<double>(line.position.y),
                  static_cast<double>(line.position.z));
    text += buffer;
  }
  return text;
}

std::vector<Line> parsed(const std::string& text) {
  std::vector<Line> lines;
  std::istringstream in(text);
  Line line;
  while (in >> line.pose >> line.vertex >> line.position.x >> line.position.y >> line.position.z) {
    lines.push_back(line);
  }
  return lines;
}

TEST(FaceGolden, VerticesGoWhereTheyWent) {
  const std::vector<Line> now = present_lines();
  if (std::getenv("AUCAST_UPDATE_GOLDEN") != nullptr) {
    const auto written = write_file_atomically(kBaseline, text_of(now));
    ASSERT_TRUE(written.has_value()) << written.error().message;
  }
  const auto text = read_file(kBaseline);
  ASSERT_TRUE(text.has_value()) << text.error().message << "; run scripts/update_golden.sh";
  const std::vector<Line> before = parsed(*text);
  ASSERT_EQ(now.size(), before.size()) << "run scripts/update_golden.sh if this is meant";
  for (std::size_t i = 0; i < now.size(); ++i) {
    ASSERT_EQ(now[i].pose, before[i].pose);
    ASSERT_EQ(now[i].vertex, before[i].vertex) << now[i].pose;
    EXPECT_LT(glm::distance(now[i].position, before[i].position), kTolerance)
        << now[i].pose << ", vertex " << now[i].vertex;
  }
}

}  // namespace
}  // namespace aucast::face

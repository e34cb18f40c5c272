#include "tests/golden/render_scene.h"

#include <cmath>
#include <numbers>
#include <utility>

#include <glm/geometric.hpp>

#include "client/face/muscle_mixer.h"

namespace aucast::test {
namespace {

constexpr int kRows = 24;
constexpr int kColumns = 48;

}  // namespace

SphereHead::SphereHead() {
  using face::Material;
  const glm::vec4 skin(0.74F, 0.505F, 0.385F, 1);
  add({Material::Skin, {0, 1.5F, 2}, {5, 7, 6}, skin, 0, kRows, false, -1});
  add({Material::Skin, {0, 0.6F, 8}, {0.8F, 1.4F, 1.2F}, skin, 0, kRows, false, -1});
  add({Material::Skin, {0, -7, 1}, {2.6F, 5, 2.6F}, skin, 0, kRows, false, -1});
  const glm::vec4 iris(0.25F, 0.33F, 0.22F, 1);
  add({Material::Eye, {2.1F, 2.7F, 6.6F}, glm::vec3(1.27F), iris, 0, kRows, false, 0});
  add({Material::Eye, {-2.1F, 2.7F, 6.6F}, glm::vec3(1.27F), iris, 0, kRows, false, 1});
  add({Material::Mouth,
       {0, -2.6F, 6.6F},
       {1.8F, 0.8F, 1},
       {0.42F, 0.13F, 0.12F, 1},
       0,
       kRows,
       false,
       -1});
  add({Material::Teeth,
       {0, -2.4F, 6.9F},
       {1.2F, 0.35F, 1},
       {0.9F, 0.87F, 0.81F, 1},
       0,
       kRows,
       false,
       -1});
  add({Material::Hair,
       {0, 2.6F, 1},
       {5.4F, 6.8F, 6.2F},
       {0.2F, 0.11F, 0.06F, 1},
       0,
       kRows * 2 / 5,
       true,
       -1});
  add({Material::Cloth, {0, -11, 0}, {9, 4, 5}, {0.1F, 0.14F, 0.2F, 1}, 0, kRows / 2, false, -1});
  const glm::vec4 brow(0.125F, 0.075F, 0.048F, 0.7F);
  add({Material::Brow, {2.1F, 4.4F, 7.2F}, {1.3F, 0.25F, 0.5F}, brow, 0, kRows, false, -1});
  add({Material::Brow, {-2.1F, 4.4F, 7.2F}, {1.3F, 0.25F, 0.5F}, brow, 0, kRows, false, -1});
}

void SphereHead::add(const Ball& ball) {
  constexpr float kPi = std::numbers::pi_v<float>;
  const auto base = static_cast<std::uint32_t>(positions_.size());
  const auto first_triangle = static_cast<std::uint32_t>(triangles_.size());
  for (int row = ball.row_begin; row <= ball.row_end; ++row) {
    const float down = kPi * static_cast<float>(row) / kRows;
    for (int column = 0; column <= kColumns; ++column) {
      const float round = 2 * kPi * static_cast<float>(column) / kColumns;
      const glm::vec3 unit(std::sin(down) * std::sin(round), std::cos(down),
                           std::sin(down) * std::cos(round));
      positions_.push_back(ball.centre + ball.radii * unit);
      normals_.push_back(glm::normalize(unit / ball.radii));
      colours_.push_back(ball.colour);
      if (ball.clear_edge && row == ball.row_end) colours_.back().a = 0;
      occlusion_.push_back(0.6F + 0.4F * std::cos(down) * std::cos(down));
      gloss_.push_back(1);
    }
  }
  const int rows = ball.row_end - ball.row_begin;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < kColumns; ++column) {
      const auto a = base + static_cast<std::uint32_t>(row * (kColumns + 1) + column);
      const std::uint32_t below = a + kColumns + 1;
      triangles_.push_back({a, below, a + 1});
      triangles_.push_back({a + 1, below, below + 1});
    }
  }
  ranges_.push_back({app::look_of(ball.material), first_triangle,
                     static_cast<std::uint32_t>(triangles_.size()) - first_triangle, ball.eye,
                     ball.clear_edge || ball.colour.a < 1});
  if (ball.eye >= 0) {
    eye_centres_.push_back(ball.centre);
    eye_forward_.emplace_back(0, 0, 1);
  }
}

view::StaticMesh SphereHead::static_mesh() const {
  return {triangles_, colours_, occlusion_, gloss_, ranges_};
}

view::MovingMesh SphereHead::moving_mesh() const {
  return {positions_, normals_, eye_centres_, eye_forward_};
}

PosedFace::PosedFace(face::Face face)
    : face_(std::move(face)), scene_(face_), deformer_(face_), activations_(face_.channels.size()) {
  deformed_ = &deformer_.deform(activations_);
}

Result<std::unique_ptr<PosedFace>> PosedFace::load(const std::filesystem::path& folder,
                                                   const std::filesystem::path& data_folder) {
  auto face = face::load_face(folder, data_folder);
  if (!face.has_value()) return face.error();
  return std::unique_ptr<PosedFace>(new PosedFace(std::move(face.value())));
}

void PosedFace::pose(const AuFrame& aus) {
  face::mix(face_, aus, face::Mixer::Maximum, activations_);
  deformed_ = &deformer_.deform(activations_);
}

view::StaticMesh PosedFace::static_mesh() const {
  return scene_.still();
}

view::MovingMesh PosedFace::moving_mesh() const {
  return app::FaceScene::moving(*deformed_);
}

}  // namespace aucast::test

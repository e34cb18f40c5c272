#include "tests/golden/default_face_fixture.h"

#include <cstdlib>

namespace aucast::test {

std::unique_ptr<face::Face> DefaultFace::face_;
std::unique_ptr<face::FaceDeformer> DefaultFace::deformer_;
std::vector<facegen::HalfVertex> DefaultFace::layout_;
std::vector<std::uint32_t> DefaultFace::mirror_;

void DefaultFace::SetUpTestSuite() {
  const auto data = find_data_folder({});
  ASSERT_TRUE(data) << data.error().message;
  const char* const shipped = std::getenv("AUCAST_SHIPPED_FACE");
  const std::string folder = shipped == nullptr ? "default" : shipped;
  auto loaded = face::load_face(*data / "faces" / folder, *data);
  ASSERT_TRUE(loaded) << loaded.error().message;
  face_ = std::make_unique<face::Face>(std::move(loaded).value());
  deformer_ = std::make_unique<face::FaceDeformer>(*face_);
  // The skin holds the half head and then the mirrors of what is off the midline.
  const std::vector<facegen::HalfVertex> half =
      facegen::lay_out_half_head(*facegen::identity_named("default")).vertices;
  layout_ = half;
  mirror_.assign(half.size(), 0);
  for (std::uint32_t i = 0; i < half.size(); ++i) {
    if (half[i].on_midline) {
      mirror_[i] = i;
      continue;
    }
    mirror_[i] = static_cast<std::uint32_t>(layout_.size());
    layout_.push_back(half[i]);
    mirror_.push_back(i);
  }
  ASSERT_EQ(layout_.size(), part("skin").vertex_count);
}

void DefaultFace::TearDownTestSuite() {
  face_.reset();
}

const face::MeshPart& DefaultFace::part(const std::string& name) {
  for (const face::MeshPart& part : face_->mesh.parts) {
    if (part.name == name) return part;
  }
  ADD_FAILURE() << "no part " << name;
  return face_->mesh.parts.front();
}

std::uint32_t DefaultFace::skin_vertex(facegen::Patch patch, int ring, int spoke, int side) {
  for (std::uint32_t i = 0; i < layout_.size(); ++i) {
    const facegen::HalfVertex& v = layout_[i];
    if (v.patch == patch && v.ring == ring && v.spoke == spoke) return side > 0 ? i : mirror_[i];
  }
  ADD_FAILURE() << "no vertex at ring " << ring << ", spoke " << spoke;
  return 0;
}

std::vector<glm::vec3> DefaultFace::posed(std::initializer_list<AuTerm> terms) {
  const AuFrame frame = frame_from_terms({terms.begin(), terms.size()});
  std::vector<float> activations(face_->channels.size());
  face::mix(*face_, frame, face::Mixer::Maximum, activations);
  return deformer_->deform(activations).positions;
}

std::vector<glm::vec3> DefaultFace::posed(int number) {
  return posed({AuTerm{static_cast<std::uint8_t>(number), Side::Both, 100}});
}

std::string DefaultFace::without_side(const std::string& name) {
  for (const std::string side : {"left_", "right_"}) {
    if (name.starts_with(side)) return name.substr(side.size());
  }
  return name;
}

std::vector<glm::vec3> DefaultFace::driven(const std::map<std::string, float>& channels) {
  std::vector<float> activations(face_->channels.size(), 0.0F);
  for (const auto& [channel, activation] : channels) {
    for (const std::string& name : {channel, "left_" + channel, "right_" + channel}) {
      if (const auto index = face_->channel_index(name)) activations[*index] = activation;
    }
  }
  return deformer_->deform(activations).positions;
}

}  // namespace aucast::test

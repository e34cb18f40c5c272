#include "client/app/video/face_diagram.h"

#include <gtest/gtest.h>

#include <algorithm>

#include <glm/geometric.hpp>

#include "common/files.h"

namespace aucast::app {
namespace {

class Diagram : public testing::Test {
 protected:
  void SetUp() override {
    const auto data = find_data_folder({});
    ASSERT_TRUE(data) << data.error().message;
    auto face = face::load_face(*data / "faces" / "default", *data);
    ASSERT_TRUE(face) << face.error().message;
    face_ = std::move(*face);
    activations_.resize(face_.channels.size());
  }
  void set(const char* channel, float value) {
    const auto index = face_.channel_index(channel);
    ASSERT_TRUE(index) << channel;
    activations_[*index] = value;
  }
  void update(FaceDiagram& diagram, const view::Layers& layers) {
    face::FaceDeformer deformer(face_);
    diagram.update(layers, activations_, deformer.deform(activations_));
  }

  face::Face face_;
  std::vector<float> activations_;
};

std::size_t warm(std::span<const view::Segment> segments) {
  return static_cast<std::size_t>(
      std::count_if(segments.begin(), segments.end(),
                    [](const view::Segment& one) { return one.colour.r > one.colour.b + 0.1F; }));
}

TEST_F(Diagram, ShowsWhatIsAskedFor) {
  FaceDiagram diagram(face_);
  update(diagram, {});
  EXPECT_TRUE(diagram.muscles().empty());
  EXPECT_TRUE(diagram.tags().empty());
  view::Layers layers;
  layers.muscles = true;
  update(diagram, layers);
  EXPECT_GT(diagram.muscles().size(), face_.muscles.size());
  EXPECT_TRUE(diagram.tags().empty());
  layers.jaw_tags = true;
  update(diagram, layers);
  const std::size_t jaw = diagram.tags().size();
  EXPECT_GT(jaw, 100U);
  layers.eye_tags = true;
  update(diagram, layers);
  EXPECT_GT(diagram.tags().size(), jaw);
}

TEST_F(Diagram, EveryMuscleHasItsEndsInTheDrawing) {
  FaceDiagram diagram(face_);
  view::Layers layers;
  layers.muscles = true;
  update(diagram, layers);
  const auto has_dot_at = [&](const glm::vec3& place) {
    const auto segments = diagram.muscles();
    return std::any_of(segments.begin(), segments.end(), [&](const view::Segment& one) {
      return one.from == one.to && glm::length(one.from - place) < 1e-4F;
    });
  };
  std::size_t linear = 0;
  for (const face::Muscle& muscle : face_.muscles) {
    const auto* shape = std::get_if<face::LinearMuscle>(&muscle.shape);
    if (shape == nullptr) continue;
    ++linear;
    EXPECT_TRUE(has_dot_at(shape->attachment)) << muscle.name;
    EXPECT_TRUE(has_dot_at(shape->insertion)) << muscle.name;
  }
  EXPECT_GT(linear, 0U);
}

TEST_F(Diagram, MusclesAtWorkAreColoured) {
  FaceDiagram diagram(face_);
  view::Layers layers;
  layers.muscles = true;
  update(diagram, layers);
  EXPECT_EQ(warm(diagram.muscles()), 0U);
  set("left_zygomaticus_major", 0.5F);
  update(diagram, layers);
  const std::size_t one = warm(diagram.muscles());
  EXPECT_GT(one, 0U);
  const glm::vec4 gentle = diagram.muscles().back().colour;
  set("left_zygomaticus_major", 2);
  update(diagram, layers);
  EXPECT_EQ(warm(diagram.muscles()), one);
  EXPECT_LT(diagram.muscles().back().colour.g, gentle.g);
}

TEST_F(Diagram, TheDrawingGoesWithTheHead) {
  FaceDiagram diagram(face_);
  view::Layers layers;
  layers.muscles = true;
  update(diagram, layers);
  const std::vector<view::Segment> before(diagram.muscles().begin(), diagram.muscles().end());
  set("head_turn_left", 1);
  update(diagram, layers);
  ASSERT_EQ(diagram.muscles().size(), before.size());
  float least = 1e9F;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const view::Segment& now = diagram.muscles()[i];
    // Carried as a whole: lengths stay.
    EXPECT_NEAR(glm::length(now.to - now.from), glm::length(before[i].to - before[i].from), 1e-3F);
    least = std::min(least, glm::length(now.to - before[i].to));
  }
  EXPECT_GT(least, 0.0F);
}

}  // namespace
}  // namespace aucast::app

#pragma once

#include <gtest/gtest.h>

#include <initializer_list>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "client/face/face.h"
#include "client/face/face_deformer.h"
#include "client/face/muscle_mixer.h"
#include "common/files.h"
#include "scripts/facegen/layout.h"

namespace aucast::test {

/// The default face, or the shipped one that AUCAST_SHIPPED_FACE names, as the player loads it, and
/// where each vertex of its skin lies in the layout.
class DefaultFace : public ::testing::Test {
 protected:
  static void SetUpTestSuite();
  static void TearDownTestSuite();

  [[nodiscard]] static const face::Face& face() { return *face_; }
  [[nodiscard]] static const face::MeshPart& part(const std::string& name);

  /// A vertex of the skin by its place in the layout; side 1 is the subject's left.
  [[nodiscard]] static std::uint32_t skin_vertex(facegen::Patch patch, int ring, int spoke,
                                                 int side = 1);
  /// The place of every vertex of the skin in the layout.
  [[nodiscard]] static const std::vector<facegen::HalfVertex>& layout() { return layout_; }
  /// The mirror image of every vertex of the skin.
  [[nodiscard]] static const std::vector<std::uint32_t>& mirror() { return mirror_; }

  /// Positions with the AUs at the given intensities.
  [[nodiscard]] static std::vector<glm::vec3> posed(std::initializer_list<AuTerm> terms);
  [[nodiscard]] static std::vector<glm::vec3> posed(int number);
  /// A name without its side: "zygomaticus_major" for "left_zygomaticus_major".
  [[nodiscard]] static std::string without_side(const std::string& name);
  /// Positions with single channels at an activation; a sided channel is driven on both sides.
  [[nodiscard]] static std::vector<glm::vec3> driven(const std::string& channel, float activation) {
    return driven({{channel, activation}});
  }
  [[nodiscard]] static std::vector<glm::vec3> driven(const std::map<std::string, float>& channels);

  // Places of the mouth, on the border of the lips; side 1 is the subject's left.
  [[nodiscard]] static std::uint32_t mouth_corner(int side = 1) {
    return skin_vertex(facegen::Patch::Mouth, facegen::kLipBorderRing, facegen::kMouthCornerSpoke,
                       side);
  }
  [[nodiscard]] static std::uint32_t upper_lip() {
    return skin_vertex(facegen::Patch::Mouth, facegen::kLipBorderRing, 3);
  }
  [[nodiscard]] static std::uint32_t lower_lip() {
    return skin_vertex(facegen::Patch::Mouth, facegen::kLipBorderRing, 21);
  }
  /// Whether the AU turns or moves the head, which takes the face along.
  [[nodiscard]] static bool turns_head(int number) { return number >= 51 && number <= 58; }

 private:
  static std::unique_ptr<face::Face> face_;
  static std::unique_ptr<face::FaceDeformer> deformer_;
  static std::vector<facegen::HalfVertex> layout_;
  static std::vector<std::uint32_t> mirror_;
};

}  // namespace aucast::test

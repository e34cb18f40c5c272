#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>
#include <map>
#include <set>
#include <utility>

#include "scripts/facegen/anatomy.h"
#include "scripts/facegen/proportions.h"
#include "tests/golden/default_face_fixture.h"

// What can be checked by number, on the head as the player loads it.

namespace aucast::test {
namespace {

using facegen::Patch;

class DefaultFaceMesh : public DefaultFace {
 protected:
  using Edge = std::pair<std::uint32_t, std::uint32_t>;

  [[nodiscard]] static std::map<Edge, int> directed_edges(const face::MeshPart& part) {
    std::map<Edge, int> edges;
    for (std::uint32_t t = 0; t < part.triangle_count; ++t) {
      const auto& triangle = face().mesh.triangles[part.triangle_begin + t];
      for (std::size_t k = 0; k < 3; ++k) ++edges[{triangle[k], triangle[(k + 1) % 3]}];
    }
    return edges;
  }

  /// Largest height of the opening between the lids: upper above lower margin, spoke by spoke.
  [[nodiscard]] static float aperture(const std::vector<glm::vec3>& positions, int side) {
    float largest = -1;
    for (int k = 1; k < 16; ++k) {
      const int upper = (k - 4 + facegen::kEyeSpokes) % facegen::kEyeSpokes;
      const int lower = (32 - k - 4) % facegen::kEyeSpokes;
      const auto height = [&](int spoke) {
        return positions[skin_vertex(Patch::Eye, facegen::kLidInnerRing, spoke, side)].y;
      };
      largest = std::max(largest, height(upper) - height(lower));
    }
    return largest;
  }

  /// 0.4 mm: less than the lips bulge before their line of contact.
  static constexpr float kUnseen = 0.03F;
  /// How far the lips are apart where they touch at rest, spokes 0 (middle) to 12 (corner).
  [[nodiscard]] static float lip_gap(const std::vector<glm::vec3>& positions, int spoke) {
    return positions[skin_vertex(Patch::Mouth, facegen::kLipContactRing, spoke)].y -
           positions[skin_vertex(Patch::Mouth, facegen::kLipContactRing, 24 - spoke)].y;
  }

  /// Least distance of the lids' vertices from the eyeball; negative when the ball pokes through.
  [[nodiscard]] static double clearance(const std::vector<glm::vec3>& positions) {
    double least = 1e9;
    for (std::size_t i = 0; i < layout().size(); ++i) {
      if (layout()[i].patch != Patch::Eye || layout()[i].ring > facegen::kLidInnerRing) continue;
      const facegen::Vec3 p{positions[i]};
      const facegen::Vec3 eye{face().eyes[p.x > 0 ? 0 : 1].centre};
      least = std::min(least, glm::length(p - eye) - facegen::kEyeRadius);
    }
    return least;
  }
};

TEST_F(DefaultFaceMesh, HasANeckNearlyAsWideAsTheFaceAtTheMouth) {
  const face::FaceMesh& mesh = face().mesh;
  const auto half_width = [&](float low, float high) {
    float widest = 0;
    for (std::size_t i = 0; i < layout().size(); ++i) {
      const glm::vec3& p = mesh.positions[i];
      if (p.y >= low && p.y <= high) widest = std::max(widest, p.x);
    }
    return widest;
  };
  const float face = half_width(-2.6F, -2.0F);
  const float neck = half_width(-6.0F, -5.0F);
  EXPECT_GT(neck, 0.74F * face) << neck << " beside " << face;
  EXPECT_LT(neck, face);
}

TEST_F(DefaultFaceMesh, IsFiniteAndWithinItsRanges) {
  const face::FaceMesh& mesh = face().mesh;
  for (const glm::vec3& p : mesh.positions) {
    ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
  }
  for (const auto& [name, values] : mesh.maps) {
    for (const float value : values) {
      ASSERT_TRUE(std::isfinite(value)) << name;
      if (name == "lid_angle" || name == "root_below") continue;
      // Beside the furrow the cheek swells.
      ASSERT_GE(value, name == "nasolabial" ? -1 : 0) << name;
      ASSERT_LE(value, 1) << name;
    }
  }
  for (const float value : mesh.occlusion) ASSERT_TRUE(value >= 0 && value <= 1);
  for (const float value : mesh.gloss) ASSERT_TRUE(value >= 0 && value <= 4);
}

TEST_F(DefaultFaceMesh, HasAllPartsWithTheSkinFirst) {
  EXPECT_EQ(face().mesh.parts.front().name, "skin");
  EXPECT_EQ(part("skin").vertex_count, 5294U);
  for (const char* name : {"left_eye", "right_eye", "upper_teeth", "lower_teeth", "tongue",
                           "mouth_bag", "left_brow", "right_brow", "lashes", "hair", "shirt"}) {
    EXPECT_GT(part(name).triangle_count, 0U) << name;
  }
}

TEST_F(DefaultFaceMesh, LaysStrandsAcrossTheHairAlone) {
  const std::vector<float>& strand = face().mesh.maps.at("strand");
  for (const face::MeshPart& piece : face().mesh.parts) {
    const auto begin = strand.begin() + piece.vertex_begin;
    const auto [least, most] = std::minmax_element(begin, begin + piece.vertex_count);
    const bool hair = piece.name == "hair";
    EXPECT_EQ(*least, 0) << piece.name;
    EXPECT_EQ(*most, hair ? 1 : 0) << piece.name;
  }
}

TEST_F(DefaultFaceMesh, MovesHairWithTheSkullAlone) {
  const face::MeshPart& hair = part("hair");
  const std::vector<float>& head = face().mesh.maps.at("head");
  for (const int number : {1, 2, 27}) {
    const auto positions = posed(number);
    for (std::uint32_t i = hair.vertex_begin; i < hair.vertex_begin + hair.vertex_count; ++i) {
      ASSERT_EQ(head[i], 1);
      ASSERT_LT(glm::length(positions[i] - face().mesh.positions[i]), 1e-5F) << "AU" << number;
    }
  }
}

TEST_F(DefaultFaceMesh, TheShouldersFollowATurnOfTheHeadALittle) {
  const face::MeshPart& shirt = part("shirt");
  const auto turned = posed(51);
  const auto from_pivot = [this](const glm::vec3& place) {
    const glm::vec3 arm = place - face().head->pivot;
    return glm::degrees(std::atan2(arm.x, arm.z));
  };
  for (std::uint32_t i = shirt.vertex_begin; i < shirt.vertex_begin + shirt.vertex_count; ++i) {
    const float turn = from_pivot(turned[i]) - from_pivot(face().mesh.positions[i]);
    const float degrees = turn - 360 * std::round(turn / 360);
    ASSERT_GT(degrees, 2) << "vertex " << i;
    ASSERT_LT(degrees, 8) << "vertex " << i;
  }
}

TEST_F(DefaultFaceMesh, LightsTheTeethLessTowardsTheCornersOfTheMouth) {
  const face::MeshPart& teeth = part("upper_teeth");
  const auto brightest = [&teeth](float least, float most) {
    float found = 0;
    for (std::uint32_t i = teeth.vertex_begin; i < teeth.vertex_begin + teeth.vertex_count; ++i) {
      const float aside = std::abs(face().mesh.positions[i].x);
      if (aside >= least && aside <= most) found = std::max(found, face().mesh.occlusion[i]);
    }
    return found;
  };
  EXPECT_GT(brightest(0, 0.3F), 0.95F);
  EXPECT_LT(brightest(1.1F, 1.4F), 0.80F);
  EXPECT_LT(brightest(1.6F, 1.8F), 0.50F);
}

TEST_F(DefaultFaceMesh, ShowsNoBlackHoleBesideTheTongue) {
  // What lies farthest of the lower row is seen from behind, past the tongue.
  const face::MeshPart& teeth = part("lower_teeth");
  for (std::uint32_t i = teeth.vertex_begin; i < teeth.vertex_begin + teeth.vertex_count; ++i) {
    if (face().mesh.positions[i].z > 6) continue;
    ASSERT_GT(face().mesh.colours[i].r, 0.12F) << "vertex " << i;
    ASSERT_GT(face().mesh.colours[i].r, 3 * face().mesh.colours[i].g) << "vertex " << i;
  }
}

TEST_F(DefaultFaceMesh, HidesTheFarHairBehindTheJawFromThreeQuarters) {
  constexpr float kYaw = 0.60F;  // as ViewpointPreset::ThreeQuarter
  // How far a part reaches to the right of the picture in a band of heights.
  const auto reach = [](const face::MeshPart& piece, float y) {
    float farthest = -1e9F;
    for (std::uint32_t i = piece.vertex_begin; i < piece.vertex_begin + piece.vertex_count; ++i) {
      const glm::vec3& p = face().mesh.positions[i];
      if (std::abs(p.y - y) > 0.25F || face().mesh.colours[i].a < 0.25F) continue;
      farthest = std::max(farthest, p.x * std::cos(kYaw) + p.z * std::sin(kYaw));
    }
    return farthest;
  };
  for (const float y : {-2.0F, -2.5F, -3.0F, -3.5F, -4.0F, -4.5F}) {
    EXPECT_LT(reach(part("hair"), y), reach(part("skin"), y) + 0.1F) << "at " << y;
  }
}

TEST_F(DefaultFaceMesh, UsesEveryDirectedEdgeOnce) {
  for (const face::MeshPart& piece : face().mesh.parts) {
    for (const auto& [edge, count] : directed_edges(piece)) {
      ASSERT_EQ(count, 1) << piece.name << " edge " << edge.first << "-" << edge.second;
    }
  }
}

TEST_F(DefaultFaceMesh, IsOpenOnlyAtEyesMouthAndNeck) {
  const auto edges = directed_edges(part("skin"));
  int open = 0;
  for (const auto& [edge, count] : edges) open += edges.contains({edge.second, edge.first}) ? 0 : 1;
  EXPECT_EQ(open, 2 * 32 + 48 + 64);
}

TEST_F(DefaultFaceMesh, HasNoTriangleWithoutArea) {
  const face::FaceMesh& mesh = face().mesh;
  const face::MeshPart& skin = part("skin");
  for (std::uint32_t t = 0; t < skin.triangle_count; ++t) {
    const auto& k = mesh.triangles[skin.triangle_begin + t];
    const glm::vec3 normal = glm::cross(mesh.positions[k[1]] - mesh.positions[k[0]],
                                        mesh.positions[k[2]] - mesh.positions[k[0]]);
    EXPECT_GT(glm::length(normal), 1e-5F) << "triangle " << t;
  }
}

TEST_F(DefaultFaceMesh, MirrorsButForWhatMakesAFaceUneven) {
  // The loops and what they weigh are mirrored; the form by a millimetre, as no face is its own
  // mirror image. The eyes and what is inside the mouth are.
  const face::FaceMesh& mesh = face().mesh;
  constexpr float kUneven = 0.13F;  // two millimetres from left to right
  float most = 0;
  for (std::size_t i = 0; i < layout().size(); ++i) {
    const glm::vec3& p = mesh.positions[i];
    const glm::vec3& q = mesh.positions[mirror()[i]];
    const float apart = glm::length(p - q * glm::vec3{-1, 1, 1});
    ASSERT_LT(apart, layout()[i].patch == Patch::Ear ? 1e-5F : kUneven) << i;
    most = std::max(most, apart);
    for (const auto& [name, values] : mesh.maps) {
      ASSERT_NEAR(values[i], values[mirror()[i]], 1e-5) << name << " " << i;
    }
  }
  EXPECT_GT(most, 0.02F) << "a mirror image";
}

TEST_F(DefaultFaceMesh, SealsTheLipsAtRest) {
  for (int spoke = 0; spoke < facegen::kMouthCornerSpoke; ++spoke) {
    const float upper =
        face().mesh.positions[skin_vertex(Patch::Mouth, facegen::kLipContactRing, spoke)].y;
    const float lower =
        face().mesh.positions[skin_vertex(Patch::Mouth, facegen::kLipContactRing, 24 - spoke)].y;
    EXPECT_LT(upper, lower) << "a slit at spoke " << spoke;
  }
}

TEST_F(DefaultFaceMesh, PartsAndSealsTheLipsAlongTheWholeMouth) {
  const auto open = posed(25);
  const auto dropped = posed(26);
  for (int spoke = 0; spoke <= 9; ++spoke) {
    EXPECT_GT(lip_gap(open, spoke), 0.02F) << spoke;
    EXPECT_GT(lip_gap(dropped, spoke), lip_gap(open, spoke)) << spoke;
  }
  EXPECT_GT(lip_gap(posed(27), 0), 1.5F);
}

TEST_F(DefaultFaceMesh, OpensTheMouthAsAnOvalThatEndsBeforeItsCorners) {
  // A lens gets evenly lower up to its points; a box does not get lower at all.
  for (const int number : {26, 27}) {
    const auto positions = posed(number);
    EXPECT_LT(lip_gap(positions, 11), 0.35F * lip_gap(positions, 0)) << "AU" << number;
    EXPECT_GT(lip_gap(positions, 11), 0.25F * lip_gap(positions, 0)) << "AU" << number;
    EXPECT_GT(lip_gap(positions, 9), 0.45F * lip_gap(positions, 0)) << "AU" << number;
  }
}

TEST_F(DefaultFaceMesh, SwellsTheCheekBesideAFurrowThatGetsDeeper) {
  const std::vector<glm::vec3>& rest = face().mesh.positions;
  const auto deeper = driven("nasolabial_furrow", 1);
  const auto forward = [&](const glm::vec2& place) {
    std::size_t at = 0;
    for (std::size_t i = 0; i < layout().size(); ++i) {
      const auto away = [&](std::size_t k) { return glm::distance(glm::vec2{rest[k]}, place); };
      if (rest[i].z > 5 && away(i) < away(at)) at = i;
    }
    return deeper[at].z - rest[at].z;
  };
  glm::vec2 furrow{facegen::kFurrow[2]};
  furrow.y -= static_cast<float>(facegen::middle_drop(facegen::Form{}, furrow.y));
  EXPECT_LT(forward(furrow), -0.05F);
  EXPECT_GT(forward(furrow + glm::vec2{0.5F, 0.4F}), 0.03F);
}

TEST_F(DefaultFaceMesh, CoversTheTopOfTheIrisWithTheLidAtRest) {
  // An iris that shows whole stares.
  const std::uint32_t lid = skin_vertex(Patch::Eye, facegen::kLidInnerRing, 4);
  const float above = face().mesh.positions[lid].y - face().eyes[0].centre.y;
  EXPECT_LT(above, 0.85F * static_cast<float>(facegen::kIrisRadius));
  EXPECT_GT(above, 0.55F * static_cast<float>(facegen::kIrisRadius)) << "sleepy";
}

TEST_F(DefaultFaceMesh, KeepsTheLipsShutWhereNoActionUnitPartsThem) {
  for (const int number : {4, 6, 11, 12, 13, 14, 15, 17, 18, 20, 23, 24, 28, 34, 35, 36, 38}) {
    const auto positions = posed(number);
    for (int spoke = 0; spoke <= 10; ++spoke) {
      EXPECT_LT(lip_gap(positions, spoke), kUnseen) << "AU" << number << " spoke " << spoke;
    }
  }
}

TEST_F(DefaultFaceMesh, BlowsThroughTheMiddleOfTheMouth) {
  // FACS lets 25 be scored with 33, not with 34 or 24: the air leaves, the cheeks stay round.
  const auto blown = posed(33);
  for (int spoke = 0; spoke <= 3; ++spoke) {
    EXPECT_GT(lip_gap(blown, spoke), kUnseen) << spoke;
    EXPECT_LT(lip_gap(blown, spoke), 0.2F) << spoke;
  }
  for (int spoke = 6; spoke <= 10; ++spoke) EXPECT_LT(lip_gap(blown, spoke), kUnseen) << spoke;
}

TEST_F(DefaultFaceMesh, HidesTheRedWhenTheLipsAreSucked) {
  const auto sucked = posed(28);
  const auto red = [](const std::vector<glm::vec3>& positions, int spoke) {
    return positions[skin_vertex(Patch::Mouth, facegen::kLipBorderRing, spoke)].y -
           positions[skin_vertex(Patch::Mouth, facegen::kLipBorderRing, 24 - spoke)].y;
  };
  for (int spoke = 0; spoke <= 8; ++spoke) {
    EXPECT_LT(red(sucked, spoke), 0.3F * red(face().mesh.positions, spoke)) << spoke;
    EXPECT_LT(red(sucked, spoke), 0.5F * red(posed(24), spoke)) << "24 shows more: " << spoke;
  }
}

TEST_F(DefaultFaceMesh, KeepsTheCornerOfTheMouthTogetherAtFullStretch) {
  const auto wide = driven("jaw", 4);
  for (int spoke = 10; spoke < 14; ++spoke) {
    for (int ring = facegen::kLipBorderRing; ring < facegen::kLipLastRing; ++ring) {
      const auto length = [&](const std::vector<glm::vec3>& positions) {
        return glm::length(positions[skin_vertex(Patch::Mouth, ring, spoke)] -
                           positions[skin_vertex(Patch::Mouth, ring, spoke + 1)]);
      };
      EXPECT_LT(length(wide), 0.6F) << "ring " << ring << " spoke " << spoke;
    }
  }
}

TEST_F(DefaultFaceMesh, BindsTheMouthBagToTheLips) {
  const face::MeshPart& bag = part("mouth_bag");
  for (const int number : {0, 12, 15, 18, 22, 25, 27, 28}) {
    const auto positions = posed(number);
    for (int spoke = 0; spoke < facegen::kMouthSpokes; ++spoke) {
      const glm::vec3 lip = positions[skin_vertex(Patch::Mouth, facegen::kLipLastRing, spoke)];
      const glm::vec3 inside = positions[bag.vertex_begin + static_cast<std::uint32_t>(spoke)];
      EXPECT_LT(glm::length(lip - inside), 1e-5F) << "AU" << number << " spoke " << spoke;
    }
  }
}

TEST_F(DefaultFaceMesh, OpensTheEyesByAFriendlyAmount) {
  EXPECT_GT(aperture(face().mesh.positions, 1), 0.8F);
  EXPECT_LT(aperture(face().mesh.positions, 1), 1.0F);
}

TEST_F(DefaultFaceMesh, CoversTheTopOfTheIrisUntilTheLidIsRaised) {
  // A lid that leaves the iris free stares; that is what AU5 is for.
  constexpr float kMmPerUnit = 14;
  const auto covered_mm = [](const std::vector<glm::vec3>& positions) {
    constexpr int kMiddle = 4;
    const float margin = positions[skin_vertex(Patch::Eye, facegen::kLidInnerRing, kMiddle)].y;
    return kMmPerUnit *
           (face().eyes[0].centre.y + static_cast<float>(facegen::kIrisRadius) - margin);
  };
  EXPECT_GT(covered_mm(face().mesh.positions), 1.5F);
  EXPECT_LT(covered_mm(face().mesh.positions), 3.5F);
  EXPECT_LT(covered_mm(posed(5)), -0.5F);
}

TEST_F(DefaultFaceMesh, KeepsTheArchOfTheUpperLidOfANarrowedEye) {
  // Level with the corners it is a slot.
  const auto arch = [](const std::vector<glm::vec3>& positions) {
    const auto height = [&](int spoke) {
      return positions[skin_vertex(Patch::Eye, facegen::kLidInnerRing, spoke)].y;
    };
    constexpr int kMiddle = 4;
    constexpr int kOuterCorner = 12;
    constexpr int kInnerCorner = 28;
    return height(kMiddle) - 0.5F * (height(kOuterCorner) + height(kInnerCorner));
  };
  EXPECT_GT(arch(driven("lid_close", 0.5F)), 0.1F);
  EXPECT_GT(arch(posed(6)), 0.25F);
  EXPECT_GT(arch(posed(7)), 0.2F);
}

TEST_F(DefaultFaceMesh, LooksAtTheViewerNotPastHim) {
  for (const face::Eye& eye : face().eyes) {
    const glm::vec3 pupil =
        face().mesh.positions[part(eye.part).vertex_begin] - glm::vec3{eye.centre};
    const float inwards = -std::copysign(1.0F, eye.centre.x) * std::atan2(pupil.x, pupil.z);
    EXPECT_GT(glm::degrees(inwards), 0.8F) << eye.part;
    EXPECT_LT(glm::degrees(inwards), 2.2F) << eye.part << " squints";
  }
}

TEST_F(DefaultFaceMesh, ClosesTheLidsOnTheEyeballWithoutHoles) {
  float before = 10;
  for (const float closure : {0.0F, 0.25F, 0.5F, 0.75F, 1.0F}) {
    const auto positions = driven("lid_close", closure);
    EXPECT_GE(clearance(positions), -0.002) << "closure " << closure;
    EXPECT_LT(aperture(positions, 1), before) << "closure " << closure;
    EXPECT_NEAR(aperture(positions, 1), aperture(positions, -1), 1e-4);
    before = aperture(positions, 1);
  }
  EXPECT_LE(before, 0.0F);
  EXPECT_GT(before, -0.06F);
}

TEST_F(DefaultFaceMesh, ClosesTheLidsAlsoInASmileWithoutCrossingThem) {
  const auto positions = posed({{6}, {7}, {12}, {43}});
  EXPECT_LE(aperture(positions, 1), 0.01F);
  EXPECT_GT(aperture(positions, 1), -0.08F);
}

TEST_F(DefaultFaceMesh, RaisesTheLidsWithoutLeavingTheEyeball) {
  const auto wide = driven("lid_raise", 1);
  EXPECT_GE(clearance(wide), -0.002);
  EXPECT_GT(aperture(wide, 1), aperture(face().mesh.positions, 1) + 0.1F);
}

TEST_F(DefaultFaceMesh, KeepsTheLidsOffTheEyeballInEveryRecording) {
  for (const auto& [number, recording] : face().recordings) {
    if (number >= 51 && number <= 58) continue;  // the head turns, the eyes with it
    EXPECT_GE(clearance(posed(number)), -0.02) << "AU" << number;
  }
}

}  // namespace
}  // namespace aucast::test

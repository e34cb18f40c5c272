#include "client/face/face_deformer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <random>
#include <tuple>

#include <glm/geometric.hpp>

#include "tests/support/allocations.h"
#include "tests/support/displacement.h"
#include "tests/support/seeded.h"
#include "tests/unit/face/small_face.h"

namespace aucast::face {
namespace {

using aucast::test::displacement;
using aucast::test::Seeded;
using test::only;

constexpr float kTolerance = 2e-6F;

class Deformer : public ::testing::Test {
 protected:
  std::vector<glm::vec3> positions(const std::vector<float>& activations) {
    return deformer_.deform(activations).positions;
  }
  std::vector<glm::vec3> positions(std::string_view channel, float value) {
    return positions(only(face_, channel, value));
  }
  /// The vertex of the neutral face nearest to a point.
  [[nodiscard]] std::size_t vertex_near(const glm::vec3& point) const {
    const auto& rest = face_.mesh.positions;
    const auto nearer = [&](const glm::vec3& a, const glm::vec3& b) {
      return glm::distance(a, point) < glm::distance(b, point);
    };
    return static_cast<std::size_t>(std::min_element(rest.begin(), rest.end(), nearer) -
                                    rest.begin());
  }
  std::vector<float> random_activations(Seeded& seeded) const {
    std::vector<float> activations;
    for (const Channel& channel : face_.channels) {
      activations.push_back(static_cast<float>(seeded.real(0, channel.activation_max)));
    }
    return activations;
  }

  Face face_ = test::small_face();
  FaceDeformer deformer_{face_};
};

TEST_F(Deformer, ZeroIsTheNeutralFaceBitForBit) {
  deformer_.deform(std::vector<float>(face_.channels.size(), 1.0F));
  const DeformedFace& out = deformer_.deform(std::vector<float>(face_.channels.size(), 0.0F));
  EXPECT_EQ(out.positions, face_.mesh.positions);
}

TEST_F(Deformer, TheNeutralFaceIsThatOfNoActivation) {
  const DeformedFace rest = neutral_face(face_);
  const DeformedFace& made = deformer_.deform(std::vector<float>(face_.channels.size()));
  EXPECT_EQ(rest.positions, made.positions);
  EXPECT_EQ(rest.eye_centres, made.eye_centres);
  EXPECT_EQ(rest.eye_forward, made.eye_forward);
  EXPECT_EQ(rest.eye_open, made.eye_open);
  EXPECT_EQ(rest.creases, made.creases);
  ASSERT_EQ(rest.normals.size(), made.normals.size());
  for (std::size_t i = 0; i < rest.normals.size(); ++i) {
    EXPECT_LT(glm::distance(rest.normals[i], made.normals[i]), 1e-3F) << i;
  }
}

TEST_F(Deformer, MadeInPortionsIsTheSameBitForBit) {
  FaceDeformer::Making making(face_);
  std::optional<FaceDeformer> made;
  int portions = 0;
  while (!made) {
    made = making.step();
    ++portions;
  }
  EXPECT_GT(portions, static_cast<int>(face_.muscles.size()));
  Seeded seeded(7);
  for (int i = 0; i < 20; ++i) {
    const std::vector<float> activations = random_activations(seeded);
    const DeformedFace& whole = deformer_.deform(activations);
    const DeformedFace& one = made->deform(activations);
    EXPECT_EQ(one.positions, whole.positions);
    EXPECT_EQ(one.normals, whole.normals);
  }
}

TEST_F(Deformer, NotFiniteAndNegativeCountAsZero) {
  for (const float bad :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
        -std::numeric_limits<float>::infinity(), -1.0F}) {
    EXPECT_EQ(positions(std::vector<float>(face_.channels.size(), bad)), face_.mesh.positions);
  }
}

TEST_F(Deformer, ActivationStopsAtTheChannelsMaximum) {
  for (const Channel& channel : face_.channels) {
    EXPECT_EQ(positions(channel.name, channel.activation_max),
              positions(channel.name, 10 * channel.activation_max))
        << channel.name;
  }
}

TEST_F(Deformer, EveryChannelMovesSomethingAndOnlySomething) {
  for (const Channel& channel : face_.channels) {
    const auto moved = positions(channel.name, 1);
    std::size_t count = 0;
    for (std::size_t i = 0; i < moved.size(); ++i) {
      if (moved[i] != face_.mesh.positions[i]) ++count;
    }
    EXPECT_GT(count, 0U) << channel.name;
    EXPECT_LT(count, moved.size()) << channel.name;
  }
}

TEST_F(Deformer, IsTheRestPlusTheSumOfTheMusclesDisplacements) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  for (int run = 0; run < 20; ++run) {
    std::vector<float> activations(face_.channels.size(), 0.0F);
    for (std::size_t m = 0; m < face_.muscles.size(); ++m) {
      if (seeded.chance(0.5)) activations[m] = static_cast<float>(seeded.real(0, 2));
    }
    const auto moved = positions(activations);
    for (std::size_t i = 0; i < moved.size(); ++i) {
      const glm::vec3& rest = face_.mesh.positions[i];
      glm::dvec3 expected(rest);
      for (std::size_t m = 0; m < face_.muscles.size(); ++m) {
        const std::string& mask = face_.muscles[m].mask;
        const float factor =
            face_.mesh.maps.at("muscle")[i] * (mask.empty() ? 1.0F : face_.mesh.maps.at(mask)[i]);
        expected += glm::dvec3(factor * displacement(face_.muscles[m].shape, rest, activations[m]));
      }
      ASSERT_LT(glm::distance(glm::dvec3(moved[i]), expected), kTolerance) << "vertex " << i;
    }
  }
}

TEST_F(Deformer, AMaskAloneMovesWhatTheMuscleMapKeepsStill) {
  face_.mesh.maps.at("muscle").assign(face_.mesh.positions.size(), 0.0F);
  const std::vector<float> pulling = test::only(face_, "left_depressor", 1);
  EXPECT_EQ(FaceDeformer(face_).deform(pulling).positions, face_.mesh.positions);
  for (Muscle& muscle : face_.muscles) muscle.mask_alone = muscle.mask == "half";
  EXPECT_TRUE(FaceDeformer(face_).deform(pulling).positions != face_.mesh.positions);
}

TEST_F(Deformer, TheOrderOfMusclesDoesNotMatter) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  std::vector<std::size_t> order(face_.muscles.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::shuffle(order.begin(), order.end(), std::mt19937_64(seeded.seed()));
  Face shuffled = face_;
  std::vector<float> activations = random_activations(seeded);
  std::vector<float> shuffled_activations = activations;
  for (std::size_t k = 0; k < order.size(); ++k) {
    shuffled.muscles[k] = face_.muscles[order[k]];
    shuffled.channels[k] = face_.channels[order[k]];
    shuffled_activations[k] = activations[order[k]];
  }
  const auto one = positions(activations);
  const auto other = FaceDeformer(shuffled).deform(shuffled_activations).positions;
  for (std::size_t i = 0; i < one.size(); ++i) {
    ASSERT_LT(glm::distance(one[i], other[i]), 5e-6F) << "vertex " << i;
  }
}

TEST_F(Deformer, LeftAndRightAreMirrorImages) {
  const auto mirror_of = [&](std::size_t i) {
    glm::vec3 point = face_.mesh.positions[i];
    point.x = -point.x;
    return vertex_near(point);
  };
  std::vector<std::size_t> mirror(face_.mesh.positions.size());
  for (std::size_t i = 0; i < mirror.size(); ++i) mirror[i] = mirror_of(i);
  const auto check = [&](const std::string& one, const std::string& other) {
    const auto a = positions(one, 1);
    const auto b = positions(other, 1);
    for (std::size_t i = 0; i < a.size(); ++i) {
      // x = 0 belongs to the left eye's lids and turns with neither here.
      const glm::vec3& m = b[mirror[i]];
      ASSERT_LT(glm::distance(a[i], glm::vec3(-m.x, m.y, m.z)), kTolerance)
          << one << ", vertex " << i;
    }
  };
  for (const Channel& channel : face_.channels) {
    if (channel.side != Side::Left) continue;
    std::string other = "right_" + channel.name.substr(5);
    if (other.ends_with("gaze_left")) other = "right_gaze_right";
    if (other.ends_with("gaze_right") && channel.name.ends_with("gaze_right")) {
      other = "right_gaze_left";
    }
    check(channel.name, other);
  }
  check("head_turn_left", "head_turn_right");
  check("head_tilt_left", "head_tilt_right");
}

TEST_F(Deformer, JawTurnsAboutItsHingeAndSlidesForward) {
  const std::size_t chin = vertex_near({0, -7.5F, 7.6F});
  ASSERT_EQ(face_.mesh.maps.at("jaw")[chin], 1.0F);
  const glm::dvec3 rest(face_.mesh.positions[chin]);
  const double angle = 4 * 5.5 * std::numbers::pi / 180;
  const glm::dvec3 hinge(0, 0.9F, 1.5);
  const glm::dvec3 arm = rest - hinge;
  const glm::dvec3 expected(
      rest.x, hinge.y + arm.y * std::cos(angle) - arm.z * std::sin(angle),
      hinge.z + arm.y * std::sin(angle) + arm.z * std::cos(angle) + 0.35 * angle);
  const glm::vec3 opened = positions("jaw", 4)[chin];
  EXPECT_LT(glm::distance(glm::dvec3(opened), expected), 1e-5);
  EXPECT_LT(opened.y, rest.y - 1);
}

TEST_F(Deformer, UpperLidsCloseDownwardsAndRaiseALittle) {
  const std::size_t left = vertex_near({2.25F, 3.3F, 8});
  const std::size_t right = vertex_near({-2.25F, 3.3F, 8});
  ASSERT_GT(face_.mesh.maps.at("lid_angle")[left], 0);
  const auto& rest = face_.mesh.positions;
  const auto closed = positions("left_lid_close", 1);
  EXPECT_LT(closed[left].y, rest[left].y - 0.5F);
  EXPECT_EQ(closed[right], rest[right]);
  EXPECT_FLOAT_EQ(glm::distance(closed[left], {rest[left].x, 2.7F, 6.2F}),
                  glm::distance(rest[left], {rest[left].x, 2.7F, 6.2F}));
  const auto raised = positions("left_lid_raise", 1);
  EXPECT_GT(raised[left].y, rest[left].y);
  EXPECT_LT(raised[left].y - rest[left].y, 0.3F * (rest[left].y - closed[left].y));
}

TEST_F(Deformer, HeadTurnsToTheSubjectsOwnLeftAndTiltsItsTopThere) {
  const std::size_t nose = vertex_near({0, 0, 9});
  const std::size_t top = vertex_near({0, 8.5F, 8});
  const auto& rest = face_.mesh.positions;
  EXPECT_GT(positions("head_turn_left", 1)[nose].x, 3);
  EXPECT_LT(positions("head_turn_right", 1)[nose].x, -3);
  EXPECT_GT(positions("head_up", 1)[nose].y, rest[nose].y + 1);
  EXPECT_LT(positions("head_down", 1)[nose].y, rest[nose].y - 1);
  EXPECT_GT(positions("head_tilt_left", 1)[top].x, 2);
  EXPECT_LT(positions("head_tilt_right", 1)[top].x, -2);
  EXPECT_FLOAT_EQ(positions("head_forward", 1)[nose].z, rest[nose].z + 1);
  EXPECT_FLOAT_EQ(positions("head_back", 1)[nose].z, rest[nose].z - 1);
}

TEST_F(Deformer, HeadAtFullWeightMovesAsOneRigidBody) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  std::vector<float> activations(face_.channels.size(), 0.0F);
  for (const auto* name : {"head_turn_left", "head_down", "head_tilt_right", "head_forward"}) {
    activations[*face_.channel_index(name)] = 1;
  }
  const auto moved = positions(activations);
  std::vector<std::size_t> rigid;
  for (std::size_t i = 0; i < moved.size(); ++i) {
    if (face_.mesh.maps.at("head")[i] == 1.0F) rigid.push_back(i);
  }
  for (int run = 0; run < 500; ++run) {
    const std::size_t a =
        rigid[static_cast<std::size_t>(seeded.integer(0, static_cast<int>(rigid.size()) - 1))];
    const std::size_t b =
        rigid[static_cast<std::size_t>(seeded.integer(0, static_cast<int>(rigid.size()) - 1))];
    ASSERT_NEAR(glm::distance(moved[a], moved[b]),
                glm::distance(face_.mesh.positions[a], face_.mesh.positions[b]), 1e-5F);
  }
}

TEST_F(Deformer, EyesLookWhereTheGazeAndTheHeadGo) {
  DeformedFace out = deformer_.deform(std::vector<float>(face_.channels.size(), 0.0F));
  ASSERT_EQ(out.eye_centres.size(), 2U);
  EXPECT_EQ(out.eye_centres[0], face_.eyes[0].centre);
  EXPECT_EQ(out.eye_forward[1], glm::vec3(0, 0, 1));

  out = deformer_.deform(only(face_, "left_gaze_left", 1));
  const float yaw = 28 * std::numbers::pi_v<float> / 180;
  EXPECT_LT(glm::distance(out.eye_forward[0], {std::sin(yaw), 0, std::cos(yaw)}), 1e-6F);
  EXPECT_EQ(out.eye_forward[1], glm::vec3(0, 0, 1));

  out = deformer_.deform(only(face_, "right_gaze_up", 1));
  EXPECT_GT(out.eye_forward[1].y, 0.37F);

  out = deformer_.deform(only(face_, "head_turn_left", 1));
  const float turn = 35 * std::numbers::pi_v<float> / 180;
  EXPECT_LT(glm::distance(out.eye_forward[0], {std::sin(turn), 0, std::cos(turn)}), 1e-6F);
  EXPECT_GT(out.eye_centres[0].x, 5);
}

/// Normals computed from nothing, in double.
std::vector<glm::vec3> plain_normals(const FaceMesh& mesh,
                                     const std::vector<glm::vec3>& positions) {
  std::vector<glm::dvec3> sums(positions.size(), glm::dvec3(0));
  for (const auto& [a, b, c] : mesh.triangles) {
    const glm::dvec3 normal = glm::cross(glm::dvec3(positions[b]) - glm::dvec3(positions[a]),
                                         glm::dvec3(positions[c]) - glm::dvec3(positions[a]));
    for (const std::uint32_t corner : {a, b, c}) sums[corner] += normal;
  }
  std::vector<glm::vec3> normals;
  for (const glm::dvec3& sum : sums) normals.emplace_back(glm::normalize(sum));
  return normals;
}

TEST_F(Deformer, NormalsBelongToTheDeformedFaceWhateverMoved) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  for (int run = 0; run < 40; ++run) {
    std::vector<float> activations(face_.channels.size(), 0.0F);
    for (std::size_t c = 0; c < activations.size(); ++c) {
      if (seeded.chance(0.15)) activations[c] = static_cast<float>(seeded.real(0, 1));
    }
    const DeformedFace& out = deformer_.deform(activations);
    const auto expected = plain_normals(face_.mesh, out.positions);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      ASSERT_LT(glm::distance(out.normals[i], expected[i]), 1e-4F) << "vertex " << i;
    }
  }
}

TEST_F(Deformer, IsSmoothInTheActivation) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  const std::vector<float> activations = random_activations(seeded);
  const auto before = positions(activations);
  for (std::size_t c = 0; c < activations.size(); ++c) {
    std::vector<float> changed = activations;
    changed[c] *= 0.999F;
    const auto after = positions(changed);
    for (std::size_t i = 0; i < after.size(); ++i) {
      ASSERT_LT(glm::distance(before[i], after[i]), 0.03F) << face_.channels[c].name;
    }
  }
}

TEST_F(Deformer, WhatWasShownBeforeLeavesNoTrace) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  std::vector<float> activations(face_.channels.size(), 0.0F);
  for (int run = 0; run < 60; ++run) {
    // Mostly a few channels change, as in an animation; now and then the whole face.
    for (std::size_t c = 0; c < activations.size(); ++c) {
      if (!seeded.chance(run % 10 == 0 ? 0.8 : 0.05)) continue;
      activations[c] = seeded.chance(0.5) ? 0.0F : static_cast<float>(seeded.real(0, 1));
    }
    const DeformedFace& out = deformer_.deform(activations);
    FaceDeformer fresh(face_);
    const DeformedFace& expected = fresh.deform(activations);
    ASSERT_EQ(out.positions, expected.positions) << "frame " << run;
    ASSERT_EQ(out.normals, expected.normals) << "frame " << run;
    ASSERT_EQ(out.eye_centres, expected.eye_centres);
    ASSERT_EQ(out.eye_forward, expected.eye_forward);
  }
}

TEST_F(Deformer, AllocatesNothingAfterTheFirstCall) {
  const std::vector<float> rest(face_.channels.size(), 0.0F);
  const std::vector<float> some(face_.channels.size(), 0.5F);
  const std::vector<float> all(face_.channels.size(), 1.0F);
  deformer_.deform(rest);
  const std::size_t before = aucast::test::allocations();
  for (const auto* activations : {&all, &some, &rest, &all}) deformer_.deform(*activations);
  EXPECT_EQ(aucast::test::allocations(), before);
  // The count sees what a deformer allocates.
  const FaceDeformer other(face_);
  EXPECT_GT(aucast::test::allocations(), before);
}

/// The small face and two ribbons of twice ten and twice twenty vertices beside parts of its skin,
/// which move as that does, of that material. They begin and end within a block.
Face with_ribbons(Face face, Material material) {
  FaceMesh& mesh = face.mesh;
  for (const auto& [name, from, length] :
       {std::tuple{"left_line", 600U, 10U}, std::tuple{"right_line", 1100U, 20U}}) {
    MeshPart part{name,
                  material,
                  static_cast<std::uint32_t>(mesh.positions.size()),
                  2 * length,
                  static_cast<std::uint32_t>(mesh.triangles.size()),
                  2 * (length - 1)};
    for (std::uint32_t i = 0; i < 2 * length; ++i) {
      const std::uint32_t beside = from + i / 2 + 41 * (i % 2);
      mesh.positions.push_back(mesh.positions[beside] + glm::vec3(0, 0, 0.01F));
      for (auto& [map_name, weights] : mesh.maps) weights.push_back(weights[beside]);
      if (i < 2) continue;
      const std::uint32_t v = part.vertex_begin + i;
      mesh.triangles.push_back({v - 2, v - 1, v});
    }
    mesh.parts.push_back(part);
    face.channels.push_back({name, Side::Both, 1, false});
  }
  return face;
}

TEST_F(Deformer, CreasesThatComeAndGoAreWhereTheyBelongWhileDrawn) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  const Face creased = with_ribbons(face_, Material::Crease);
  const Face plain = with_ribbons(face_, Material::Brow);  // always moved
  FaceDeformer deformer(creased);
  FaceDeformer all(plain);
  std::vector<float> activations(creased.channels.size(), 0.0F);
  std::size_t appeared = 0;
  for (int run = 0; run < 300; ++run) {
    for (std::size_t c = 0; c < activations.size(); ++c) {
      if (!seeded.chance(c + 2 < activations.size() ? 0.08 : 0.3)) continue;
      activations[c] = seeded.chance(0.5) ? 0.0F : static_cast<float>(seeded.real(0, 1));
    }
    const DeformedFace before = deformer.deform(activations);
    ASSERT_EQ(before.positions, deformer.deform(activations).positions);
    const DeformedFace& expected = all.deform(activations);
    std::size_t crease = 0;
    for (const MeshPart& part : creased.mesh.parts) {
      const bool hidden = is_crease(part) && !(before.creases.at(crease++) > 0);
      if (is_crease(part) && !hidden) ++appeared;
      for (std::size_t i = part.vertex_begin; i < part.vertex_begin + part.vertex_count; ++i) {
        if (!hidden) {
          ASSERT_EQ(before.positions[i], expected.positions[i]) << run << " " << i;
        }
        const glm::vec3 normal = is_crease(part) ? glm::vec3(0, 0, 1) : expected.normals[i];
        ASSERT_EQ(before.normals[i], normal) << run << " " << i;
      }
      if (!hidden) continue;
      // Those in the middle share no block with anything else.
      const std::size_t middle = part.vertex_begin + part.vertex_count / 2;
      ASSERT_EQ(before.positions[middle], creased.mesh.positions[middle]) << run;
    }
    FaceDeformer fresh(creased);
    ASSERT_EQ(before.positions, fresh.deform(activations).positions) << run;
    ASSERT_EQ(before.normals, fresh.deform(activations).normals) << run;
  }
  EXPECT_GT(appeared, 100U);
}

TEST_F(Deformer, OppositeChannelsTakeEachOtherAway) {
  std::vector<float> activations(face_.channels.size(), 0.0F);
  for (const auto* name :
       {"head_turn_left", "head_turn_right", "head_up", "head_down", "head_tilt_left",
        "head_tilt_right", "head_forward", "head_back", "left_gaze_left", "left_gaze_right",
        "right_gaze_up", "right_gaze_down"}) {
    activations[*face_.channel_index(name)] = 0.7F;
  }
  const DeformedFace& out = deformer_.deform(activations);
  EXPECT_EQ(out.positions, face_.mesh.positions);
  EXPECT_EQ(out.eye_centres[0], face_.eyes[0].centre);
  EXPECT_EQ(out.eye_forward[0], glm::vec3(0, 0, 1));
  std::vector<float> lids = only(face_, "left_lid_close", face_.lids->raised(1));
  lids[*face_.channel_index("left_lid_raise")] = 1;
  EXPECT_EQ(positions(lids), face_.mesh.positions) << "a lid that is raised and closed as far";
}

TEST_F(Deformer, AnEyeIsAsOpenAsItsLidLetsIt) {
  EXPECT_EQ(deformer_.deform(only(face_, "left_lid_close", 0.25F)).eye_open,
            (std::vector<float>{0.75F, 1}));
  EXPECT_EQ(deformer_.deform(only(face_, "right_lid_close", 1)).eye_open,
            (std::vector<float>{1, 0}));
  EXPECT_EQ(deformer_.deform(only(face_, "left_lid_raise", 1)).eye_open, (std::vector<float>{1, 1}))
      << "no more than at rest";
  Face lidless = test::small_face();
  lidless.lids.reset();
  FaceDeformer deformer(lidless);
  EXPECT_EQ(deformer.deform(only(lidless, "left_lid_close", 1)).eye_open,
            (std::vector<float>{1, 1}));
}

/// The small face with one of its muscles giving way to the lids.
Face with_yielding(std::string_view muscle) {
  Face face = test::small_face();
  face.muscles[*face.channel_index(muscle)].yields_to_lids = true;
  return face;
}

TEST_F(Deformer, AMuscleYieldsToTheLidOfItsSideByTheSquareOfItsClosing) {
  const Face face = with_yielding("left_orbicularis_oculi");
  FaceDeformer yielding(face);
  const auto with_lid = [&](std::string_view lid, float closed, float muscle) {
    std::vector<float> activations = only(face_, lid, closed);
    activations[*face_.channel_index("left_orbicularis_oculi")] = muscle;
    return activations;
  };
  const auto moved = [&](const std::vector<float>& activations) {
    return yielding.deform(activations).positions;
  };
  EXPECT_EQ(moved(with_lid("left_lid_close", 0, 1)), positions(with_lid("left_lid_close", 0, 1)));
  EXPECT_EQ(moved(with_lid("left_lid_close", 0.5F, 1)),
            positions(with_lid("left_lid_close", 0.5F, 0.75F)));
  EXPECT_EQ(moved(with_lid("left_lid_close", 1, 1)), positions("left_lid_close", 1));
  EXPECT_EQ(moved(with_lid("right_lid_close", 1, 1)), positions(with_lid("right_lid_close", 1, 1)))
      << "the other eye's lid";
}

TEST_F(Deformer, AMuscleOfTheMiddleYieldsToNoLid) {
  const Face face = with_yielding("mentalis");
  FaceDeformer yielding(face);
  std::vector<float> activations(face.channels.size(), 0.0F);
  for (const auto* name : {"left_lid_close", "right_lid_close", "mentalis"}) {
    activations[*face.channel_index(name)] = 1;
  }
  EXPECT_EQ(yielding.deform(activations).positions, positions(activations));
}

TEST_F(Deformer, MovesGoOnFromOneToAnother) {
  EXPECT_NE(positions("jaw", 2), face_.mesh.positions);
  FaceDeformer taken = std::move(deformer_);
  const std::vector<float> activations = only(face_, "jaw", 1);
  deformer_ = FaceDeformer(face_);
  EXPECT_EQ(taken.deform(activations).positions, positions(activations));
}

TEST(DeformerOfABareFace, CopesWithoutTrianglesMapsAndMovers) {
  Face face;
  face.mesh.positions = {{1, 2, 3}, {-1, 2, 3}, {0, 0, 0}};
  face.mesh.parts = {{"skin", Material::Skin, 0, 3, 0, 0}};
  FaceDeformer deformer(face);
  const DeformedFace& out = deformer.deform({});
  EXPECT_EQ(out.positions, face.mesh.positions);
  EXPECT_EQ(out.normals, std::vector<glm::vec3>(3, glm::vec3(0, 0, 1)));
}

TEST(DeformerOfABareFace, AnEyeWithoutAPartLooksAndMovesNothing) {
  Face face;
  face.mesh.positions.assign(700, {1, 2, 3});
  face.mesh.parts = {{"skin", Material::Skin, 0, 700, 0, 0}};
  face.eyes = {{"left_eye", {1, 2, 3}}};
  face.channels = {{"left_gaze_left", Side::Left, 1}};
  FaceDeformer deformer(face);
  const DeformedFace& out = deformer.deform(std::vector<float>{1});
  EXPECT_EQ(out.positions, face.mesh.positions);
  EXPECT_GT(out.eye_forward.at(0).x, 0.4F);
}

}  // namespace
}  // namespace aucast::face

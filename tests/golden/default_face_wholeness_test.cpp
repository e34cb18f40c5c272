#include <algorithm>
#include <array>
#include <map>
#include <string>

#include "client/app/assets.h"
#include "client/face/au_blender.h"
#include "client/face/side_word.h"
#include "scripts/facegen/anatomy.h"
#include "scripts/facegen/occlusion.h"
#include "tests/golden/default_face_fixture.h"
#include "tests/support/displacement.h"
#include "tests/support/seeded.h"

// Nothing that moves the face breaks it: no skin is turned over, and no tooth comes through it.

namespace aucast::test {
namespace {

using facegen::Patch;

class DefaultFaceWholeness : public DefaultFace {
 protected:
  /// Triangles of the outer skin that were turned over against the face `before`.
  [[nodiscard]] static int turned_over(
      const std::vector<glm::vec3>& positions,
      const std::vector<glm::vec3>& before = face().mesh.positions) {
    const face::FaceMesh& mesh = face().mesh;
    const face::MeshPart& skin = part("skin");
    const auto inner = [](std::uint32_t v) {
      const facegen::HalfVertex& at = layout()[v];
      // What the lids tuck in and the lips hide may fold.
      return (at.patch == Patch::Eye && at.ring > facegen::kLidInnerRing) ||
             (at.patch == Patch::Mouth && at.ring > facegen::kLipContactRing) ||
             at.patch == Patch::Nostril;
    };
    int count = 0;
    for (std::uint32_t t = 0; t < skin.triangle_count; ++t) {
      const auto& k = mesh.triangles[skin.triangle_begin + t];
      if (inner(k[0]) || inner(k[1]) || inner(k[2])) continue;
      const auto normal = [&](const std::vector<glm::vec3>& at) {
        return glm::cross(at[k[1]] - at[k[0]], at[k[2]] - at[k[0]]);
      };
      const glm::vec3 rest = normal(before);
      const glm::vec3 now = normal(positions);
      // Slivers turn over without being seen.
      constexpr float kVisible = 0.004F;
      if (glm::length(rest) < kVisible || glm::length(now) < kVisible) continue;
      // The edge of the lips at the corner of the mouth swings out by a little more than a right
      // angle when the jaw drops all the way; a fold goes far beyond.
      constexpr float kCosine = -0.4F;
      if (glm::dot(rest, now) < kCosine * glm::length(rest) * glm::length(now)) ++count;
    }
    return count;
  }

  /// Vertices of lips and skin with a tooth in front of them.
  [[nodiscard]] static int behind_teeth(const std::vector<glm::vec3>& positions) {
    facegen::Part teeth;
    for (const char* name : {"upper_teeth", "lower_teeth"}) {
      const face::MeshPart& piece = part(name);
      const auto shift = static_cast<std::uint32_t>(teeth.vertices.size());
      for (std::uint32_t i = 0; i < piece.vertex_count; ++i) {
        teeth.add(facegen::Vec3{positions[piece.vertex_begin + i]});
      }
      for (std::uint32_t t = 0; t < piece.triangle_count; ++t) {
        auto k = face().mesh.triangles[piece.triangle_begin + t];
        for (std::uint32_t& corner : k) corner += shift - piece.vertex_begin;
        teeth.add_triangle(k[0], k[1], k[2]);
      }
    }
    const std::array<const facegen::Part*, 1> parts{&teeth};
    const facegen::RayScene scene(parts);
    int count = 0;
    for (std::size_t i = 0; i < layout().size(); ++i) {
      const facegen::HalfVertex& v = layout()[i];
      if (v.patch != Patch::Mouth || v.ring >= facegen::kLipContactRing) continue;
      if (scene.hit(facegen::Vec3{positions[i]}, {0, 0, 1}, 1e-3, 3)) ++count;
    }
    return count;
  }

  /// Triangles of `piece` whose corners all satisfy `keep`, moved to `positions`.
  template <typename Keep>
  [[nodiscard]] static facegen::Part triangles_of(const face::MeshPart& piece,
                                                  const std::vector<glm::vec3>& positions,
                                                  Keep keep) {
    facegen::Part part;
    for (std::uint32_t i = 0; i < piece.vertex_count; ++i) {
      part.add(facegen::Vec3{positions[piece.vertex_begin + i]});
    }
    for (std::uint32_t t = 0; t < piece.triangle_count; ++t) {
      const auto& k = face().mesh.triangles[piece.triangle_begin + t];
      if (!keep(k[0]) || !keep(k[1]) || !keep(k[2])) continue;
      part.add_triangle(k[0] - piece.vertex_begin, k[1] - piece.vertex_begin,
                        k[2] - piece.vertex_begin);
    }
    return part;
  }

  /// Whether a vertex belongs to the skin round the mouth that can be seen with the lips shut.
  [[nodiscard]] static bool outside_mouth(std::uint32_t vertex) {
    const facegen::HalfVertex& v = layout()[vertex];
    const glm::vec3& p = face().mesh.positions[vertex];
    return p.z > 2 && p.y < 1 && p.y > -8 && v.patch != Patch::Nostril && v.patch != Patch::Ear &&
           (v.patch != Patch::Mouth || v.ring <= facegen::kLipContactRing);
  }

  /// Whether a vertex lies deep behind the line where the lips touch.
  [[nodiscard]] static bool inside_lips(std::uint32_t vertex) {
    return vertex < layout().size() && layout()[vertex].patch == Patch::Mouth &&
           layout()[vertex].ring > facegen::kLipContactRing + 1;
  }

  /// What of teeth, tongue and the inner side of the lips runs through the skin or a lip, and by
  /// how many edges; nothing if all stays behind.
  [[nodiscard]] static std::string through_skin(const std::vector<glm::vec3>& positions) {
    const facegen::Part outside = triangles_of(part("skin"), positions, outside_mouth);
    const std::array<const facegen::Part*, 1> parts{&outside};
    const facegen::RayScene scene(parts);
    std::string found;
    for (const char* name : {"upper_teeth", "lower_teeth", "tongue", "mouth_bag", "skin"}) {
      const auto any = [](std::uint32_t) { return true; };
      const facegen::Part piece = part(name).vertex_begin == 0
                                      ? triangles_of(part(name), positions, inside_lips)
                                      : triangles_of(part(name), positions, any);
      int count = 0;
      for (const face::Polygon& polygon : piece.polygons) {
        for (std::size_t e = 0; e < polygon.corner_count; ++e) {
          const std::size_t next = (e + 1) % polygon.corner_count;
          const facegen::Vec3& from = piece.vertices[polygon.corners[e]].position;
          const facegen::Vec3 way = piece.vertices[polygon.corners[next]].position - from;
          const double length = glm::length(way);
          if (length > 0 && scene.hit(from, way / length, 0, length)) ++count;
        }
      }
      if (count > 0) found += std::string{name} + " " + std::to_string(count) + "; ";
    }
    return found;
  }

  /// What is torn or turned over; nothing if the face is whole.
  [[nodiscard]] static std::string damage(const std::vector<glm::vec3>& positions) {
    std::string found = through_skin(positions);
    if (const int count = turned_over(positions); count > 0) {
      found += "turned over " + std::to_string(count) + "; ";
    }
    if (const int count = behind_teeth(positions); count > 0) {
      found += "behind teeth " + std::to_string(count) + "; ";
    }
    return found;
  }

  /// The lower face, without nostrils.
  [[nodiscard]] static bool moves_mouth(int number) { return number >= 9 && number < 38; }
};

TEST_F(DefaultFaceWholeness, TurnsNoTriangleOverInASingleActionUnit) {
  for (const auto& [number, recording] : face().recordings) {
    EXPECT_EQ(turned_over(posed(number)), 0) << "AU" << number;
  }
}

TEST_F(DefaultFaceWholeness, TurnsNoTriangleOverInTheSixExpressions) {
  EXPECT_EQ(turned_over(posed({{1}, {2}, {5}, {15}, {16}, {20}, {26}})), 0) << "surprise";
  EXPECT_EQ(turned_over(posed({{1}, {2}, {4}, {5}, {15}, {20}, {26}})), 0) << "fear";
  EXPECT_EQ(turned_over(posed({{2}, {4}, {9}, {15}, {17}})), 0) << "disgust";
  EXPECT_EQ(turned_over(posed({{2}, {4}, {7}, {9}, {10}, {20}, {26}})), 0) << "anger";
  EXPECT_EQ(turned_over(posed({{1}, {6}, {12}, {14}})), 0) << "happiness";
  EXPECT_EQ(turned_over(posed({{1}, {4}, {15}, {23}})), 0) << "sadness";
}

TEST_F(DefaultFaceWholeness, LetsNoToothThroughTheLips) {
  for (const auto& [number, recording] : face().recordings) {
    if (turns_head(number)) continue;
    EXPECT_EQ(behind_teeth(posed(number)), 0) << "AU" << number;
  }
  EXPECT_EQ(behind_teeth(posed({{6}, {12}, {25}})), 0) << "open smile";
  EXPECT_EQ(behind_teeth(posed({{9}, {15}, {16}})), 0) << "disgust";
  EXPECT_EQ(behind_teeth(posed({{15}, {16}, {20}, {26}})), 0) << "mouth of surprise";
}

TEST_F(DefaultFaceWholeness, SeesWhatRunsThroughShutLips) {
  EXPECT_EQ(through_skin(driven("tongue_out", 0.3F)), "");
  EXPECT_TRUE(through_skin(driven("tongue_out", 2)).starts_with("tongue "));
  auto turned_out = face().mesh.positions;
  for (std::uint32_t i = 0; i < layout().size(); ++i) {
    if (inside_lips(i)) turned_out[i].z += 1;
  }
  EXPECT_TRUE(through_skin(turned_out).starts_with("skin "));
}

TEST_F(DefaultFaceWholeness, KeepsTeethAndTongueOutOfTheSkin) {
  for (const auto& [number, recording] : face().recordings) {
    if (turns_head(number)) continue;
    for (const std::uint8_t percent : std::initializer_list<std::uint8_t>{10, 25, 50, 80, 100}) {
      const auto au = static_cast<std::uint8_t>(number);
      EXPECT_EQ(through_skin(posed({{au, Side::Both, percent}})), "")
          << "AU" << number << " at " << int{percent};
    }
  }
}

TEST_F(DefaultFaceWholeness, StaysWholeWithEveryMuscleAtItsMaximum) {
  for (const face::Muscle& muscle : face().muscles) {
    const std::string name = without_side(muscle.name);
    if (name == "tongue_out") continue;  // it goes through shut lips
    for (const float share : {0.25F, 0.5F, 1.0F}) {
      const float activation = share * muscle.activation_max;
      EXPECT_EQ(damage(driven(name, activation)), "") << name << " at " << activation;
    }
  }
}

TEST_F(DefaultFaceWholeness, StaysWholeInEveryPairOfMusclesOfTheMouth) {
  std::vector<std::string> names{"jaw"};
  std::vector<float> maxima{face().channels[*face().channel_index("jaw")].activation_max};
  for (const face::Muscle& muscle : face().muscles) {
    const std::string name = without_side(muscle.name);
    const auto pulls = [&](auto vertex) {
      return glm::length(displacement(muscle.shape, face().mesh.positions[vertex], 1)) > 0.02F;
    };
    if (name.starts_with("tongue") || names.back() == name) continue;
    if (!pulls(mouth_corner()) && !pulls(lower_lip())) continue;
    names.push_back(name);
    maxima.push_back(muscle.activation_max);
  }
  EXPECT_GT(names.size(), 25U);
  for (std::size_t j = 0; j < names.size(); ++j) {
    for (std::size_t i = 0; i < j; ++i) {
      // Half of both is what faces do; all of both is what anyone may ask for.
      for (const float share : {0.5F, 1.0F}) {
        SCOPED_TRACE(names[i] + "+" + names[j] + " at " + std::to_string(share));
        const auto positions =
            driven({{names[i], share * maxima[i]}, {names[j], share * maxima[j]}});
        if (share == 1 && names[i] == "depressor_labii" && names[j] == "mentalis") {
          // AU 16 and 17 need both nearly in full, and they pull the skin below the lip against
          // each other: it folds into the furrow above the chin, but nothing comes through.
          EXPECT_EQ(through_skin(positions), "");
          EXPECT_EQ(behind_teeth(positions), 0);
          continue;
        }
        EXPECT_EQ(damage(positions), "");
      }
    }
  }
}

TEST_F(DefaultFaceWholeness, StaysWholeInTheMacrosOfWaters) {
  const auto expressions = load_expressions(*find_data_folder({}) / "expressions.toml");
  ASSERT_TRUE(expressions);
  int macros = 0;
  for (const Expression& expression : *expressions) {
    std::map<std::string, float> channels;
    for (const ExpressionMuscle& muscle : expression.muscles) {
      const bool sided = !face().channel_index(muscle.name);
      channels[(sided ? "left_" : "") + muscle.name] = muscle.left;
      if (sided) channels["right_" + muscle.name] = muscle.right;
    }
    if (channels.empty()) continue;
    ++macros;
    EXPECT_EQ(damage(driven(channels)), "") << expression.name;
  }
  EXPECT_EQ(macros, 6);
}

TEST_F(DefaultFaceWholeness, StaysWholeInRandomSetsOfActionUnits) {
  Seeded seeded;
  SCOPED_TRACE(seeded.trace());
  const auto rules = face::load_rules(*find_data_folder({}) / "rules" / "facs.toml");
  ASSERT_TRUE(rules);
  std::vector<std::uint8_t> numbers;
  for (const auto& [number, recording] : face().recordings) {
    // The tongue of 19 and 37 comes out between lips that another AU may hold shut.
    if (number == 0 || number == 19 || number == 37 || turns_head(number)) continue;
    numbers.push_back(static_cast<std::uint8_t>(number));
  }
  // Half of what is drawn shows on both sides, as most of what faces do.
  constexpr std::array sides{Side::Both, Side::Both, Side::Left, Side::Right};
  face::FaceDeformer deformer(face());
  for (int set = 0; set < 1000; ++set) {
    std::vector<AuTerm> terms;
    std::string text;
    for (int count = seeded.integer(2, 6); count > 0; --count) {
      const int at = seeded.integer(0, static_cast<int>(numbers.size()) - 1);
      const auto percent = static_cast<std::uint8_t>(seeded.integer(10, 100));
      const Side side = sides.at(static_cast<std::size_t>(seeded.integer(0, 3)));
      terms.push_back({numbers.at(static_cast<std::size_t>(at)), side, percent});
      text += std::string{face::side_word(side)} + " " + std::to_string(terms.back().number) + ":" +
              std::to_string(percent) + ", ";
    }
    std::vector<float> activations(face().channels.size());
    const AuFrame frame = frame_from_terms(terms);
    face::mix(face(), face::blend(*rules, frame), face::Mixer::Maximum, activations);
    EXPECT_EQ(damage(deformer.deform(activations).positions), "") << text;
  }
}

TEST_F(DefaultFaceWholeness, StaysWholeInEveryPairOfActionUnits) {
  // The head last: it takes the face along, so the other one is held against the turned face.
  std::vector<std::uint8_t> numbers;
  for (const auto& [number, recording] : face().recordings) {
    if (number > 0) numbers.push_back(static_cast<std::uint8_t>(number));
  }
  std::stable_partition(numbers.begin(), numbers.end(),
                        [](std::uint8_t number) { return !turns_head(number); });
  for (std::size_t j = 0; j < numbers.size(); ++j) {
    const bool turns = turns_head(numbers[j]);
    const auto before = turns ? posed(numbers[j]) : face().mesh.positions;
    for (std::size_t i = 0; i < j; ++i) {
      SCOPED_TRACE(std::to_string(numbers[i]) + "+" + std::to_string(numbers[j]));
      const auto positions = posed({{numbers[i]}, {numbers[j]}});
      EXPECT_EQ(turned_over(positions, before), 0);
      if (turns) continue;
      EXPECT_EQ(behind_teeth(positions), 0);
      if (!moves_mouth(numbers[i]) || !moves_mouth(numbers[j])) continue;
      EXPECT_EQ(through_skin(positions), "");
    }
  }
}

}  // namespace
}  // namespace aucast::test

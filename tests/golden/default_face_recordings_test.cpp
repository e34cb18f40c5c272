#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "client/app/assets.h"
#include "client/face/au_blender.h"
#include "client/face/drawn_blocks.h"
#include "scripts/facegen/anatomy.h"
#include "tests/golden/default_face_fixture.h"

// The recordings move the face the way FACS describes. That they never break it is in
// default_face_wholeness_test.cpp.

namespace aucast::test {
namespace {

using facegen::Patch;

class DefaultFaceRecordings : public DefaultFace {
 protected:
  /// A vertex of the brow at t of the way from the nose to the temple.
  [[nodiscard]] static std::uint32_t brow(double t, const std::string& name = "left_brow") {
    constexpr std::uint32_t kAcross = 7;
    return part(name).vertex_begin + static_cast<std::uint32_t>(std::lround(t * 40)) * kAcross + 3;
  }
  /// The way of a vertex from rest.
  [[nodiscard]] static glm::vec3 way(std::uint32_t vertex,
                                     const std::vector<glm::vec3>& positions) {
    return positions[vertex] - face().mesh.positions[vertex];
  }
  [[nodiscard]] static glm::vec3 way(std::uint32_t vertex, int number) {
    return way(vertex, posed(number));
  }

  /// The face with an AU and every line drawn: those of others may be drawn along with it.
  [[nodiscard]] static std::vector<glm::vec3> posed_with_lines(int number) {
    std::vector<float> activations(face().channels.size());
    const AuTerm term{static_cast<std::uint8_t>(number), Side::Both, 100};
    face::mix(face(), frame_from_terms({&term, 1}), face::Mixer::Maximum, activations);
    for (const face::MeshPart& piece : face().mesh.parts) {
      if (face::is_crease(piece)) activations.at(*face().channel_index(piece.name)) = 1;
    }
    face::FaceDeformer deformer(face());
    return deformer.deform(activations).positions;
  }
  /// Depth of every crease of the mesh, in order.
  [[nodiscard]] static std::vector<float> lines(std::initializer_list<AuTerm> terms) {
    std::vector<float> activations(face().channels.size());
    face::mix(face(), frame_from_terms({terms.begin(), terms.size()}), face::Mixer::Maximum,
              activations);
    face::FaceDeformer deformer(face());
    return deformer.deform(activations).creases;
  }
  /// The place of a crease among the creases.
  [[nodiscard]] static std::size_t line(const std::string& name) {
    std::size_t index = 0;
    for (const face::MeshPart& piece : face().mesh.parts) {
      if (!face::is_crease(piece)) continue;
      if (piece.name == name) return index;
      ++index;
    }
    ADD_FAILURE() << "no crease " << name;
    return 0;
  }
  /// Distance to the nearest vertex of the skin.
  [[nodiscard]] static float above_skin(const std::vector<glm::vec3>& positions,
                                        const glm::vec3& p) {
    float nearest = 1e9F;
    for (std::size_t i = 0; i < layout().size(); ++i) {
      nearest = std::min(nearest, glm::length(positions[i] - p));
    }
    return nearest;
  }
};

TEST_F(DefaultFaceRecordings, HasTheMusclesOfTheThesisByName) {
  std::vector<std::string> names{"orbicularis_oris", "jaw"};
  for (const char* side : {"left_", "right_"}) {
    for (const char* muscle :
         {"zygomaticus_major", "depressor_anguli_oris", "frontalis_inner", "frontalis_major",
          "frontalis_outer", "levator_labii", "levator_labii_alaeque_nasi", "corrugator",
          "secondary_frontalis", "frontalis_sheet", "orbicularis_oculi"}) {
      names.push_back(std::string{side} + muscle);
    }
  }
  for (const std::string& name : names) EXPECT_TRUE(face().channel_index(name)) << name;
}

TEST_F(DefaultFaceRecordings, CoversTheActionUnitsOfTheThesisAndMore) {
  for (const int number :
       {0,  1,  2,  4,  5,  6,  7,  8,  9,  10, 11, 12, 13, 14, 15, 16, 17, 18, 19,
        20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 37, 38,
        39, 43, 45, 46, 51, 52, 53, 54, 55, 56, 57, 58, 61, 62, 63, 64, 65, 66}) {
    EXPECT_TRUE(face().recordings.contains(number)) << "AU" << number;
  }
}

TEST_F(DefaultFaceRecordings, MovesSomethingInEveryRecordingButNeutral) {
  for (const auto& [number, recording] : face().recordings) {
    const auto positions = posed(number);
    float largest = 0;
    for (std::size_t i = 0; i < positions.size(); ++i) {
      ASSERT_TRUE(std::isfinite(positions[i].x + positions[i].y + positions[i].z)) << number;
      largest = std::max(largest, glm::length(positions[i] - face().mesh.positions[i]));
    }
    if (number == 0) {
      EXPECT_EQ(largest, 0);
    } else {
      EXPECT_GT(largest, 0.08F) << "AU" << number;
    }
  }
}

TEST_F(DefaultFaceRecordings, MovesTheBrowsAsFacsSays) {
  EXPECT_GT(way(brow(0.1), 1).y, 0.4F);
  EXPECT_GT(way(brow(0.1), 1).y, 2 * way(brow(0.8), 1).y);
  EXPECT_GT(way(brow(0.7), 2).y, 0.35F);
  EXPECT_GT(way(brow(0.7), 2).y, 2 * way(brow(0.05), 2).y);
  EXPECT_LT(way(brow(0.1), 4).y, -0.3F);
  EXPECT_LT(way(brow(0.1), 4).x, -0.08F) << "together";
  EXPECT_LT(way(brow(0.5), 4).y, -0.15F);
}

TEST_F(DefaultFaceRecordings, KeepsTheBrowsAboveTheSkin) {
  for (const int number : {1, 2, 4, 9}) {
    const auto positions = posed(number);
    for (const double t : {0.1, 0.4, 0.7}) {
      const glm::vec3 over = positions[brow(t)];
      float nearest = 10;
      std::size_t at = 0;
      for (std::size_t i = 0; i < layout().size(); ++i) {
        const float distance = glm::length(positions[i] - over);
        if (distance < nearest) {
          nearest = distance;
          at = i;
        }
      }
      EXPECT_LT(nearest, 0.45F) << "AU" << number << " t " << t;
      EXPECT_LT(positions[at].z - over.z, 0.2F) << "AU" << number << " t " << t;
    }
  }
}

TEST_F(DefaultFaceRecordings, KeepsTheBrowsAsWideAsTheyAre) {
  const face::MeshPart& hairs = part("left_brow");
  const auto& rest = face().mesh.positions;
  // From the lowest to the highest vertex, in slices along the brow.
  const auto widths = [&](const std::vector<glm::vec3>& positions) {
    std::map<int, std::pair<float, float>> slices;
    for (std::size_t i = hairs.vertex_begin; i < hairs.vertex_begin + hairs.vertex_count; ++i) {
      const auto [slice, first] =
          slices.try_emplace(static_cast<int>(rest[i].x / 0.25F), positions[i].y, positions[i].y);
      slice->second.first = std::min(slice->second.first, positions[i].y);
      slice->second.second = std::max(slice->second.second, positions[i].y);
    }
    return slices;
  };
  const auto at_rest = widths(rest);
  for (const auto& posed_face : {posed({{4}}), posed({{1}, {4}}), posed({{1}, {2}, {4}, {5}})}) {
    for (const auto& [slice, edges] : widths(posed_face)) {
      const auto& [low, high] = at_rest.at(slice);
      if (high - low < 0.2F) continue;  // the very ends
      EXPECT_GT(edges.second - edges.first, 0.7F * (high - low)) << "slice " << slice;
    }
  }
}

TEST_F(DefaultFaceRecordings, MovesTheCornersOfTheMouthAsFacsSays) {
  EXPECT_GT(way(mouth_corner(), 12).y, 0.25F);
  EXPECT_GT(way(mouth_corner(), 12).x, 0.20F);
  EXPECT_LT(way(mouth_corner(), 15).y, -0.2F);
  EXPECT_GT(way(mouth_corner(), 20).x, 0.3F);
  EXPECT_LT(std::abs(way(mouth_corner(), 20).y), 0.15F);
  EXPECT_LT(way(mouth_corner(), 18).x, -0.25F);
  EXPECT_LT(way(mouth_corner(), 14).z, -0.2F);
  EXPECT_GT(way(mouth_corner(), 13).y, 0.3F);
}

TEST_F(DefaultFaceRecordings, SmilesWithBothLipsInAnArc) {
  const auto smile = posed({{6}, {12}, {25}});
  const auto height = [&](int spoke) {
    return smile[skin_vertex(Patch::Mouth, facegen::kLipContactRing, spoke)].y;
  };
  // From beside the corners down to the middle of each lip.
  EXPECT_GT(height(9) - height(0), 0.17F) << "the edge of the upper lip is straight";
  EXPECT_GT(height(15) - height(24), 0.46F) << "the lower lip is flat";
}

TEST_F(DefaultFaceRecordings, ThinsTheUpperLipInAShutSmileWithoutLosingIt) {
  const auto thickness = [](const std::vector<glm::vec3>& positions) {
    return positions[upper_lip()].y -
           positions[skin_vertex(Patch::Mouth, facegen::kLipContactRing, 3)].y;
  };
  const float at_rest = thickness(face().mesh.positions);
  const float smiling = thickness(posed({{6}, {12}}));
  EXPECT_LT(smiling, 0.90F * at_rest) << "a pout that smiles";
  EXPECT_GT(smiling, 0.72F * at_rest) << "a line";
}

TEST_F(DefaultFaceRecordings, FillsASmileWithTeethThatFollowTheLowerLip) {
  const auto smile = posed({{6}, {12}, {25}});
  const face::MeshPart& teeth = part("upper_teeth");
  // The edge of the row at some way from the middle.
  const auto edge = [&](float from, float to) {
    float lowest = 1e9F;
    for (std::uint32_t i = teeth.vertex_begin; i < teeth.vertex_begin + teeth.vertex_count; ++i) {
      const glm::vec3& p = smile[i];
      if (std::abs(p.x) >= from && std::abs(p.x) <= to) lowest = std::min(lowest, p.y);
    }
    return lowest;
  };
  const float lip = smile[skin_vertex(Patch::Mouth, facegen::kLipContactRing, 24)].y;
  EXPECT_LT(edge(0, 0.5F) - lip, 0.05F) << "a dark slot";
  EXPECT_GT(edge(1.2F, 1.5F) - edge(0, 0.5F), 0.075F) << "the row is straight";
}

TEST_F(DefaultFaceRecordings, OpensTheMouthOfFearAsARectangleWithTheLowerTeeth) {
  const auto positions = posed({{1}, {2}, {4}, {5}, {20}, {26}});
  const auto place = [&](int spoke) {
    return positions[skin_vertex(Patch::Mouth, facegen::kLipContactRing, spoke)];
  };
  const auto opening = [&](int spoke) {
    return place(spoke).y - place(facegen::kMouthSpokes - 1 - spoke).y;
  };
  // Three quarters of the way to its corner, a lens is not half as high.
  EXPECT_GT(opening(9), 0.55F * opening(0));
  const face::MeshPart& teeth = part("lower_teeth");
  float edge = -100;
  for (std::uint32_t i = teeth.vertex_begin; i < teeth.vertex_begin + teeth.vertex_count; ++i) {
    if (std::abs(positions[i].x) < 0.4F) edge = std::max(edge, positions[i].y);
  }
  EXPECT_GT(edge - place(facegen::kMouthSpokes - 1).y, 0.05F);
}

TEST_F(DefaultFaceRecordings, RaisesTheBrowByTheFrontalisWithoutAPeak) {
  const auto positions = driven("frontalis_major", 0.6F);  // Waters' fear
  const auto up = [&](double t) { return way(brow(t), positions).y; };
  EXPECT_GT(up(0.5), 0.3F);
  EXPECT_LT(up(0.5) - (up(0.1) + up(0.9)) / 2, 0.28F);
}

TEST_F(DefaultFaceRecordings, MovesTheLipsAsFacsSays) {
  EXPECT_GT(way(upper_lip(), 10).y, 0.15F);
  EXPECT_LT(std::abs(way(lower_lip(), 10).y), 0.05F);
  EXPECT_LT(way(lower_lip(), 16).y, -0.2F);
  EXPECT_LT(std::abs(way(upper_lip(), 16).y), 0.05F);
  EXPECT_GT(way(lower_lip(), 17).y, 0.2F);
  EXPECT_GT(way(upper_lip(), 22).z, 0.15F);
  EXPECT_LT(way(upper_lip(), 24).y, -0.1F) << "the red gets narrower";
  EXPECT_GT(way(lower_lip(), 24).y, 0.1F);
  EXPECT_LT(way(lower_lip(), 26).y, -0.3F);
  EXPECT_LT(way(lower_lip(), 27).y, 1.6F * way(lower_lip(), 26).y);
}

/// The sides on which an AU is scored, as far as it moves other channels there than on both.
std::vector<Side> scored_sides(const face::Face& face, const face::AuRecording& recording) {
  bool left = false;
  bool right = false;
  for (std::size_t i = 0; i < face.channels.size(); ++i) {
    left = left || (recording.activation[i] > 0 && face.channels[i].side == Side::Left);
    right = right || (recording.activation[i] > 0 && face.channels[i].side == Side::Right);
  }
  if (left && right) return {Side::Both, Side::Left, Side::Right};
  return {Side::Both};
}

// From A to E, for every AU that there is, on both sides and on each: the face as a whole goes
// farther, and so does the vertex that goes farthest. No step is too small to be seen.
TEST_F(DefaultFaceRecordings, GrowsWithEveryLetterInEveryActionUnit) {
  constexpr double kSmallestStep = 0.05;  // of the way at E
  for (const auto& [number, recording] : face().recordings) {
    if (number == 0) continue;
    for (const Side side : scored_sides(face(), recording)) {
      const auto at_letter = [&, au = static_cast<std::uint8_t>(number)](char letter) {
        return posed({AuTerm{au, side, percent_of_letter(letter).value()}});
      };
      const auto whole_way = [&](const std::vector<glm::vec3>& positions) {
        double sum = 0;
        for (std::uint32_t i = 0; i < positions.size(); ++i) sum += glm::length(way(i, positions));
        return sum;
      };
      const auto maximum = at_letter('E');
      std::uint32_t farthest = 0;
      for (std::uint32_t i = 0; i < maximum.size(); ++i) {
        if (glm::length(way(i, maximum)) > glm::length(way(farthest, maximum))) farthest = i;
      }
      double whole_before = 0;
      double farthest_before = 0;
      for (const char letter : std::string("ABCDE")) {
        SCOPED_TRACE("AU" + std::to_string(number) + letter + " on side " +
                     std::to_string(static_cast<int>(side)));
        const auto positions = at_letter(letter);
        const double whole = whole_way(positions);
        const double far = glm::length(way(farthest, positions));
        EXPECT_GT(whole, whole_before + kSmallestStep * whole_way(maximum));
        EXPECT_GT(far, farthest_before + kSmallestStep * glm::length(way(farthest, maximum)));
        whole_before = whole;
        farthest_before = far;
      }
    }
  }
}

TEST_F(DefaultFaceRecordings, MovesOnlyTheSideThatIsNamed) {
  for (const int number : {12, 13, 14, 15, 20}) {
    const auto positions = posed({{static_cast<std::uint8_t>(number), Side::Left, 100}});
    EXPECT_GT(glm::length(way(mouth_corner(1), positions)), 0.2F) << "AU" << number;
    EXPECT_LT(glm::length(way(mouth_corner(-1), positions)), 0.03F) << "AU" << number;
    for (const int spoke : {6, 18}) {
      const auto border = skin_vertex(Patch::Mouth, facegen::kLipBorderRing, spoke, -1);
      EXPECT_LT(glm::length(way(border, positions)), 0.03F) << "AU" << number << " " << spoke;
    }
  }
  for (const int number : {1, 2, 4}) {
    const auto positions = posed({{static_cast<std::uint8_t>(number), Side::Right, 100}});
    EXPECT_GT(glm::length(way(brow(0.4, "right_brow"), positions)), 0.15F) << "AU" << number;
    EXPECT_LT(glm::length(way(brow(0.4, "left_brow"), positions)), 0.05F) << "AU" << number;
  }
}

TEST_F(DefaultFaceRecordings, MirrorsLeftAndRight) {
  constexpr float kUneven = 0.06F;  // the skin before a muscle is uneven at rest
  for (const auto& [number, recording] : face().recordings) {
    if (turns_head(number) || shows_on_one_side(number) || number == 61 || number == 62) {
      continue;
    }
    const auto positions = posed(number);
    for (std::size_t i = 0; i < layout().size(); ++i) {
      const auto vertex = static_cast<std::uint32_t>(i);
      const glm::vec3 left = way(vertex, positions);
      const glm::vec3 right = way(mirror()[i], positions) * glm::vec3{-1, 1, 1};
      ASSERT_LT(glm::length(left - right), kUneven) << "AU" << number << " vertex " << i;
    }
  }
}

TEST_F(DefaultFaceRecordings, LeavesShirtAndSkullAlone) {
  const face::MeshPart& shirt = part("shirt");
  for (const auto& [number, recording] : face().recordings) {
    const auto positions = posed(number);
    if (turns_head(number)) continue;
    EXPECT_EQ(positions[shirt.vertex_begin], face().mesh.positions[shirt.vertex_begin]) << number;
    for (std::size_t i = 0; i < layout().size(); ++i) {
      if (face().mesh.positions[i].z > -1.0F) continue;
      ASSERT_LT(glm::length(positions[i] - face().mesh.positions[i]), 0.01F)
          << "AU" << number << " moves the back of the head";
    }
  }
}

// The lines that FACS coders look for.

TEST_F(DefaultFaceRecordings, DrawsOnlyTheLinesOnTheNeutralFaceThatItsSkinKeeps) {
  const std::vector<float> kept = face::kept_depths(face());
  EXPECT_EQ(lines({}), kept);
  EXPECT_EQ(lines({{25}, {43}, {51}, {61}}), kept);
  for (const float depth : kept) EXPECT_LT(depth, 0.5F) << "no room is left for an expression";
  const float beside_eye = kept.at(line("left_crease_crows_feet"));
  if (face().name == "marek") {
    EXPECT_GT(beside_eye, 0.1F) << "he is fifty";
  }
}

TEST_F(DefaultFaceRecordings, DrawsTheLinesThatFacsNames) {
  const std::vector<std::pair<int, std::string>> named{
      {1, "forehead_inner"}, {2, "forehead_outer"}, {4, "glabella"},    {6, "crows_feet"},
      {7, "lower_lid"},      {9, "nose_root"},      {10, "nasolabial"}, {11, "nasolabial"},
      {12, "nasolabial"},    {14, "mouth_corner"},  {17, "chin"},       {21, "neck"},
      {23, "lips"}};
  for (const auto& [number, name] : named) {
    float before = face::kept_depths(face()).at(line("left_crease_" + name));
    for (const std::uint8_t percent : std::initializer_list<std::uint8_t>{10, 25, 50, 80, 100}) {
      const auto depths = lines({{static_cast<std::uint8_t>(number), Side::Both, percent}});
      const float left = depths.at(line("left_crease_" + name));
      EXPECT_GT(left, before) << "AU" << number << " at " << int{percent};
      EXPECT_EQ(left, depths.at(line("right_crease_" + name))) << "AU" << number;
      before = left;
    }
    EXPECT_GE(before, 0.8F) << "AU" << number;
  }
}

TEST_F(DefaultFaceRecordings, DrawsLinesOnTheSideThatIsNamed) {
  const auto depths = lines({{12, Side::Left, 100}});
  EXPECT_GT(depths.at(line("left_crease_nasolabial")), 0.5F);
  const std::size_t right = line("right_crease_nasolabial");
  EXPECT_EQ(depths.at(right), face::kept_depths(face()).at(right));
}

TEST_F(DefaultFaceRecordings, KeepsTheLinesOnTheSkin) {
  for (const auto& [number, recording] : face().recordings) {
    if (turns_head(number)) continue;
    const auto positions = posed_with_lines(number);
    for (const face::MeshPart& piece : face().mesh.parts) {
      if (!face::is_crease(piece)) continue;
      for (std::uint32_t i = 0; i < piece.vertex_count; i += 7) {
        EXPECT_LT(above_skin(positions, positions[piece.vertex_begin + i]), 0.65F)
            << "AU" << number << " " << piece.name;
      }
    }
  }
}

}  // namespace
}  // namespace aucast::test

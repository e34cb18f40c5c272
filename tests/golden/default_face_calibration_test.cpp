#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "scripts/facegen/anatomy.h"
#include "tests/golden/calibration.h"
#include "tests/golden/default_face_fixture.h"

// Every recording against data/faces/calibration.toml.

namespace aucast::test {
namespace {

using Positions = std::vector<glm::vec3>;

class FaceCalibration : public DefaultFace {
 protected:
  static void SetUpTestSuite() {
    DefaultFace::SetUpTestSuite();
    const auto data = find_data_folder({});
    ASSERT_TRUE(data) << data.error().message;
    auto loaded = load_calibration(*data / "faces/calibration.toml");
    ASSERT_TRUE(loaded) << loaded.error().message;
    calibration_ = std::move(loaded).value();
  }

  [[nodiscard]] static const Calibration& calibration() { return calibration_; }

  /// The vertex of a landmark on the left (1) or right (-1) side.
  [[nodiscard]] static std::uint32_t vertex_of(const Landmark& landmark, int side) {
    if (landmark.patch == "eye") {
      return skin_vertex(facegen::Patch::Eye, landmark.ring, landmark.spoke, side);
    }
    if (landmark.patch == "mouth") {
      return skin_vertex(facegen::Patch::Mouth, landmark.ring, landmark.spoke, side);
    }
    std::string name = landmark.part;
    if (side < 0 && name.starts_with("left_")) name = "right_" + name.substr(5);
    const glm::vec3 near = landmark.near * glm::vec3(static_cast<float>(side), 1, 1);
    const face::MeshPart& piece = part(name);
    std::uint32_t best = piece.vertex_begin;
    float least = std::numeric_limits<float>::max();
    for (std::uint32_t i = 0; i < piece.vertex_count; ++i) {
      const float distance = glm::length(face().mesh.positions[piece.vertex_begin + i] - near);
      if (distance >= least) continue;
      least = distance;
      best = piece.vertex_begin + i;
    }
    return best;
  }

  [[nodiscard]] static bool central(const Landmark& landmark) {
    return std::abs(face().mesh.positions[vertex_of(landmark, 1)].x) < 0.05F;
  }

  [[nodiscard]] static glm::vec3 way_mm(const std::string& name, int side,
                                        const Positions& positions) {
    const std::uint32_t vertex = vertex_of(*calibration_.find(name), side);
    return (positions[vertex] - face().mesh.positions[vertex]) * calibration_.mm_per_unit;
  }

  [[nodiscard]] static float measured_mm(const Expected& expected, int side,
                                         const Positions& positions) {
    const glm::vec3 way = way_mm(expected.at, side, positions);
    switch (expected.way) {
      case Way::Up:
        return way.y;
      case Way::Forward:
        return way.z;
      case Way::Out:
        return way.x * static_cast<float>(side);
      case Way::Left:
        break;
    }
    return way.x;
  }

  [[nodiscard]] static Positions at(const CalibratedAu& au, Side side, std::uint8_t percent) {
    return posed({AuTerm{static_cast<std::uint8_t>(au.number), side, percent}});
  }

  /// Both sides, if the AU shows on both.
  [[nodiscard]] static Positions at_full(const CalibratedAu& au) {
    return at(au, shows_on_one_side(au.number) ? Side::Left : Side::Both, 100);
  }
  [[nodiscard]] static std::string label(const CalibratedAu& au, const std::string& landmark) {
    return "AU" + std::to_string(au.number) + " " + landmark;
  }

 private:
  static Calibration calibration_;
};

Calibration FaceCalibration::calibration_;

TEST_F(FaceCalibration, HasARowForEveryRecording) {
  for (const auto& [number, recording] : face().recordings) {
    if (number == 0) continue;
    const auto has_row = [number = number](const CalibratedAu& au) { return au.number == number; };
    EXPECT_TRUE(std::any_of(calibration().aus.begin(), calibration().aus.end(), has_row))
        << "AU" << number;
  }
  for (const CalibratedAu& au : calibration().aus) {
    EXPECT_TRUE(face().recordings.contains(au.number)) << "AU" << au.number;
  }
}

TEST_F(FaceCalibration, FindsEveryLandmarkWhereItIsNamed) {
  for (const Landmark& landmark : calibration().landmarks) {
    const glm::vec3 left = face().mesh.positions[vertex_of(landmark, 1)];
    const glm::vec3 right = face().mesh.positions[vertex_of(landmark, -1)];
    // As far as a face is uneven at rest.
    EXPECT_LT(glm::length(left - right * glm::vec3(-1, 1, 1)), 0.13F) << landmark.name;
    if (!landmark.part.empty()) {
      EXPECT_LT(glm::length(left - landmark.near), 1.0F) << landmark.name;
    }
  }
}

TEST_F(FaceCalibration, MovesEveryLandmarkAsFarAsFacsSays) {
  for (const CalibratedAu& au : calibration().aus) {
    const Positions full = at_full(au);
    for (const Expected& expected : au.expect) {
      const float mm = measured_mm(expected, 1, full);
      EXPECT_TRUE(mm >= expected.least_mm && mm <= expected.most_mm)
          << label(au, expected.at) << " way " << static_cast<int>(expected.way) << " goes " << mm
          << " mm, not " << expected.least_mm << " to " << expected.most_mm;
    }
  }
}

TEST_F(FaceCalibration, LeavesStillWhatFacsDoesNotName) {
  for (const CalibratedAu& au : calibration().aus) {
    const Positions full = at_full(au);
    for (const std::string& name : au.still) {
      EXPECT_LE(glm::length(way_mm(name, 1, full)), calibration().still_mm) << label(au, name);
    }
  }
}

TEST_F(FaceCalibration, GrowsFromEveryIntensityLetterToTheNext) {
  for (const CalibratedAu& au : calibration().aus) {
    std::vector<float> before(au.expect.size(), 0);
    for (const char letter : {'A', 'B', 'C', 'D', 'E'}) {
      const auto percent = percent_of_letter(letter);
      ASSERT_TRUE(percent);
      const Positions positions =
          at(au, shows_on_one_side(au.number) ? Side::Left : Side::Both, *percent);
      for (std::size_t i = 0; i < au.expect.size(); ++i) {
        // What may go either way is a bound, not a movement.
        if (au.expect[i].least_mm < 0 && au.expect[i].most_mm > 0) continue;
        const float mm = std::abs(measured_mm(au.expect[i], 1, positions));
        EXPECT_GT(mm, before[i]) << label(au, au.expect[i].at) << " at " << letter;
        before[i] = mm;
      }
    }
  }
}

// Else fear looks like surprise, or like anger where the middle goes down.
TEST_F(FaceCalibration, RaisesTheBrowsStraightAndTogetherInFear) {
  const Positions fear = posed({{1}, {2}, {4}});
  const Positions surprise = posed({{1}, {2}});
  EXPECT_GT(way_mm("inner_brow", 1, fear).y, 3.5F);
  EXPECT_LT(way_mm("inner_brow", 1, fear).x, -3.0F) << "together";
  EXPECT_GT(way_mm("mid_brow", 1, fear).y, -0.5F);
  EXPECT_LT(way_mm("mid_brow", 1, fear).y, 0.4F * way_mm("mid_brow", 1, surprise).y) << "arched";
}

// Heads of brows that rise more than the rest, or come together, plead.
TEST_F(FaceCalibration, RaisesTheBrowsAsAnArchInSurprise) {
  const Positions surprise = posed({{1}, {2}});
  EXPECT_GT(way_mm("mid_brow", 1, surprise).y, 0.9F * way_mm("inner_brow", 1, surprise).y);
  EXPECT_GT(way_mm("outer_brow", 1, surprise).y, 0.75F * way_mm("inner_brow", 1, surprise).y);
  EXPECT_GT(way_mm("inner_brow", 1, surprise).x, -0.5F);
}

TEST_F(FaceCalibration, MovesTheNamedSideAsItsMirrorImage) {
  // No side is quite the other's mirror image at rest, so the muscles find it elsewhere.
  constexpr float kSameMm = 1.0F;
  for (const CalibratedAu& au : calibration().aus) {
    if (!au.sided) continue;
    const Positions left = at(au, Side::Left, 100);
    const Positions right = at(au, Side::Right, 100);
    for (const Landmark& landmark : calibration().landmarks) {
      const glm::vec3 a = way_mm(landmark.name, 1, left);
      const glm::vec3 b = way_mm(landmark.name, -1, right) * glm::vec3(-1, 1, 1);
      EXPECT_LT(glm::length(a - b), kSameMm) << label(au, landmark.name);
    }
  }
}

TEST_F(FaceCalibration, MovesMostlyTheNamedSide) {
  for (const CalibratedAu& au : calibration().aus) {
    if (!au.sided) continue;
    const Positions left = at(au, Side::Left, 100);
    for (const Expected& expected : au.expect) {
      if (central(*calibration().find(expected.at))) continue;
      if (expected.least_mm < 0 && expected.most_mm > 0) continue;
      const float here = std::abs(measured_mm(expected, 1, left));
      const float there = std::abs(measured_mm(expected, -1, left));
      EXPECT_GT(here, 3 * there) << label(au, expected.at);
    }
  }
}

}  // namespace
}  // namespace aucast::test

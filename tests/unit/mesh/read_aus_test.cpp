#include "common/mesh/read_aus.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "common/mesh/neutral_face.h"

namespace aucast::mesh {
namespace {

constexpr double kTolerance = 1e-6;

/// Zeros for the typical face; AU 12 by its own corner's height, 45 by the aperture that is
/// missing, 26 by the chin, 51 and 53 by the head's turn.
const std::string kWeights =
    "# for a test\n"
    "neutral-side 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0\n"
    "neutral-middle 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0\n"
    "feature own-corner-up\n"
    "feature own-aperture\n"
    "feature chin-up\n"
    "feature turn-left\n"
    "feature turn-up\n"
    "feature own-corner-up above\n"
    "feature own-corner-up times own-corner-up\n"
    "au 12 sided 0 0 10 0 0 0 0 0 0\n"
    "au 45 sided 0.2 0 0 -2 0 0 0 0 0\n"
    "au 26 whole 0 0 0 0 -5 0 0 0 0\n"
    "au 51 turning 0 0 0 0 0 2 0 0 0\n"
    "au 53 signed 0 0 0 0 0 0 4 0 0\n"
    "au 15 sided 0 0 -3 0 0 0 0 3 7\n";

AuWeights weights() {
  auto read = parse_au_weights(kWeights, "weights.txt");
  EXPECT_TRUE(read.has_value()) << read.error().message;
  return std::move(*read);
}

double& left_of(Measures& measures, SideMeasure what) {
  return measures.left[static_cast<std::size_t>(what)];
}
double left_of(const Measures& measures, SideMeasure what) {
  return measures.left[static_cast<std::size_t>(what)];
}
double& right_of(Measures& measures, SideMeasure what) {
  return measures.right[static_cast<std::size_t>(what)];
}
double& middle_of(Measures& measures, MiddleMeasure what) {
  return measures.middle[static_cast<std::size_t>(what)];
}

TEST(ReadAus, TellsSidesApartAndSharesTheMiddle) {
  Measures seen;
  left_of(seen, SideMeasure::CornerUp) = 0.05;
  middle_of(seen, MiddleMeasure::ChinUp) = -0.1;
  const AuFrame frame = read_aus(weights(), seen, Measures{});
  EXPECT_NEAR(double{frame.left[12]}, 0.5, kTolerance);
  EXPECT_NEAR(double{frame.right[12]}, 0, kTolerance);
  EXPECT_NEAR(double{frame.left[26]}, 0.5, kTolerance);
  EXPECT_NEAR(double{frame.right[26]}, 0.5, kTolerance);
}

TEST(ReadAus, ComparesWithTheNeutralFace) {
  Measures neutral;
  left_of(neutral, SideMeasure::CornerUp) = 0.04;
  Measures seen = neutral;
  EXPECT_EQ(read_aus(weights(), seen, neutral), AuFrame{});
  left_of(seen, SideMeasure::CornerUp) = 0.07;
  EXPECT_NEAR(double{read_aus(weights(), seen, neutral).left[12]}, 0.3, kTolerance);
}

TEST(ReadAus, LeavesNoiseOutAndStaysWithinFullIntensity) {
  Measures neutral;
  left_of(neutral, SideMeasure::Aperture) = right_of(neutral, SideMeasure::Aperture) = 0.5;
  Measures seen = neutral;
  left_of(seen, SideMeasure::Aperture) = 0.45;  // a tenth shut, 0.2: the threshold
  right_of(seen, SideMeasure::Aperture) = 0.35;
  AuFrame frame = read_aus(weights(), seen, neutral);
  EXPECT_NEAR(double{frame.left[45]}, 0, kTolerance);
  EXPECT_NEAR(double{frame.right[45]}, 0.5, kTolerance);
  right_of(seen, SideMeasure::Aperture) = -3;
  frame = read_aus(weights(), seen, neutral);
  EXPECT_EQ(frame.right[45], 1.0F);
}

TEST(ReadAus, NarrowEyesAreShutAsWideOnesAre) {
  Measures neutral;
  left_of(neutral, SideMeasure::Aperture) = 0.4;
  right_of(neutral, SideMeasure::Aperture) = 0.2;
  Measures seen;
  left_of(seen, SideMeasure::Aperture) = 0.28;
  right_of(seen, SideMeasure::Aperture) = 0.14;
  const AuFrame frame = read_aus(weights(), seen, neutral);
  EXPECT_NEAR(double{frame.left[45]}, 0.5, kTolerance);
  EXPECT_NEAR(double{frame.right[45]}, 0.5, kTolerance);
}

TEST(ReadAus, ATurnIsOneOfTwoOppositesAndMayBeMoreThanFull) {
  Measures seen;
  seen.turn = {0.2, -0.3, 0};
  const AuFrame frame = read_aus(weights(), seen, Measures{});
  EXPECT_NEAR(double{frame.left[51]}, 0.4, kTolerance);
  EXPECT_NEAR(double{frame.right[51]}, 0.4, kTolerance);
  EXPECT_EQ(frame.left[52], 0.0F);
  EXPECT_EQ(frame.left[53], 0.0F);
  EXPECT_NEAR(double{frame.left[54]}, 1.2, kTolerance);
}

TEST(ReadAus, WeighsPartsAboveAndProducts) {
  Measures seen;
  left_of(seen, SideMeasure::CornerUp) = 0.1;    // -0.3 + 0.3 + 0.07
  right_of(seen, SideMeasure::CornerUp) = -0.1;  // 0.3 + 0 + 0.07
  const AuFrame frame = read_aus(weights(), seen, Measures{});
  EXPECT_NEAR(double{frame.left[15]}, 0.07, kTolerance);
  EXPECT_NEAR(double{frame.right[15]}, 0.37, kTolerance);
}

TEST(ReadAus, WhatOnlySeemsToMoveWhenTheHeadIsRaisedDoesNotCount) {
  auto read = parse_au_weights(
      "raised-side 0 0 0 0 0 0 0 0.1 0 0 0 0 0 0 0 0 0 0\n"
      "raised-middle 0 0 0 0 0 0 0 0 -0.3 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0\n" +
          kWeights,
      "weights.txt");
  ASSERT_TRUE(read.has_value()) << read.error().message;
  Measures neutral;
  neutral.turn.up_rad = -0.1;
  Measures seen;
  seen.turn.up_rad = 0.1;
  left_of(seen, SideMeasure::CornerUp) = 0.02;
  right_of(seen, SideMeasure::CornerUp) = 0.05;
  middle_of(seen, MiddleMeasure::ChinUp) = -0.06;
  const AuFrame frame = read_aus(*read, seen, neutral);
  EXPECT_NEAR(double{frame.left[12]}, 0, kTolerance);
  EXPECT_NEAR(double{frame.right[12]}, 0.3, kTolerance);
  EXPECT_NEAR(double{frame.left[26]}, 0, kTolerance);
  EXPECT_NEAR(double{frame.left[53]}, 0.8, kTolerance);
}

TEST(ReadAus, WhatPeopleDifferInWhenTheHeadTurnsDoesNotCount) {
  const std::string others(" 0 0 0 0 0 0 0");
  const std::string zeros(" 0 0 0 0 0 0 0 0 0 0");
  auto read =
      parse_au_weights("raised-doubt-side" + others + " 0.1" + zeros + "\nturned-doubt-side" +
                           others + " 0.2" + zeros + "\n" + kWeights,
                       "weights.txt");
  ASSERT_TRUE(read.has_value()) << read.error().message;
  const auto smiles = [&](double left, double right, HeadTurn turn) {
    Measures seen;
    seen.turn = turn;
    left_of(seen, SideMeasure::CornerUp) = left;
    right_of(seen, SideMeasure::CornerUp) = right;
    const AuFrame frame = read_aus(*read, seen, Measures{});
    return std::pair(double{frame.left[12]}, double{frame.right[12]});
  };
  const auto straight = smiles(0.03, 0.05, {});
  EXPECT_NEAR(straight.first, 0.3, kTolerance);
  EXPECT_NEAR(straight.second, 0.5, kTolerance);
  // 0.04 either way is doubted.
  for (const HeadTurn turn : {HeadTurn{0.1, -0.2, 0}, HeadTurn{-0.1, 0.2, 0.5}}) {
    const auto turned = smiles(0.03, 0.05, turn);
    EXPECT_NEAR(turned.first, 0, kTolerance);
    EXPECT_NEAR(turned.second, 0.1, kTolerance);
  }
}

TEST(AuWeights, MirroredFacesGiveMirroredInputs) {
  Measures seen;
  left_of(seen, SideMeasure::GazeLeft) = 0.3;
  right_of(seen, SideMeasure::GazeLeft) = 0.2;
  left_of(seen, SideMeasure::CornerUp) = 0.1;
  middle_of(seen, MiddleMeasure::MouthLeft) = 0.05;
  seen.turn.left_rad = 0.4;
  Measures mirrored;
  left_of(mirrored, SideMeasure::GazeLeft) = -0.2;
  right_of(mirrored, SideMeasure::GazeLeft) = -0.3;
  right_of(mirrored, SideMeasure::CornerUp) = 0.1;
  middle_of(mirrored, MiddleMeasure::MouthLeft) = -0.05;
  mirrored.turn.left_rad = -0.4;
  EXPECT_EQ(inputs_of(seen, Measures{}, true), inputs_of(mirrored, Measures{}, false));
  EXPECT_EQ(inputs_of(seen, Measures{}, false), inputs_of(mirrored, Measures{}, true));
}

TEST(AuWeights, SaysWhereAFileIsWrong) {
  const auto message = [](const std::string& text) {
    const auto read = parse_au_weights(text, "w.txt");
    EXPECT_FALSE(read.has_value());
    EXPECT_EQ(read.error().kind, ErrorKind::BadData);
    return read.error().message;
  };
  EXPECT_NE(message("").find("no weights"), std::string::npos);
  EXPECT_NE(message("# x\nwhat 1 2\n").find("w.txt:2:1"), std::string::npos);
  EXPECT_NE(message("neutral-side 1 2\n").find("18 numbers"), std::string::npos);
  EXPECT_NE(message("neutral-middle nan\n").find("29 numbers"), std::string::npos);
  EXPECT_NE(message("raised-side 1 2\n").find("18 numbers"), std::string::npos);
  EXPECT_NE(message("raised-middle 1 2\n").find("29 numbers"), std::string::npos);
  EXPECT_NE(message("feature nose\n").find("measure"), std::string::npos);
  EXPECT_NE(message("feature lip-gap times nose\n").find("measure"), std::string::npos);
  EXPECT_NE(message("feature lip-gap\nau 0 whole 0 0 1\n").find("AU from 1"), std::string::npos);
  EXPECT_NE(message("feature lip-gap\nau 12 both 0 0 1\n").find("sided"), std::string::npos);
  EXPECT_NE(message("feature lip-gap\nau 12 whole 0 0\n").find("a weight"), std::string::npos);
  EXPECT_NE(message("feature lip-gap\nau 12 whole 1 0 1\n").find("a weight"), std::string::npos);
  EXPECT_NE(message("feature lip-gap\nau 99 signed 0 0 1\n").find("opposite"), std::string::npos);
}

/// Somebody whose corners hang a little, who smiles most of the time and looks to the left.
std::vector<Measures> a_smiling_film() {
  std::vector<Measures> film;
  for (int picture = 0; picture < 100; ++picture) {
    Measures seen;
    const double smile = picture % 10 < 3 ? 0 : 0.06;
    left_of(seen, SideMeasure::CornerUp) = right_of(seen, SideMeasure::CornerUp) = smile - 0.02;
    seen.turn.left_rad = 0.25 + (picture % 2 == 0 ? 0.01 : -0.01);
    film.push_back(seen);
  }
  return film;
}

TEST(NeutralFace, IsThatOfTheWeakestAusWithTheHeadWhereItMostlyIs) {
  const auto film = a_smiling_film();
  const Measures neutral = find_neutral_face(film, weights());
  EXPECT_NEAR(left_of(neutral, SideMeasure::CornerUp), -0.02, kTolerance);
  EXPECT_NEAR(neutral.turn.left_rad, 0.25, 0.011);
  // The median of all is somebody who smiles.
  EXPECT_NEAR(left_of(median_face(film, weights()), SideMeasure::CornerUp), 0.04, kTolerance);
}

TEST(NeutralFace, HasTheBrowsOfTheWeakerHalf) {
  std::vector<Measures> film(100);
  for (std::size_t picture = 0; picture < film.size(); ++picture) {
    // For a fifth of the time brows are raised and nothing else shows; then somebody smiles.
    const bool raised = picture < film.size() / 5;
    left_of(film[picture], SideMeasure::BrowInnerUp) = raised ? 0.3 : 0.2;
    right_of(film[picture], SideMeasure::BrowInnerOut) = raised ? 0.1 : 0.08;
    middle_of(film[picture], MiddleMeasure::BrowGap) = raised ? 0.4 : 0.35;
    left_of(film[picture], SideMeasure::CornerUp) = raised ? 0.01 : 0.05;
  }
  Measures neutral = find_neutral_face(film, weights());
  EXPECT_NEAR(left_of(neutral, SideMeasure::CornerUp), 0.01, kTolerance);
  EXPECT_NEAR(left_of(neutral, SideMeasure::BrowInnerUp), 0.2, kTolerance);
  EXPECT_NEAR(right_of(neutral, SideMeasure::BrowInnerOut), 0.08, kTolerance);
  EXPECT_NEAR(middle_of(neutral, MiddleMeasure::BrowGap), 0.35, kTolerance);
}

TEST(NeutralFace, HasTheNodOfAllPictures) {
  std::vector<Measures> film(100);
  for (std::size_t picture = 0; picture < film.size(); ++picture) {
    const bool is_neutral = picture < film.size() / 4;
    middle_of(film[picture], MiddleMeasure::StillTipUp) = is_neutral ? -0.3 : -0.2;
    middle_of(film[picture], MiddleMeasure::ChinUp) = is_neutral ? 0 : -0.1;
  }
  Measures neutral = find_neutral_face(film, weights());
  EXPECT_NEAR(middle_of(neutral, MiddleMeasure::StillTipUp), -0.2, kTolerance);
  EXPECT_NEAR(middle_of(neutral, MiddleMeasure::ChinUp), 0, kTolerance);
}

TEST(NeutralFace, HasShutLipsAlsoOfSomebodyWhoKeepsThemParted) {
  std::vector<Measures> film(20);
  for (Measures& seen : film) {
    middle_of(seen, MiddleMeasure::LipGap) = 0.06;
    middle_of(seen, MiddleMeasure::LipsHeight) = 0.3;
    middle_of(seen, MiddleMeasure::LowerLipUp) = -0.9;
  }
  Measures neutral = find_neutral_face(film, weights());
  EXPECT_NEAR(middle_of(neutral, MiddleMeasure::LipGap), 0, kTolerance);
  EXPECT_NEAR(middle_of(neutral, MiddleMeasure::LipsHeight), 0.24, kTolerance);
  EXPECT_NEAR(middle_of(neutral, MiddleMeasure::LowerLipUp), -0.84, kTolerance);
}

TEST(NeutralFace, OfNobodyIsTheTypicalOne) {
  AuWeights typical = weights();
  typical.typical.left[0] = 0.3;
  EXPECT_EQ(find_neutral_face({}, typical).left[0], 0.3);
  EXPECT_EQ(median_face({}, typical).left[0], 0.3);
}

/// Eyes of somebody usual: 0.3 wide, and 0.12 of that is seen of them.
AuWeights with_usual_eyes() {
  AuWeights usual = weights();
  for (auto* side : {&usual.typical.left, &usual.typical.right}) {
    (*side)[static_cast<std::size_t>(SideMeasure::Aperture)] = 0.4;
    (*side)[static_cast<std::size_t>(SideMeasure::UpperLidUp)] = 0.1;
    (*side)[static_cast<std::size_t>(SideMeasure::LowerLidUp)] = -0.02;
  }
  return usual;
}

TEST(NeutralFace, RaisesLidsThatWereNeverSeenRaised) {
  const AuWeights usual = with_usual_eyes();
  Measures seen = usual.typical;
  left_of(seen, SideMeasure::Aperture) = 0.05;
  left_of(seen, SideMeasure::UpperLidUp) = -0.005;
  right_of(seen, SideMeasure::Aperture) = 0.25;
  Measures neutral = find_neutral_face(std::vector<Measures>(20, seen), usual);
  EXPECT_NEAR(left_of(neutral, SideMeasure::Aperture), 0.24, kTolerance);
  EXPECT_NEAR(left_of(neutral, SideMeasure::UpperLidUp), 0.052, kTolerance)
      << "0.19 of 0.3 was missing";
  EXPECT_NEAR(right_of(neutral, SideMeasure::Aperture), 0.25, kTolerance) << "narrow eyes stay so";
}

TEST(NeutralFace, IsRatherALaughThanLoweredLids) {
  const AuWeights usual = with_usual_eyes();
  Measures shut = usual.typical;
  left_of(shut, SideMeasure::Aperture) = right_of(shut, SideMeasure::Aperture) = 0.22;
  Measures laugh = usual.typical;
  left_of(laugh, SideMeasure::CornerUp) = right_of(laugh, SideMeasure::CornerUp) = 0.1;
  middle_of(laugh, MiddleMeasure::ChinUp) = -0.2;
  std::vector<Measures> film(70, shut);
  film.insert(film.end(), 30, laugh);
  const Measures neutral = find_neutral_face(film, usual);
  EXPECT_NEAR(left_of(neutral, SideMeasure::Aperture), 0.4, kTolerance);
}

TEST(NeutralFace, IsFoundWhileSomebodyIsWatched) {
  const AuWeights known = weights();
  RunningNeutralFace running(known);
  const auto film = a_smiling_film();
  EXPECT_EQ(left_of(running.watch(0, film[0]), SideMeasure::CornerUp), -0.02);
  double last = 0;
  for (std::size_t picture = 1; picture < film.size(); ++picture) {
    last = left_of(running.watch(0.04 * static_cast<double>(picture), film[picture]),
                   SideMeasure::CornerUp);
  }
  EXPECT_NEAR(last, -0.02, 0.01);
}

}  // namespace
}  // namespace aucast::mesh

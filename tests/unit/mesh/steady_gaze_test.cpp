#include "common/mesh/steady_gaze.h"

#include <gtest/gtest.h>

#include <vector>

namespace aucast::mesh {
namespace {

constexpr auto kGaze = std::size_t(SideMeasure::GazeLeft);
constexpr double kGazeTolerance = 1e-9;

/// A face whose eyes look there, by the subject's left; its corners are as high.
Measures looking(double left_eye, double right_eye) {
  Measures face;
  face.left[kGaze] = left_eye;
  face.right[kGaze] = right_eye;
  face.left[std::size_t(SideMeasure::CornerUp)] = left_eye;
  for (auto* side : {&face.left, &face.right}) {
    (*side)[std::size_t(SideMeasure::Aperture)] = 0.4;
  }
  return face;
}

void expect_left_eyes(const std::vector<Measures>& film, const std::vector<double>& gazes) {
  ASSERT_EQ(film.size(), gazes.size());
  for (std::size_t index = 0; index < film.size(); ++index) {
    EXPECT_NEAR(film[index].left[kGaze], gazes[index], kGazeTolerance) << index;
  }
}

const std::vector<Measures> kFilm{looking(0.1, 0.2), looking(0.9, 0.2), looking(0.1, 0.2),
                                  looking(0.1, 0.6), looking(0.5, 0.8), looking(0.5, 0.9)};

TEST(SteadyGaze, IsTheMeanOfAPictureAndItsNeighboursInAFilm) {
  std::vector<Measures> film = kFilm;
  steady_gaze(film);
  expect_left_eyes(film, {0.1, 0.5, 0.3, 0.2, 0.4, 0.5});
  EXPECT_NEAR(film[3].right[kGaze], 0.55, kGazeTolerance);
  EXPECT_EQ(film[1].left[std::size_t(SideMeasure::CornerUp)], 0.9) << "nothing else is changed";
}

TEST(SteadyGaze, AnEyeThatIsShutDoesNotSayWhereItLooks) {
  std::vector<Measures> film{looking(0.2, 0.2), looking(0.9, 0.4), looking(0.2, 0.2)};
  film[1].left[std::size_t(SideMeasure::Aperture)] = -0.01;
  steady_gaze(film);
  EXPECT_NEAR(film[1].left[kGaze], 0.2, 0.02);
  EXPECT_NEAR(film[1].right[kGaze], 0.3, kGazeTolerance) << "the other one is open";
}

TEST(SteadyGaze, OfEyesThatStayShutIsANumber) {
  std::vector<Measures> film(3, looking(0.2, 0.2));
  for (Measures& face : film) face.left[std::size_t(SideMeasure::Aperture)] = 0;
  steady_gaze(film);
  EXPECT_NEAR(film[1].left[kGaze], 0.2, kGazeTolerance);
}

TEST(SteadyGaze, OfSomebodyWhoIsWatchedIsOnePictureLate) {
  RunningSteadyGaze running;
  std::vector<Measures> film;
  for (const Measures& face : kFilm) film.push_back(running.watch(face));
  expect_left_eyes(film, {0.1, 0.9, 0.5, 0.3, 0.2, 0.4});
  EXPECT_NEAR(film[4].right[kGaze], 0.55, kGazeTolerance);
  EXPECT_EQ(film[4].left[std::size_t(SideMeasure::CornerUp)], 0.5);
}

TEST(SteadyGaze, OfAShortFilmIsWhatWasSeen) {
  std::vector<Measures> film{looking(0.1, 0), looking(0.9, 0)};
  steady_gaze(film);
  expect_left_eyes(film, {0.1, 0.9});
}

}  // namespace
}  // namespace aucast::mesh

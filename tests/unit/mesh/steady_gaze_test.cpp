#include "common/mesh/steady_gaze.h"

#include <gtest/gtest.h>

#include <vector>

namespace aucast::mesh {
namespace {

constexpr auto kGaze = std::size_t(SideMeasure::GazeLeft);

/// A face whose eyes look there, by the subject's left; its corners are as high.
Measures looking(double left_eye, double right_eye) {
  Measures face;
  face.left[kGaze] = left_eye;
  face.right[kGaze] = right_eye;
  face.left[std::size_t(SideMeasure::CornerUp)] = left_eye;
  return face;
}

std::vector<double> left_eyes(const std::vector<Measures>& film) {
  std::vector<double> gazes;
  for (const Measures& face : film) gazes.push_back(face.left[kGaze]);
  return gazes;
}

const std::vector<Measures> kFilm{looking(0.1, 0.2), looking(0.9, 0.2), looking(0.1, 0.2),
                                  looking(0.1, 0.7), looking(0.5, 0.8), looking(0.5, 0.9)};

TEST(SteadyGaze, OnePictureIsNoGlanceAndAGlanceComesAtOnceInAFilm) {
  std::vector<Measures> film = kFilm;
  steady_gaze(film);
  EXPECT_EQ(left_eyes(film), (std::vector<double>{0.1, 0.1, 0.1, 0.1, 0.5, 0.5}));
  EXPECT_EQ(film[3].right[kGaze], 0.7);
  EXPECT_EQ(film[1].left[std::size_t(SideMeasure::CornerUp)], 0.9) << "nothing else is changed";
}

TEST(SteadyGaze, OfSomebodyWhoIsWatchedIsOnePictureLate) {
  RunningSteadyGaze running;
  std::vector<Measures> film;
  for (const Measures& face : kFilm) film.push_back(running.watch(face));
  EXPECT_EQ(left_eyes(film), (std::vector<double>{0.1, 0.9, 0.1, 0.1, 0.1, 0.5}));
  EXPECT_EQ(film[5].right[kGaze], 0.8);
  EXPECT_EQ(film[4].left[std::size_t(SideMeasure::CornerUp)], 0.5);
}

TEST(SteadyGaze, OfAShortFilmIsWhatWasSeen) {
  std::vector<Measures> film{looking(0.1, 0), looking(0.9, 0)};
  steady_gaze(film);
  EXPECT_EQ(left_eyes(film), (std::vector<double>{0.1, 0.9}));
}

}  // namespace
}  // namespace aucast::mesh

// What needs the models of scripts/install_models.sh says so when they are not there.
#include "common/camera/film_reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <stop_token>
#include <string>
#include <thread>

#include "common/camera/picture_source.h"
#include "common/files.h"
#include "tests/unit/camera/other_ffmpeg.h"

namespace aucast::camera {
namespace {

TEST(FilmReader, EachFaceOfAPictureHasItsNumberAndTheClearestIsOneOfThem) {
  if (!load_face_models()) GTEST_SKIP() << "NOT RUN: the models are not installed";
  const auto data = find_data_folder({});
  ASSERT_TRUE(data.has_value());
  const auto picture = *data / "pictures" / "six_expressions_marek.png";
  const auto all = read_film(picture, FaceOptions{.several = true});
  ASSERT_TRUE(all.has_value()) << all.error().message;
  EXPECT_EQ(all->faces, 1U) << "pictures with faces";
  for (const char* number : {"0", "1", "2", "3", "4", "5"}) {
    EXPECT_NE(all->text.find(std::string(",1,") + number + ","), std::string::npos) << number;
  }
  EXPECT_EQ(std::count(all->text.begin(), all->text.end(), '\n'), 1 + 6);
  const auto one = read_film(picture, {});
  ASSERT_TRUE(one.has_value()) << one.error().message;
  EXPECT_EQ(std::count(one->text.begin(), one->text.end(), '\n'), 1 + 1);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(read_film(picture, {}, {}, stop.get_token()));
}

TEST(FilmReader, StopsAlsoWhenFfmpegOrFfprobeHangs) {
  if (!load_face_models()) GTEST_SKIP() << "NOT RUN: the models are not installed";
  OtherFfmpeg ffmpeg("sleep 60");
  const std::filesystem::path film = ffmpeg.file("film.mp4", "x");
  std::stop_source stop;
  const std::jthread stopper([&stop] {
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    stop.request_stop();
  });
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_FALSE(read_film(film, {}, {}, stop.get_token()));
  std::filesystem::copy(film.parent_path() / "ffmpeg", film.parent_path() / "ffprobe");
  EXPECT_FALSE(film_seconds(film, [&stop] { return stop.stop_requested(); }));
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(30));
}

}  // namespace
}  // namespace aucast::camera

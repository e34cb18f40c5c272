// With programs of our own in the place of ffmpeg.
#include "common/camera/picture_source.h"

#include <sys/stat.h>

#include <chrono>
#include <string>
#include <vector>

#include "tests/unit/camera/other_ffmpeg.h"

namespace aucast::camera {
namespace {

TEST(PictureSource, GivesWhatFfmpegDecodes) {
  OtherFfmpeg ffmpeg("printf 'YUV4MPEG2 W2 H1 F25:1 C444\\nFRAME\\nAABBCC'");
  auto source = PictureSource::open_film(ffmpeg.file("film.mp4", "x"));
  ASSERT_TRUE(source.has_value()) << source.error().message;
  std::vector<std::uint8_t> rgb;
  EXPECT_TRUE(source->next(rgb));
  EXPECT_EQ(rgb.size(), 6U);
  EXPECT_FALSE(source->next(rgb));
  EXPECT_EQ(source->complaint(), "");
}

TEST(PictureSource, SaysThatAFilmBreaksOff) {
  std::vector<std::uint8_t> rgb;
  const auto complaint_of = [&rgb](const std::string& script) {
    OtherFfmpeg ffmpeg("printf 'YUV4MPEG2 W2 H1 F25:1 C444\\nFRAME\\nAABBCC'; " + script);
    auto source = PictureSource::open_film(ffmpeg.file("film.mp4", "x"));
    EXPECT_TRUE(source.has_value());
    int pictures = 0;
    while (source->next(rgb)) ++pictures;
    EXPECT_EQ(pictures, 1);
    return source->film_complaint();
  };
  EXPECT_EQ(complaint_of(":"), "");
  EXPECT_EQ(complaint_of("printf 'FRAME\\nAAB'"), "the last picture is cut off");
  EXPECT_EQ(complaint_of("echo 'File ended prematurely' >&2"), "File ended prematurely");
  EXPECT_EQ(complaint_of("echo 'Invalid data found' >&2; exit 1"), "Invalid data found");
  EXPECT_EQ(complaint_of("printf '[mov @ 0x5] partial file\\n[mov @ 0x5] partial file\\n' >&2"),
            "partial file");
}

TEST(PictureSource, SaysInFfmpegsWordsWhyThereAreNoPictures) {
  OtherFfmpeg ffmpeg("echo 'moov atom not found' >&2; exit 1");
  const auto film = PictureSource::open_film(ffmpeg.file("film.mp4", "x"));
  ASSERT_FALSE(film.has_value());
  EXPECT_EQ(film.error().kind, ErrorKind::BadData);
  EXPECT_NE(film.error().message.find("film.mp4"), std::string::npos);
  EXPECT_NE(film.error().message.find("moov atom not found"), std::string::npos);
  const auto none = PictureSource::open_film("/no/such/film.mp4");
  ASSERT_FALSE(none.has_value());
  EXPECT_EQ(none.error().kind, ErrorKind::Unreadable);
  const auto camera = PictureSource::open_camera({.device = kDevice});
  ASSERT_FALSE(camera.has_value());
  EXPECT_EQ(camera.error().kind, ErrorKind::Failed);
  EXPECT_NE(camera.error().message.find("/dev/null"), std::string::npos);
}

TEST(PictureSource, SaysThatThereIsNoSuchCamera) {
  OtherFfmpeg ffmpeg("echo '[video4linux2,v4l2 @ 0x55d0] Cannot open' >&2; exit 1");
  const auto missing = PictureSource::open_camera({.device = "/dev/no_video"});
  ASSERT_FALSE(missing.has_value());
  EXPECT_EQ(missing.error().kind, ErrorKind::Failed);
  EXPECT_NE(missing.error().message.find("/dev/no_video: there is no such camera"),
            std::string::npos)
      << missing.error().message;
  const auto film = PictureSource::open_camera({.device = "missing.mp4"});
  ASSERT_FALSE(film.has_value());
  EXPECT_EQ(film.error().kind, ErrorKind::Unreadable);
  EXPECT_EQ(film.error().message,
            "missing.mp4: cannot be read: No such file or directory; check the name");
  const auto broken = PictureSource::open_camera({.device = kDevice});
  ASSERT_FALSE(broken.has_value());
  EXPECT_NE(broken.error().message.find("ffmpeg says: Cannot open"), std::string::npos)
      << broken.error().message;
}

TEST(PictureSource, AsksACameraForSizeAndRate) {
  OtherFfmpeg ffmpeg("echo \"$@\" >&2; exit 1");
  const auto camera = PictureSource::open_camera({kDevice, 1280, 720, 25});
  ASSERT_FALSE(camera.has_value());
  EXPECT_NE(camera.error().message.find("-video_size 1280x720 -framerate 25 -i /dev/null"),
            std::string::npos)
      << camera.error().message;
}

TEST(PictureSource, ACameraThatShowsNothingIsNotAwaitedForEver) {
  OtherFfmpeg ffmpeg("exec sleep 60");
  const auto camera = PictureSource::open_camera({.device = kDevice, .patience = Milliseconds{50}});
  ASSERT_FALSE(camera.has_value());
  EXPECT_EQ(camera.error().kind, ErrorKind::Failed);
  EXPECT_NE(camera.error().message.find("/dev/null: no picture came for"), std::string::npos)
      << camera.error().message;
}

TEST(PictureSource, ACameraThatIsGivenUpIsAwaitedNoLonger) {
  OtherFfmpeg ffmpeg("exec sleep 60");
  int asked = 0;
  const auto camera =
      PictureSource::open_camera({.device = kDevice}, [&asked] { return ++asked == 3; });
  EXPECT_FALSE(camera.has_value());
  EXPECT_EQ(asked, 3);
}

TEST(PictureSource, AFilmThatIsGivenUpIsAwaitedNoLonger) {
  for (const char* script : {"sleep 60", "printf 'YUV4MPEG2 W2 H1 F25:1 C444\nFRA'; sleep 60"}) {
    OtherFfmpeg ffmpeg(script);
    const auto film = ffmpeg.file("film.mp4", "x");
    int asked = 0;
    const auto begin = std::chrono::steady_clock::now();
    auto source = PictureSource::open_film(film, [&asked] { return ++asked > 40; });
    std::vector<std::uint8_t> rgb;
    EXPECT_FALSE(source && source->next(rgb));
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(30)) << script;
  }
}

TEST(PictureSource, AnFfmpegThatDoesNotEndIsAwaitedNoLonger) {
  OtherFfmpeg ffmpeg("echo 'it hangs' >&2; exec >&-; sleep 60");
  const auto begin = std::chrono::steady_clock::now();
  const auto film = PictureSource::open_film(ffmpeg.file("film.mp4", "x"));
  ASSERT_FALSE(film.has_value());
  EXPECT_NE(film.error().message.find("ffmpeg says: it hangs"), std::string::npos)
      << film.error().message;
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(30));
}

TEST(PictureSource, AFilmOrAFifoStandsInForACamera) {
  OtherFfmpeg ffmpeg("echo \"$@\" >&2; exit 1");
  const std::string film = ffmpeg.file("film.mp4", "x");
  auto camera = PictureSource::open_camera({.device = film});
  ASSERT_FALSE(camera.has_value());
  EXPECT_NE(camera.error().message.find("-re -i file:" + film), std::string::npos)
      << camera.error().message;
  const std::string fifo = film + ".fifo";
  ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
  camera = PictureSource::open_camera({.device = fifo});
  ASSERT_FALSE(camera.has_value());
  EXPECT_NE(camera.error().message.find("buffer -i file:" + fifo), std::string::npos)
      << camera.error().message;
}

}  // namespace
}  // namespace aucast::camera

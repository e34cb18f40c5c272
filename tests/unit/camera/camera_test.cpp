// Films and cameras, with programs of our own in the place of ffmpeg; what needs the models of
// scripts/install_models.sh says so when they are not there.
#include <gtest/gtest.h>

#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

#include "common/camera/camera_feed.h"
#include "common/camera/face_table.h"
#include "common/camera/film_reader.h"
#include "common/camera/y4m.h"
#include "common/files.h"
#include "common/sources/recording.h"
#include "tests/support/read_recording.h"
#include "tests/support/temp_folder.h"

namespace aucast::camera {
namespace {

/// Something that is there and no file: what ffmpeg is made to say stands in for a camera.
constexpr const char* kDevice = "/dev/null";

using test::TempFolder;

Y4mReader::Read reads(std::string text, std::size_t at_once = 1000) {
  return [text = std::move(text), at_once](std::span<std::uint8_t> bytes) mutable {
    const std::size_t count = std::min({bytes.size(), text.size(), at_once});
    std::memcpy(bytes.data(), text.data(), count);
    text.erase(0, count);
    return count;
  };
}

const std::string kHead = "YUV4MPEG2 W2 H1 F30000:1001 Ip A1:1 C444 XYSCSS=444\n";
/// Black and white, then red twice.
const std::string kPictures = std::string("FRAME\n\x10\xeb\x80\x80\x80\x80", 12) +
                              std::string("FRAME\n\x51\x51\x5a\x5a\xf0\xf0", 12);

TEST(Y4m, PicturesComeAsRgb) {
  for (const std::size_t at_once : {1000U, 1U}) {
    auto reader = Y4mReader::open(reads(kHead + kPictures, at_once));
    ASSERT_TRUE(reader.has_value());
    ASSERT_TRUE(reader->has_value());
    Y4mReader& pictures = **reader;
    EXPECT_EQ(pictures.width(), 2U);
    EXPECT_EQ(pictures.height(), 1U);
    EXPECT_NEAR(pictures.fps(), 29.97, 0.001);
    std::vector<std::uint8_t> rgb;
    ASSERT_TRUE(pictures.next(rgb));
    EXPECT_EQ(rgb, (std::vector<std::uint8_t>{0, 0, 0, 255, 255, 255}));
    ASSERT_TRUE(pictures.next(rgb));
    EXPECT_NEAR(rgb[0], 255, 2);
    EXPECT_NEAR(rgb[1], 0, 2);
    EXPECT_NEAR(rgb[2], 0, 2);
    EXPECT_FALSE(pictures.next(rgb));
  }
}

TEST(Y4m, APictureThatIsCutOffIsNone) {
  auto reader = Y4mReader::open(reads(kHead + kPictures.substr(0, 20)));
  ASSERT_TRUE(reader.has_value() && reader->has_value());
  std::vector<std::uint8_t> rgb;
  EXPECT_TRUE((*reader)->next(rgb));
  EXPECT_FALSE((*reader)->torn());
  EXPECT_FALSE((*reader)->next(rgb));
  EXPECT_TRUE((*reader)->torn());
}

TEST(Y4m, OtherThingsAreRefused) {
  for (const std::string head :
       {"hello\n", "YUV4MPEG2 W0 H1 F25:1 C444\n", "YUV4MPEG2 W2 H99999 F25:1 C444\n",
        "YUV4MPEG2 W2 H1 F0:1 C444\n", "YUV4MPEG2 W2 H1 F25:1 C420\n", "YUV4MPEG2 W2 H1 C444\n"}) {
    const auto reader = Y4mReader::open(reads(head));
    ASSERT_FALSE(reader.has_value()) << head;
    EXPECT_EQ(reader.error().kind, ErrorKind::BadData);
  }
  const auto nothing = Y4mReader::open(reads(""));
  ASSERT_TRUE(nothing.has_value());
  EXPECT_FALSE(nothing->has_value());
}

mesh::AuWeights some_weights() {
  auto weights = mesh::parse_au_weights(
      "feature lip-gap\nau 12 sided 0 0 1\nau 26 whole 0 0 1\nau 51 turning 0 0 1\n", "w");
  return std::move(*weights);
}

TEST(FaceTable, IsReadBackWithSidesTurnsAndLostFaces) {
  const FaceTable table(some_weights());
  EXPECT_EQ(table.header(), "aucast_seconds,confidence,success,L12,R12,26,51,52\n");
  AuFrame face;
  face.left[12] = 0.25F;
  face.right[12] = 0.75F;
  face.left[26] = face.right[26] = 0.5F;
  face.left[52] = face.right[52] = 1.5F;
  std::string text = table.header();
  text += table.row(0, 0.99, face);
  text += table.row(0.04, 0.99, face);
  text += table.row(0.08, 0, std::nullopt);
  EXPECT_NE(text.find("0.0800,0.000,0,,,,,\n"), std::string::npos);
  const auto recording = sources::read_recording(text, "film.mp4", {});
  ASSERT_TRUE(recording.has_value()) << recording.error().message;
  EXPECT_EQ(recording->found.format, "camera");
  EXPECT_EQ(recording->found.lost, 1U);
  ASSERT_GE(recording->stream.keyframes.size(), 2U);
  const std::vector<AuTerm> expected{
      {12, Side::Left, 25}, {12, Side::Right, 75}, {26, Side::Both, 50}, {52, Side::Both, 100}};
  EXPECT_EQ(recording->stream.keyframes[0].terms, expected);
}

TEST(FaceTable, OfSeveralFacesIsReadFaceByFace) {
  const FaceTable table(some_weights(), true);
  EXPECT_EQ(table.header(), "aucast_seconds,confidence,success,face_id,L12,R12,26,51,52\n");
  AuFrame face;
  std::string text = table.header();
  for (int picture = 0; picture < 3; ++picture) {
    for (const std::size_t number : {0U, 1U}) {
      face.left[26] = face.right[26] = number == 0 ? 0.25F : 0.75F;
      if (picture > 0 || number == 1) text += table.row(0.04 * picture, 0.9, face, number);
    }
  }
  sources::RecordingOptions options;
  for (const auto& [asked, percent] : {std::pair(0, 25), std::pair(1, 75)}) {
    options.face = asked;
    const auto recording = sources::read_recording(text, "film.mp4", options);
    ASSERT_TRUE(recording.has_value()) << recording.error().message;
    EXPECT_EQ(recording->stream.keyframes.back().terms.front().percent, percent);
  }
  const auto most = sources::read_recording(text, "film.mp4", {});
  ASSERT_TRUE(most.has_value());
  EXPECT_EQ(most->stream.keyframes.back().terms.front().percent, 75) << "the more frequent one";
}

TEST(FaceTable, HasATermForEachColumnAlsoOfAbsentAus) {
  const FaceTable table(some_weights());
  AuFrame face;
  face.left[12] = 0.25F;
  face.left[52] = face.right[52] = 1.5F;
  const std::vector<AuTerm> expected{{12, Side::Left, 25},
                                     {12, Side::Right, 0},
                                     {26, Side::Both, 0},
                                     {51, Side::Both, 0},
                                     {52, Side::Both, 100}};
  EXPECT_EQ(table.terms(face), expected);
}

TEST(FaceModels, SayWhatToDoWhenTheyAreNotThere) {
  const TempFolder folder;
  const auto models = load_face_models(folder.path());
  ASSERT_FALSE(models.has_value());
  EXPECT_EQ(models.error().kind, ErrorKind::Unreadable);
  const std::string where = folder.path().string();
  EXPECT_NE(models.error().message.find("'scripts/install_models.sh " + where), std::string::npos);
  // Where it is installed, nobody has a checkout.
  folder.write("scripts/install_models.sh", "");
  EXPECT_NE(load_face_models(folder.path())
                .error()
                .message.find("'" + where + "/scripts/install_models.sh " + where),
            std::string::npos);
}

TEST(FaceModels, ThatAreNoneAreBadData) {
  const TempFolder folder;
  std::filesystem::create_directory(folder.path() / "models");
  std::filesystem::create_directory(folder.path() / "camera");
  for (const char* name :
       {"face_detection_short_range.tflite", "face_landmark_with_attention.tflite"}) {
    ASSERT_TRUE(write_file_atomically(folder.path() / "models" / name, "not a model at all"));
  }
  ASSERT_TRUE(write_file_atomically(folder.path() / "camera" / "action_units.txt",
                                    "feature lip-gap\nau 12 sided 0 0 1\n"));
  const auto models = load_face_models(folder.path());
  ASSERT_FALSE(models.has_value());
  EXPECT_EQ(models.error().kind, ErrorKind::BadData);
}

/// A program `ffmpeg` of our own, first in $PATH for as long as this lives.
class OtherFfmpeg {
 public:
  explicit OtherFfmpeg(const std::string& script) : path_(std::getenv("PATH")) {
    const auto file = folder_.path() / "ffmpeg";
    EXPECT_TRUE(write_file_atomically(file, "#!/bin/sh\n" + script).has_value());
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
    ::setenv("PATH", (folder_.path().string() + ":" + path_).c_str(), 1);
  }
  ~OtherFfmpeg() { ::setenv("PATH", path_.c_str(), 1); }
  OtherFfmpeg(const OtherFfmpeg&) = delete;
  OtherFfmpeg& operator=(const OtherFfmpeg&) = delete;

  [[nodiscard]] std::filesystem::path file(const std::string& name, const std::string& text) {
    return folder_.write(name, text);
  }

 private:
  TempFolder folder_;
  std::string path_;
};

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

/// Whether the models are installed beside the programs.
bool models_are_there() {
  return load_face_models().has_value();
}

TEST(Films, EachFaceOfAPictureHasItsNumberAndTheClearestIsOneOfThem) {
  if (!models_are_there()) GTEST_SKIP() << "NOT RUN: the models are not installed";
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

TEST(CameraFeed, PicturesWithoutAFaceAreRowsWithoutSuccess) {
  if (!models_are_there()) GTEST_SKIP() << "NOT RUN: the models are not installed";
  OtherFfmpeg ffmpeg(
      "printf 'YUV4MPEG2 W16 H16 F25:1 C444\\n'; printf 'FRAME\\n'; head -c 768 /dev/zero");
  std::vector<std::size_t> widths;  // by the other thread, as long as it lives
  auto feed = CameraFeed::start({.device = kDevice}, {}, [&widths](const Sight& sight) {
    EXPECT_EQ(sight.landmarks, nullptr);
    EXPECT_TRUE(sight.aus.empty());
    widths.push_back(sight.picture.width);
  });
  ASSERT_TRUE(feed.has_value()) << feed.error().message;
  const int rows = (*feed)->take_rows();
  std::string text;
  std::vector<char> chunk(4096);
  for (;;) {
    pollfd wait{rows, POLLIN, 0};
    ASSERT_EQ(::poll(&wait, 1, 30'000), 1);
    const ssize_t got = ::read(rows, chunk.data(), chunk.size());
    if (got <= 0) break;
    text.append(chunk.data(), static_cast<std::size_t>(got));
  }
  ::close(rows);
  EXPECT_TRUE(text.starts_with("aucast_seconds,"));
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2);
  EXPECT_NE(text.find(",0.000,0,"), std::string::npos);
  EXPECT_EQ((*feed)->complaint(), "");
  feed->reset();
  EXPECT_EQ(widths, std::vector<std::size_t>{16});
}

TEST(CameraFeed, EndsAtOnceWhileItsCameraGoesOn) {
  if (!models_are_there()) GTEST_SKIP() << "NOT RUN: the models are not installed";
  OtherFfmpeg ffmpeg(
      "printf 'YUV4MPEG2 W16 H16 F25:1 C444\\n'; while :; do printf 'FRAME\\n'; head -c 768 "
      "/dev/zero; done");
  auto feed = CameraFeed::start({.device = kDevice}, {});
  ASSERT_TRUE(feed.has_value()) << feed.error().message;
  feed->reset();
}

}  // namespace
}  // namespace aucast::camera

// The options that say how sources are read, and `convert`.
#include <algorithm>

#include <gtest/gtest.h>

#include "common/files.h"
#include "common/text.h"
#include "server/settings/source_options.h"
#include "server/streams/check_report.h"
#include "server/streams/convert_command.h"
#include "server/streams/load_sources.h"
#include "server/streams/source_path.h"
#include "tests/support/temp_folder.h"
#include "tests/unit/sources/tables.h"

namespace aucast::server {
namespace {

using test::TempFolder;

Result<SourceOptions> read_source(const TypedWords& words) {
  SourceOptions options;
  const auto rows = recording_rows(options);
  if (auto done = read_words(rows, words); !done) return done.error();
  return options;
}

std::string source_message(const std::string& name, const std::string& word) {
  const auto options = read_source({{name, {word}}});
  if (options) return "accepted";
  EXPECT_EQ(options.error().kind, ErrorKind::Usage);
  return options.error().message;
}

TEST(SourceOptions, AreRead) {
  EXPECT_EQ(*read_source({}), SourceOptions());
  const auto all = read_source({{"fps", {"29.97"}},
                                {"au-scale", {"100"}},
                                {"face-id", {"-3"}},
                                {"min-confidence", {"0.8"}},
                                {"rate", {"12.5"}}});
  ASSERT_TRUE(all);
  EXPECT_EQ(all->recording.fps, 29.97);
  EXPECT_EQ(all->recording.au_scale, 100);
  EXPECT_EQ(all->recording.face, -3);
  EXPECT_EQ(all->recording.confidence_min, 0.8);
  EXPECT_EQ(all->rate, 12.5);
  EXPECT_FALSE(read_source({{"au-scale", {"auto"}}})->recording.au_scale);
}

TEST(SourceOptions, WrongWordsAreNamedWithTheirRange) {
  const std::string fps =
      " is not a number of pictures a second above 0, at most 1000 (try --help)";
  EXPECT_EQ(source_message("fps", "0"), "--fps '0'" + fps);
  EXPECT_EQ(source_message("fps", "nan"), "--fps 'nan'" + fps);
  EXPECT_EQ(source_message("fps", "30fps"), "--fps '30fps'" + fps);
  EXPECT_EQ(source_message("au-scale", "7"),
            "--au-scale '7' is not one of 1, 5, 100 and auto (try --help)");
  EXPECT_EQ(source_message("face-id", "a"),
            "--face-id 'a' is neither a whole number nor all (try --help)");
  EXPECT_EQ(source_message("min-confidence", "50"),
            "--min-confidence '50' is not a number from 0 to 1 (try --help)");
  EXPECT_EQ(source_message("rate", "0.01"),
            "--rate '0.01' is not a number of keyframes a second from 0.1 to 1000 (try --help)");
}

TEST(LoadSources, TellsRecordingsByTheirContentAndNotByTheirName) {
  const TempFolder folder;
  const auto sources = load_sources({folder.write("a.txt", sources::tables::kOpenFace1),
                                     folder.write("b.csv", "Beg_Stream\n1,2\nEnd_Stream\n"),
                                     folder.write("c", sources::tables::kLiveLinkFace)});
  ASSERT_TRUE(sources) << sources.error().message;
  EXPECT_TRUE(sources->at(0).found);
  EXPECT_FALSE(sources->at(1).found);
  ASSERT_TRUE(sources->at(2).found);
  EXPECT_EQ(sources->at(2).found->format, "Live Link Face");
  const std::string report = check_report(sources->at(0), 250);
  EXPECT_NE(report.find("  format      OpenFace 1\n"), std::string::npos) << report;
}

TEST(LoadSources, UnknownTablesAreRefusedAsTables) {
  const TempFolder folder;
  const auto sources = load_sources({folder.write("a.csv", "time,joy,anger\n1,2,3\n")});
  ASSERT_FALSE(sources);
  EXPECT_EQ(sources.error().kind, ErrorKind::BadData);
  EXPECT_NE(sources.error().message.find("a.csv:1:1: a table whose columns are of no recogniser"),
            std::string::npos);
}

TEST(LoadSources, AllFacesAreStreamsNamedAfterThem) {
  const TempFolder folder;
  const auto both = folder.write("two.csv",
                                 "frame,face_id,timestamp,confidence,success,AU12_r\n"
                                 "1,4,0,1,1,1\n2,4,0.1,1,1,1\n2,-1,0.1,1,1,2\n2,9,0.1,1,1,2\n"
                                 "3,9,0.2,1,1,2\n3,4,0.2,1,1,2\n");
  const auto plain = folder.write("talk.txt", "Beg_Stream\n1\nEnd_Stream\n");
  SourceOptions options;
  options.recording.all_faces = true;
  const auto sources = load_sources({both, plain}, options);
  ASSERT_TRUE(sources) << sources.error().message;
  std::vector<std::string> names;
  for (const Source& source : *sources) names.push_back(source.name);
  EXPECT_EQ(names, (std::vector<std::string>{"two-4", "two-9", "two--1", "talk"}));
  const auto taken = folder.write("two-9.txt", "Beg_Stream\n1\nEnd_Stream\n");
  EXPECT_EQ(load_sources({both, taken}, options).error().kind, ErrorKind::Usage);
}

TEST(LoadSources, RateIsForStreamFilesToo) {
  const TempFolder folder;
  SourceOptions options;
  options.rate = 20;
  const auto sources =
      load_sources({folder.write("a.txt", "Beg_Stream\n1\nEnd_Stream\n")}, options, {100});
  ASSERT_TRUE(sources);
  ASSERT_EQ(sources->at(0).summary.keyframes, 2U);
  EXPECT_EQ(sources->at(0).stream->times[0], protocol::KeyframeTime(50));
}

TEST(Convert, WritesARecordingAsAStreamFile) {
  const TempFolder folder;
  const auto in = folder.write("in.csv", sources::tables::kOpenFace1);
  const auto converted = run_convert({in.string(), (folder.path() / "out.txt").string()});
  ASSERT_TRUE(converted) << converted.error().message;
  EXPECT_EQ(folder.read("out.txt"), "Beg_Stream\n1:50,28:50,61:20;40\n45;40\nEnd_Stream\n");
  EXPECT_EQ(converted->text, "");
  EXPECT_EQ(converted->said,
            in.string() + ": OpenFace 1, AU scale 0-5, largest 5.00; 2 keyframes, 80 ms\n");
}

TEST(Convert, KeepsAStreamFileWhole) {
  const TempFolder folder;
  const std::string text = "Beg_Stream\n1:30,L12:80,R12:70;40\n6,12\n0;1000@5000\nEnd_Stream\n";
  const auto converted = run_convert({folder.write("in.txt", text).string(), "-"});
  ASSERT_TRUE(converted);
  EXPECT_EQ(converted->text, text);
}

TEST(Convert, ANameInCsvIsWrittenAsATableThatSaysTheSame) {
  const TempFolder folder;
  const std::string text = "Beg_Stream\n6:40,L12:50,R12:80;40\n51:20,63:70;40\nEnd_Stream\n";
  const std::string table = (folder.path() / "out.csv").string();
  const auto written = run_convert({folder.write("in.txt", text).string(), table});
  ASSERT_TRUE(written) << written.error().message;
  EXPECT_NE(written->said.find("out.csv: a table of OpenFace 2, 2 rows, which has no sides: in 1 "
                               "keyframe the stronger one was taken\n"),
            std::string::npos)
      << written->said;
  const auto again = run_convert({table, "-"});
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(again->text, "Beg_Stream\n6:40,12:80;40\n51:20,63:70;40\nEnd_Stream\n");
}

TEST(Convert, ResamplesAndTakesTheSourcesOptions) {
  const TempFolder folder;
  const auto in = folder.write("in.csv", sources::tables::kPyFeat1).string();
  EXPECT_EQ(run_convert({in, "-"}).error().kind, ErrorKind::Usage);
  const auto converted = run_convert({"--fps", "30", "--rate=10", in, "-"});
  ASSERT_TRUE(converted);
  EXPECT_EQ(converted->text,
            "Beg_Stream\n1:25,52:50,53:50,56:50;100\n1:50,43:75,54;100\nEnd_Stream\n");
}

TEST(Convert, WrongCommandLinesAreRefused) {
  EXPECT_EQ(run_convert({"a"}).error().message,
            "convert needs two files, IN and OUT (try convert --help)");
  EXPECT_EQ(run_convert({"a", "b", "c"}).error().kind, ErrorKind::Usage);
  EXPECT_EQ(run_convert({"a", ""}).error().message, "OUT is empty (try --help)");
  EXPECT_EQ(run_convert({"--keyframe", "0", "a", "b"}).error().message,
            "--keyframe '0' is not a whole number from 1 to 3600000 (try --help)");
  EXPECT_EQ(run_convert({"--rat", "3", "a", "b"}).error().message,
            "unknown option --rat; did you mean --rate? (try --help)");
  EXPECT_EQ(run_convert({"--fps", "x", "a", "b"}).error().kind, ErrorKind::Usage);
  EXPECT_EQ(run_convert({"--face-id", "all", "a", "b"}).error().message,
            "convert writes one stream; --face-id all is for serving, name one face (try convert "
            "--help)");
  const TempFolder folder;
  EXPECT_EQ(run_convert({(folder.path() / "none").string(), "-"}).error().kind,
            ErrorKind::Unreadable);
  const auto in = folder.write("in.csv", sources::tables::kOpenFace1).string();
  EXPECT_EQ(run_convert({in, (folder.path() / "no" / "out").string()}).error().kind,
            ErrorKind::Failed);
}

TEST(Convert, WritesEachSourceToAFolder) {
  const TempFolder folder;
  const auto a = folder.write("a.csv", sources::tables::kOpenFace1).string();
  const auto b = folder.write("b.txt", "Beg_Stream\n12;100\nEnd_Stream\n").string();
  const auto c = folder.write("c.txt", "Beg_Stream\n1;100\nEnd_Stream\n").string();
  std::filesystem::create_directory(folder.path() / "out");
  const auto to = (folder.path() / "out").string();
  const auto converted = run_convert({"--to", to, a, b, c});
  ASSERT_TRUE(converted) << converted.error().message;
  for (const char* name : {"a.txt", "b.txt", "c.txt"}) {
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "out" / name)) << name;
  }
  EXPECT_EQ(*read_file(folder.path() / "out" / "b.txt"), *read_file(b));
  EXPECT_TRUE(run_convert({"--to", to, b}));
  const auto twice = run_convert({"--to", to, a, folder.write("a.txt", "").string()});
  ASSERT_FALSE(twice);
  EXPECT_EQ(twice.error().kind, ErrorKind::Usage);
  EXPECT_NE(twice.error().message.find("another source is called 'a' too"), std::string::npos);
}

TEST(Convert, AFilmThatIsNoneIsSaidSo) {
  const TempFolder folder;
  const auto none = run_convert({(folder.path() / "none.mp4").string(), "-"});
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().kind, ErrorKind::Unreadable);
  EXPECT_NE(none.error().message.find("none.mp4"), std::string::npos);
}

TEST(Convert, AutoStraightensTheHeadOfATableAndLeavesItsAus) {
  const std::string table =
      "frame,face_id,timestamp,confidence,success,pose_Tx,pose_Rx,pose_Ry,pose_Rz,AU12_r\n"
      "1,0,0.0,0.98,1,0,0,0.2,0,1\n2,0,0.1,0.98,1,0,0,0.2,0,1\n3,0,0.2,0.98,1,0,0,0.2,0,1\n";
  const TempFolder folder;
  const auto in = folder.write("in.csv", table).string();
  const auto asked = run_convert({"--neutral", "auto", in, "-"});
  ASSERT_TRUE(asked) << asked.error().message;
  EXPECT_EQ(asked->text, "Beg_Stream\n12:20;100\n12:20;100\n12:20;100\nEnd_Stream\n");
  const auto as_it_is = run_convert({in, "-"});
  ASSERT_TRUE(as_it_is);
  EXPECT_NE(as_it_is->text.find("52:33"), std::string::npos) << as_it_is->text;
}

TEST(SourcePath, ACameraIsALiveSourceOfThatName) {
  EXPECT_EQ(camera_device("camera"), "/dev/video0");
  EXPECT_EQ(camera_device("camera:/dev/video2"), "/dev/video2");
  EXPECT_EQ(camera_device("camera:"), std::nullopt);
  EXPECT_EQ(camera_device("./camera"), std::nullopt);
  EXPECT_EQ(camera_device("cameraman.txt"), std::nullopt);
  EXPECT_EQ(stream_name("camera:/dev/video2"), "camera");
  EXPECT_TRUE(is_live("camera", false));
  const auto checked = load_sources({"camera"});
  ASSERT_FALSE(checked);
  EXPECT_EQ(checked.error().kind, ErrorKind::Usage);
}

TEST(CameraOptions, AreRead) {
  camera::CameraOptions options;
  const auto rows = camera_rows(options);
  EXPECT_TRUE(read_words(rows, {{"camera-size", {"1280x720"}}, {"camera-fps", {"25"}}}));
  EXPECT_EQ(options, (camera::CameraOptions{"/dev/video0", 1280, 720, 25}));
  for (const char* word : {"1280", "x720", "1280x", "0x0", "640x480x3", "99999x10"}) {
    EXPECT_FALSE(read_words(rows, {{"camera-size", {word}}})) << word;
  }
  EXPECT_FALSE(read_words(rows, {{"camera-fps", {"0"}}}));
}

TEST(Convert, HelpFitsOneScreen) {
  const auto help = run_convert({"--help"});
  ASSERT_TRUE(help);
  EXPECT_EQ(help->text, help_text(convert_page()));
  for (const std::string_view line : split(help->text, '\n')) EXPECT_LE(line.size(), 80U) << line;
}

TEST(Convert, HelpDoesNotOfferAllFaces) {
  const auto help = run_convert({"--help"});
  ASSERT_TRUE(help);
  EXPECT_NE(help->text.find("--face-id N"), std::string::npos);
  EXPECT_EQ(help->text.find("faces, or all"), std::string::npos);
}

}  // namespace
}  // namespace aucast::server

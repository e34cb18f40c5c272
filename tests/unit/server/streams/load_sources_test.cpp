#include "server/streams/load_sources.h"

#include <stop_token>

#include <gtest/gtest.h>

#include "server/streams/check_report.h"
#include "server/streams/resampling.h"
#include "tests/support/temp_folder.h"
#include "tests/unit/sources/tables.h"

namespace aucast::server {
namespace {

using test::TempFolder;

constexpr const char* kTwo = "Beg_Stream\n1:10,12:80;40\n6,12\nEnd_Stream\n";

Error error_of(const std::vector<std::filesystem::path>& paths) {
  const auto sources = load_sources(paths);
  if (sources) {
    ADD_FAILURE() << "no error";
    return {};
  }
  return sources.error();
}

bool has(const Error& error, const std::string& text) {
  return error.message.find(text) != std::string::npos;
}

TEST(LoadSources, NamesStreamsByTheirStems) {
  const TempFolder folder;
  const auto sources = load_sources({folder.write("talk.txt", kTwo), folder.write("b-2.au", kTwo)});
  ASSERT_TRUE(sources);
  ASSERT_EQ(sources->size(), 2U);
  EXPECT_EQ(sources->at(0).name, "talk");
  EXPECT_EQ(sources->at(1).name, "b-2");
  EXPECT_EQ(sources->at(0).summary.keyframes, 2U);
}

TEST(LoadSources, MissingFileIsUnreadable) {
  const TempFolder folder;
  const Error error = error_of({folder.path() / "none.txt"});
  EXPECT_EQ(error.kind, ErrorKind::Unreadable);
  EXPECT_TRUE(has(error, "none.txt: cannot be read: No such file or directory"));
}

TEST(LoadSources, FolderIsServedByName) {
  const TempFolder folder;
  for (const char* name : {"b.txt", "c.TXT", "a.txt"}) folder.write(name, kTwo);
  folder.write("README.md", "none of it");
  folder.write(".hidden.txt", "none of it");
  const auto sources = load_sources({folder.path()});
  ASSERT_TRUE(sources) << sources.error().message;
  ASSERT_EQ(sources->size(), 3U);
  EXPECT_EQ(sources->at(0).name, "a");
  EXPECT_EQ(sources->at(1).name, "b");
  EXPECT_EQ(sources->at(2).name, "c");
  EXPECT_EQ(error_of({folder.path() / "a.txt", folder.path()}).kind, ErrorKind::Usage) << "twice";
}

TEST(LoadSources, FolderWithoutStreamsIsBadData) {
  const TempFolder folder;
  const Error error = error_of({folder.path()});
  EXPECT_EQ(error.kind, ErrorKind::BadData);
  EXPECT_TRUE(has(error,
                  "there is no .txt or .csv file in this folder; films and other "
                  "files are named one by one"));
}

TEST(LoadSources, BrokenOnesAreLeftOutOnlyWhenAskedAndWhileAnyIsLeft) {
  const TempFolder folder;
  folder.write("good.txt", kTwo);
  const auto bad = folder.write("bad.txt", "Beg_Stream\n1,100\nEnd_Stream\n");
  EXPECT_EQ(error_of({folder.path()}).kind, ErrorKind::BadData);
  std::vector<Error> skipped;
  const auto sources = load_sources({folder.path()}, {}, {}, {}, &skipped);
  ASSERT_TRUE(sources);
  ASSERT_EQ(sources->size(), 1U);
  EXPECT_EQ(sources->at(0).name, "good");
  ASSERT_EQ(skipped.size(), 1U);
  EXPECT_TRUE(has(skipped[0], bad.string() + ":2:"));
  EXPECT_FALSE(load_sources({bad}, {}, {}, {}, &skipped)) << "nothing is left";
}

TEST(LoadSources, WrongFileIsBadDataWithItsPlace) {
  const TempFolder folder;
  const auto file = folder.write("bad.txt", "Beg_Stream\n1,100\nEnd_Stream\n");
  const Error error = error_of({file});
  EXPECT_EQ(error.kind, ErrorKind::BadData);
  EXPECT_TRUE(has(error, file.string() + ":2:")) << error.message;
}

TEST(LoadSources, AllErrorsOfAllFilesAreReported) {
  const TempFolder folder;
  const Error error = error_of({folder.write("good.txt", kTwo),
                                folder.write("bad.txt", "Beg_Stream\n1x2\n100\nEnd_Stream\n"),
                                folder.path() / "none.txt"});
  EXPECT_EQ(error.kind, ErrorKind::BadData) << "the kind of the first one";
  EXPECT_TRUE(has(error, "bad.txt:2:")) << error.message;
  EXPECT_TRUE(has(error, "bad.txt:3:")) << error.message;
  EXPECT_TRUE(has(error, "none.txt: cannot be read")) << error.message;
}

TEST(LoadSources, OneNameOfTwoServersBelongsInOneAddress) {
  const auto sources =
      load_sources({"aucast://a/talk", "aucast://b/talk"}, {}, {}, {}, nullptr, LiveKinds::Streams);
  ASSERT_FALSE(sources);
  EXPECT_TRUE(has(sources.error(), "name two hosts of one stream in one address"))
      << sources.error().message;
}

TEST(LoadSources, NameThatIsTakenIsRefusedWithTheRemedy) {
  const TempFolder folder;
  const auto first = folder.write("a/talk.txt", kTwo);
  const Error error = error_of({first, folder.write("b/talk.txt", kTwo)});
  EXPECT_EQ(error.kind, ErrorKind::Usage);
  EXPECT_TRUE(has(error, "b/talk.txt: a stream named 'talk' comes from " + first.string()));
  EXPECT_TRUE(has(error, "rename")) << error.message;
}

TEST(LoadSources, NameThatCannotBeAskedForIsRefusedWithTheRemedy) {
  const TempFolder folder;
  const Error error = error_of({folder.write("my talk\x01.txt", kTwo)});
  EXPECT_EQ(error.kind, ErrorKind::Usage);
  EXPECT_TRUE(has(error, "'my talk\\x01' cannot be a stream's name; rename")) << error.message;
}

TEST(LoadSources, ClassicMinimumDecidesWhatClassicClientsGet) {
  const TempFolder folder;
  const auto path = folder.write("talk.txt", kTwo);
  EXPECT_EQ(load_sources({path}, {}, {250, 10})->front().stream->classic[0], "{1,12}");
  EXPECT_EQ(load_sources({path}, {}, {250, 81})->front().stream->classic[0], "{0}");
}

/// Whichever way a source takes; --skip-bad makes no list of what is left.
TEST(LoadSources, AskedToStopItReadsNothingMore) {
  const TempFolder folder;
  const auto talk = folder.write("talk.txt", kTwo);
  const auto table = folder.write("b.csv", "timestamp,success,AU12_r\n0,1,1\n0.1,1,2\n");
  SourceOptions resampled;
  resampled.rate = 10;
  std::stop_source stop;
  std::vector<Error> skipped;
  const auto load = [&](const SourceOptions& options) {
    return load_sources({talk, table}, options, {}, {}, &skipped, LiveKinds::None,
                        stop.get_token());
  };
  EXPECT_TRUE(load({}));
  EXPECT_TRUE(load(resampled));
  stop.request_stop();
  EXPECT_FALSE(load({}));
  EXPECT_FALSE(load(resampled));
}

TEST(LoadSources, ARateThatMemoryCannotHoldIsRefused) {
  const TempFolder folder;
  std::string packets;
  for (int line = 0; line < 2000; ++line) packets += "1;3600000\n";
  SourceOptions options;
  options.rate = 1000;
  const auto refused =
      load_sources({folder.write("a.txt", "Beg_Stream\n" + packets + "End_Stream\n")}, options);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::Unreadable);
  EXPECT_TRUE(has(refused.error(), "a.txt: too large to hold: it needs "));
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

TEST(LoadSources, TheSummaryIsOfWhatMaxBitrateLeaves) {
  const TempFolder folder;
  std::string packets;
  for (int i = 0; i < 400; ++i) packets += std::to_string(1 + i % 2) + ":" + "50;10\n";
  EncodingOptions thin;
  thin.max_kbits = 8;
  const auto sources =
      load_sources({folder.write("a.txt", "Beg_Stream\n" + packets + "End_Stream\n")}, {}, thin);
  ASSERT_TRUE(sources) << sources.error().message;
  const Source& source = sources->front();
  EXPECT_LT(source.summary.keyframes, 200U);
  EXPECT_EQ(source.summary.keyframes, source.stream->times.size());
  EXPECT_EQ(source.summary.duration_ms, 4000U);
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

TEST(LoadSources, ARateThatTakesTooMuchMemoryIsNamedInTheRemedy) {
  protocol::Keyframe minute;
  minute.time_ms = 60'000;
  protocol::StreamFile stream;
  stream.keyframes.assign(100, minute);
  const auto refused = resample(stream, 1e9, 100, "a.txt");
  ASSERT_FALSE(refused);
  EXPECT_TRUE(refused.error().message.ends_with("; lower --rate or choose a shorter stream"));
  EXPECT_EQ(stream.keyframes.size(), 100U);
}

}  // namespace
}  // namespace aucast::server

#include "server/streams/convert_command.h"

#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "common/files.h"
#include "common/text.h"
#include "tests/support/memory_limit.h"
#include "tests/support/temp_folder.h"
#include "tests/unit/sources/tables.h"

namespace aucast::server {
namespace {

using test::TempFolder;

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
  EXPECT_EQ(converted->said.find("not changed"), std::string::npos) << converted->said;
  const auto gain = run_convert({"--gain", "2", folder.write("in.txt", text).string(), "-"});
  ASSERT_TRUE(gain);
  EXPECT_EQ(gain->text, text);
  EXPECT_NE(gain->said.find("a stream file, not changed by --gain; "), std::string::npos)
      << gain->said;
}

TEST(Convert, NeverWritesOverWhatItReads) {
  const TempFolder folder;
  const std::string text = "Beg_Stream\n12;40\nEnd_Stream\n";
  const std::string in = folder.write("in.txt", text).string();
  const std::string other = folder.write("other/b.txt", text).string();
  const std::string to = (folder.path() / "to").string();
  const std::string hard = to + "/b.txt";
  std::filesystem::create_directory(to);
  std::filesystem::create_hard_link(in, hard);
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{in, in},
                                             {in, hard},
                                             {in, to + "/new", "--save-profile", in},
                                             {"--to", to, in, other}}) {
    const auto refused = run_convert(arguments);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ErrorKind::Usage);
    EXPECT_TRUE(refused.error().message.ends_with(
        " would be written over " + in +
        ", which is read; choose another name or folder (try convert --help)"))
        << refused.error().message;
  }
  EXPECT_EQ(folder.read("in.txt"), text);
  EXPECT_FALSE(std::filesystem::exists(to + "/in.txt"));
}

TEST(Convert, WritesNoFileTwice) {
  const TempFolder folder;
  const std::string in = folder.write("in.csv", sources::tables::kOpenFace1).string();
  const std::string profile = folder.write("in.txt", "of before").string();
  for (const std::vector<std::string>& out :
       std::vector<std::vector<std::string>>{{profile}, {"--to", folder.path().string()}}) {
    std::vector<std::string> arguments{"--neutral", "1", "--save-profile", profile, in};
    arguments.insert(arguments.end(), out.begin(), out.end());
    const auto refused = run_convert(arguments);
    ASSERT_FALSE(refused) << out.front();
    EXPECT_EQ(refused.error().kind, ErrorKind::Usage);
    EXPECT_EQ(refused.error().message,
              profile +
                  " would be written twice, for two options; choose another name for one of them "
                  "(try convert --help)");
    EXPECT_EQ(folder.read("in.txt"), "of before");
  }
}

TEST(Convert, WhatDoesNotFitIntoMemoryIsRefusedBeforeItIsRead) {
  const TempFolder folder;
  constexpr std::size_t kKeyframes = 1'000'000;
  const std::string stream = folder.write("in.txt", test::short_lines(kKeyframes)).string();
  std::string rows = "frame,face_id,timestamp,confidence,success,AU01_r\n";
  for (std::size_t i = 0; i < kKeyframes; ++i) rows += "1,0,0,1,1,0\n";
  const std::string table = folder.write("in.csv", rows).string();
  // Enough for the text and what check_memory() keeps free, and not for the keyframes.
  const test::MemoryLimit limit(std::uint64_t{160} << 20U);
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
           {stream, "-"}, {"--mend", stream, "-"}, {table, "-"}}) {
    const auto refused = run_convert(arguments);
    ASSERT_FALSE(refused) << arguments.front();
    EXPECT_EQ(refused.error().kind, ErrorKind::Unreadable);
    EXPECT_NE(refused.error().message.find(": too large to hold: it needs "), std::string::npos)
        << refused.error().message;
  }
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
  const auto upper = run_convert({table, (folder.path() / "OUT.CSV").string()});
  ASSERT_TRUE(upper) << upper.error().message;
  EXPECT_NE(upper->said.find("OUT.CSV: a table of OpenFace 2"), std::string::npos) << upper->said;
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

TEST(Convert, WhatCannotBeWrittenLeavesTheProfileAsItWas) {
  const TempFolder folder;
  const auto in = folder.write("in.csv", sources::tables::kOpenFace1).string();
  const auto profile = folder.write("profile.toml", "of before");
  const std::vector<std::string> options{"--neutral", "1", "--save-profile", profile.string(), in};
  const auto to = [&options](const std::filesystem::path& out) {
    std::vector<std::string> all = options;
    all.push_back(out.string());
    return run_convert(all);
  };
  EXPECT_FALSE(to(folder.path() / "not_there" / "out.txt"));
  EXPECT_EQ(folder.read("profile.toml"), "of before");
  EXPECT_TRUE(to(folder.path() / "out.txt"));
  EXPECT_NE(folder.read("profile.toml"), "of before");
}

TEST(Convert, AProfileIsMeasuredInOneSource) {
  const TempFolder folder;
  const auto a = folder.write("a.csv", sources::tables::kOpenFace1).string();
  const auto b = folder.write("b.csv", sources::tables::kOpenFace1).string();
  const auto to = (folder.path() / "to").string();
  std::filesystem::create_directory(to);
  const auto profile = (folder.path() / "me.toml").string();
  const auto both = run_convert({"--neutral", "1", "--save-profile", profile, "--to", to, a, b});
  ASSERT_FALSE(both);
  EXPECT_EQ(both.error().message,
            "--save-profile with --neutral takes one source, and there are 2 (try convert --help)");
  EXPECT_FALSE(std::filesystem::exists(profile));
  EXPECT_TRUE(run_convert({"--neutral", "1", "--save-profile", profile, "--to", to, a}));
}

TEST(Convert, WrongCommandLinesAreRefused) {
  EXPECT_EQ(run_convert({"a"}).error().message,
            "convert needs two files, IN and OUT, or --to DIR and files (try convert --help)");
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

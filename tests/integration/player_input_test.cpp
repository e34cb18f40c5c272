// What face-player does with bad input: exit code, message, nothing lost.

#include <gtest/gtest.h>

#include "common/files.h"
#include "tests/integration/player_run.h"
#include "tests/support/served.h"

namespace aucast::test {
namespace {

void expect_failure(const PlayerRun& run, int exit_code, const std::vector<std::string>& words) {
  EXPECT_EQ(run.finished.exit_code, exit_code) << run.finished.err;
  for (const std::string& word : words) {
    EXPECT_NE(run.finished.err.find(word), std::string::npos)
        << "'" << word << "' is not in: " << run.finished.err;
  }
}

TEST(PlayerInput, UsageErrorsExitTwoWithOneLine) {
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{"--hedless", "x"},
                                                    {"--headless"},
                                                    {"play"},
                                                    {"--headless", "host:99999"},
                                                    {"--headless", "host:"}}) {
    const PlayerRun run = run_player(arguments);
    expect_failure(run, 2, {"face-player: "});
    EXPECT_EQ(std::count(run.finished.err.begin(), run.finished.err.end(), '\n'), 1);
  }
  expect_failure(run_player({"--hedless", "x"}), 2, {"did you mean --headless?"});
}

TEST(PlayerInput, HelpGoesToStdout) {
  const Finished help = run({program("face-player"), "--help"});
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_NE(help.out.find("face-player play FILE"), std::string::npos);
  EXPECT_EQ(help.err, "");
}

TEST(PlayerInput, UnknownHostAndRefusedPort) {
  const PlayerRun unknown = run_player({"--headless", "no-such-host.invalid", "--fast"});
  expect_failure(unknown, 5, {"no-such-host.invalid"});
  EXPECT_EQ(unknown.stats["end_reason"], "unreachable");
  const PlayerRun refused = run_player({"--headless", "127.0.0.1:1", "--fast"});
  expect_failure(refused, 5, {"127.0.0.1", "1"});
  EXPECT_EQ(refused.stats["end_reason"], "unreachable");
}

TEST(PlayerInput, StreamFiles) {
  const TempFolder folder;
  expect_failure(run_player({"play", (folder.path() / "none.txt").string(), "--fast"}), 4,
                 {"none.txt", "No such file"});
  expect_failure(run_player({"play", folder.path().string(), "--fast"}), 4, {"folder"});
  const auto bad = folder.write("bad.txt", "Beg_Stream\n1,2\n1,100\nEnd_Stream\n");
  const PlayerRun run = run_player({"play", bad.string(), "--fast"});
  expect_failure(run, 3, {"bad.txt:3:5:"});
  EXPECT_EQ(run.stats["end_reason"], "failed");
}

TEST(PlayerInput, WhatIsReadIsNeverWrittenOver) {
  const TempFolder folder;
  const std::string text = "Beg_Stream\n12;100\nEnd_Stream\n";
  const std::string stream = folder.write("talk.txt", text).string();
  const std::string voice = folder.write("talk.wav", "voice").string();
  const std::string player = program("face-player");
  for (const std::vector<std::string>& outputs :
       {std::vector<std::string>{"--stats", stream}, {"--sound", voice}}) {
    std::vector<std::string> words{player, "play", stream, "--headless", "--fast"};
    words.insert(words.end(), outputs.begin(), outputs.end());
    const Finished done = run(words);
    EXPECT_EQ(done.exit_code, 2);
    EXPECT_NE(done.err.find(" would be written over "), std::string::npos) << done.err;
  }
  // Statistics are written of runs that fail, too.
  const std::string bad = folder.write("bad.txt", "Beg_Stream\n1,100\n").string();
  EXPECT_EQ(run({player, "play", bad, "--headless", "--stats", bad}).exit_code, 2);
  EXPECT_EQ(folder.read("bad.txt"), "Beg_Stream\n1,100\n");
  EXPECT_EQ(folder.read("talk.txt"), text);
  EXPECT_EQ(folder.read("talk.wav"), "voice");
}

TEST(PlayerInput, WhatTheFaceCannotShowIsSaidOnceInARun) {
  const TempFolder folder;
  const auto stream =
      folder.write("s.txt", "Beg_Stream\n12,40;40\n40:50,84;40\n84;40\n40;40\nEnd_Stream\n");
  for (const char* how : {"--headless", "--fast"}) {
    const PlayerRun run = run_player({"play", stream.string(), how});
    expect_failure(run, 0,
                   {"the face 'default' cannot show AU 40 Sniff\n",
                    "the face 'default' cannot show AU 84 Head Shake Back and Forth\n"});
    EXPECT_EQ(std::count(run.finished.err.begin(), run.finished.err.end(), '\n'), 2)
        << run.finished.err;
  }
}

TEST(PlayerInput, AnExportIsWholeAndTheSameEachTime) {
  const TempFolder folder;
  const auto stream = folder.write("s.txt", "Beg_Stream\n12:80;500\n1,2;500\nEnd_Stream\n");
  const std::string first = (folder.path() / "first.glb").string();
  const std::string second = (folder.path() / "second.glb").string();
  const Finished done = run({program("face-player"), "export", stream.string(), first});
  ASSERT_EQ(done.exit_code, 0) << done.err;
  EXPECT_NE(done.out.find("31 samples in 1.0 s"), std::string::npos) << done.out;
  EXPECT_NE(done.out.find("farthest vertex"), std::string::npos) << done.out;
  ASSERT_EQ(run({program("face-player"), "export", stream.string(), second}).exit_code, 0);
  const std::string bytes = *read_file(first);
  EXPECT_EQ(bytes.substr(0, 4), "glTF");
  EXPECT_TRUE(bytes == *read_file(second));
}

TEST(PlayerInput, AnExportOfAShippedFaceHasItsLicenceHoweverItsFolderIsWritten) {
  const TempFolder folder;
  const std::string glb = (folder.path() / "face.glb").string();
  const std::string shipped = program("data/faces/default");
  for (const std::string& face : {std::string("default"), shipped + "/", shipped + "/../marek"}) {
    const Finished done = run({program("face-player"), "export", "--face", face, glb});
    ASSERT_EQ(done.exit_code, 0) << done.err;
    EXPECT_NE(read_file(glb)->find("MIT licence, AUcast"), std::string::npos) << face;
  }
  std::filesystem::copy(shipped, folder.path() / "own");
  const std::string own = (folder.path() / "own").string();
  ASSERT_EQ(run({program("face-player"), "export", "--face", own, glb}).exit_code, 0);
  EXPECT_EQ(read_file(glb)->find("MIT licence, AUcast"), std::string::npos);
}

TEST(PlayerInput, ExportsThatCannotBeLeaveWhatWasThere) {
  const TempFolder folder;
  const std::string glb = folder.write("face.glb", "mine").string();
  const auto bad = folder.write("bad.txt", "Beg_Stream\n1,2\n1,100\nEnd_Stream\n");
  expect_failure(run_player({"export", (folder.path() / "none.txt").string(), glb}), 4,
                 {"none.txt"});
  expect_failure(run_player({"export", bad.string(), glb}), 3, {"bad.txt:3:5:"});
  expect_failure(run_player({"export", "--face", "nobody", glb}), 4,
                 {"no face 'nobody' (known: ", "default, ", "or the folder of one)"});
  expect_failure(run_player({"export", "--face", "defualt", glb}), 4, {"did you mean default?"});
  expect_failure(run_player({"export", (folder.path() / "none" / "face.glb").string()}), 1,
                 {"none"});
  expect_failure(run_player({"export", glb + ".txt"}), 2, {"end in .glb"});
  EXPECT_EQ(*read_file(glb), "mine");
}

TEST(PlayerInput, AShippedStreamPlaysWithoutAServer) {
  const PlayerRun run = run_player({"play", stream_file("talk.txt"), "--fast"});
  EXPECT_EQ(run.finished.exit_code, 0) << run.finished.err;
  EXPECT_GT(run.stats["keyframes_played"].get<int>(), 300);
  EXPECT_EQ(run.stats["end_reason"], "end_of_stream");
}

TEST(PlayerInput, WhatCannotBeWrittenAtTheEndIsRefusedAtTheBeginning) {
  const TempFolder folder;
  // An hour, which this test does not wait for.
  const std::string hour =
      folder.write("hour.txt", "Beg_Stream\n12;3600000\nEnd_Stream\n").string();
  const auto nowhere = folder.path() / "none";
  PlayerRun run;
  run.finished = test::run({program("face-player"), "play", hour, "--headless", "--no-sound",
                            "--stats", (nowhere / "stats.json").string()});
  expect_failure(run, 1, {"none/stats.json"});
  expect_failure(run_player({"play", hour, "--sheet", (nowhere / "page.png").string()}), 1,
                 {"none/page.png"});
}

TEST(PlayerInput, FaceFolders) {
  const TempFolder folder;
  expect_failure(run_player({"pose", "12", "--face", (folder.path() / "none").string()}), 4,
                 {"none"});
  // Waters' format: three points and one triangle with a wrong index, then a point that is none.
  folder.write("wrong/faceline.dat", "3\n0 0 0\n-1 0 0\n-1 1 0\n");
  folder.write("wrong/index.dat", "1\n1000 1 2 7\n");
  folder.write("wrong/muscle.dat", "0\n");
  expect_failure(run_player({"pose", "12", "--face", (folder.path() / "wrong").string()}), 3,
                 {"index.dat:2", "7"});
  folder.write("nan/faceline.dat", "3\n0 0 0\n-1 nan 0\n-1 1 0\n");
  folder.write("nan/index.dat", "1\n1000 1 2 3\n");
  folder.write("nan/muscle.dat", "0\n");
  expect_failure(run_player({"pose", "12", "--face", (folder.path() / "nan").string()}), 3,
                 {"faceline.dat:3"});
}

TEST(PlayerInput, NoNameOfAFaceReachesTheTerminalAsControlCharacters) {
  const TempFolder folder;
  std::filesystem::copy(program("data/faces/default"), folder.path() / "odd");
  const auto rewrite = [&](const std::string& file, const std::string& from,
                           const std::string& to) {
    std::string bytes = folder.read(file);
    const std::size_t at = bytes.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    folder.write(file, bytes.replace(at, from.size(), to));
  };
  rewrite("odd/face.toml", "name = \"default\"", "name = \"a\\u001b[31mface\"");
  rewrite("odd/mesh.ply", "part left_crease_chin", "part left_crease_chin\x1b[31m");
  const std::string face = (folder.path() / "odd").string();
  const PlayerRun list = run_player({"pose", "--list", "--face", face});
  ASSERT_EQ(list.finished.exit_code, 0) << list.finished.err;
  EXPECT_EQ(list.finished.out.find('\x1b'), std::string::npos);
  EXPECT_NE(list.finished.out.find("a\\x1b[31mface"), std::string::npos) << list.finished.out;
  EXPECT_NE(list.finished.out.find("left_crease_chin\\x1b[31m"), std::string::npos);
  const PlayerRun muscle =
      run_player({"pose", "--face", face, "--muscle", "left_crease_chin[31m=1"});
  expect_failure(muscle, 2, {"a\\x1b[31mface has no", "left_crease_chin\\x1b[31m?"});
}

TEST(PlayerInput, MusclesAndExpressions) {
  expect_failure(run_player({"pose", "--muscle", "left_zygomaticus_mayor=1"}), 2,
                 {"did you mean left_zygomaticus_major?"});
  expect_failure(run_player({"pose", "--muscle", "jaw=4.5"}), 2,
                 {"jaw: 4.5 is outside 0 to 4; give a value between them"});
  expect_failure(run_player({"pose", "--expression", "happynes"}), 2, {"happiness"});
  expect_failure(run_player({"pose", "1,2x,300"}), 2, {"300"});
}

TEST(PlayerInput, Rules) {
  const TempFolder folder;
  expect_failure(run_player({"rules", "1", "--rules", "fasc"}), 2, {"facs"});
  expect_failure(run_player({"rules", "1", "--rules", (folder.path() / "no.toml").string()}), 4,
                 {"no.toml"});
  const auto rules = folder.write("r.toml",
                                  "format = 1\nname = \"r\"\n[[rule]]\nkind = \"dominance\"\n"
                                  "sources = [77]\ntargets = [1]\nsource = \"x\"\n");
  expect_failure(run_player({"rules", "1", "--rules", rules.string()}), 3, {"r.toml:", "77"});
}

TEST(PlayerInput, OutputsThatCannotBeWritten) {
  const TempFolder folder;
  const auto file = folder.write("file", "x");
  const std::string inside = (file / "x").string();
  expect_failure(run_player({"pose", "12", "--obj", inside + ".obj"}), 1, {"cannot be written"});
  const Finished stats = run({program("face-player"), "play", stream_file("happiness.txt"),
                              "--fast", "--stats", inside + ".json"});
  EXPECT_EQ(stats.exit_code, 1);
  EXPECT_NE(stats.err.find("cannot be written"), std::string::npos) << stats.err;
}

TEST(PlayerInput, RulesOfTheThesisTable) {
  const auto after = [](const std::string& aus, const std::string& rules) {
    const Finished done = run({program("face-player"), "rules", aus, "--rules", rules});
    EXPECT_EQ(done.exit_code, 0) << done.err;
    return done.out;
  };
  EXPECT_EQ(after("1,2,5,15,16,20,26", "kumar2010"), "2,5,11,15,26\n");
  EXPECT_EQ(after("1,2,5,15,16,20,26", "facs"), "1,2,5,15,16,20,26\n");
  EXPECT_EQ(after("51,52:40", "none"), "51,52:40\n");
}

}  // namespace
}  // namespace aucast::test

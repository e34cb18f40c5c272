// Sources that are still being written, through the real transmitter.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "tests/integration/growing_table.h"
#include "tests/integration/server_running.h"
#include "tests/support/temp_folder.h"

namespace aucast::test {
namespace {

void replace(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::trunc) << text;
}

class LiveSources : public ::testing::Test {
 protected:
  RawClient join(const RunningTransmitter& server) {
    std::string reply;
    RawClient client = say_hello(server, "{hello v=2 window=0}", reply);
    EXPECT_NE(reply.find(" live=1 "), std::string::npos) << reply;
    return client;
  }

  TempFolder folder_;
};

TEST_F(LiveSources, AGrowingFileIsFollowedFromItsPresentEnd) {
  const auto path = folder_.write("webcam.csv", kHeader + row(0, "1") + row(1, "2"));
  RunningTransmitter server({"--follow", "--source-timeout", "0", path.string()});
  RawClient client = join(server);
  EXPECT_EQ(client.receive_until("}"), "{12:40;40}");
  append(path, row(2, "3").substr(0, 5));
  EXPECT_TRUE(client.silent(std::chrono::milliseconds(100)));
  append(path, row(2, "3").substr(5));
  EXPECT_NE(client.receive_until("{12:60;").find("{12:60;"), std::string::npos);
  replace(path, kHeader + row(0, "4"));
  EXPECT_NE(client.receive_until("{12:80;").find("{12:80;"), std::string::npos);
  append(path, row(1, "5"));
  EXPECT_NE(client.receive_until("{12;").find("{12;"), std::string::npos);
  EXPECT_EQ(server.terminate(), 0);
  EXPECT_NE(server.log().find("webcam.csv: OpenFace 2, live, AU scale 0-5"), std::string::npos)
      << server.log();
  EXPECT_NE(server.log().find("; reading it anew"), std::string::npos) << server.log();
}

TEST_F(LiveSources, AFifoThatIsOpenedAgainGoesOn) {
  const auto path = folder_.path() / "face.fifo";
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  RunningTransmitter server({"--source-timeout", "0", path.string()});
  RawClient client = join(server);
  append(path, kHeader + row(0, "1"));
  EXPECT_EQ(client.receive_until("}"), "{12:20;40}");
  append(path, kHeader + row(0, "2"));
  EXPECT_NE(client.receive_until("{12:40;").find("{12:40;"), std::string::npos);
  EXPECT_EQ(server.terminate(), 0);
}

TEST_F(LiveSources, ASilentSourceGoesToNeutralAndEndsUntilItComesBack) {
  const auto path = folder_.path() / "face.fifo";
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  RunningTransmitter server({"--source-timeout", "2", path.string()});
  RawClient client = join(server);
  append(path, kHeader + row(0, "5"));
  const std::string all = client.receive_all();
  EXPECT_TRUE(all.starts_with("{12;40}{12:90;100}")) << all;
  EXPECT_TRUE(all.ends_with("{12:10;100}{0;100}{-2}")) << all;
  append(path, row(1, "5"));
  for (int attempt = 0; attempt < 100; ++attempt) {
    // The row may still be on its way when the next client comes.
    RawClient next = join(server);
    const std::string first = next.receive_until("}");
    if (first == kEnd) continue;
    EXPECT_TRUE(first.starts_with("{12")) << first;
    break;
  }
  EXPECT_EQ(server.terminate(), 0);
}

/// 75 rows of 3 s at 4 kbit/s: some eight a second of 63 bytes, headers included, and a second's
/// more, are sent, the same to everybody. The newest wins and takes the time of all.
TEST_F(LiveSources, AreThinnedOnceForAllClients) {
  const auto path = folder_.path() / "face.fifo";
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  RunningTransmitter server({"--source-timeout", "3", "--max-bitrate", "4", path.string()});
  RawClient one = join(server);
  RawClient other = join(server);
  std::string rows = kHeader;
  for (int i = 0; i < 75; ++i) rows += row(i, std::to_string(i % 5 + 1));
  append(path, rows);
  const std::string all = one.receive_all();
  EXPECT_EQ(other.receive_all(), all);
  // After the last row, which ends at 3 s, the face goes to neutral.
  int count = 0;
  int time_ms = 0;
  std::size_t begin = 0;
  while (time_ms < 75 * 40 && all.find(';', begin) != std::string::npos) {
    const std::size_t time = all.find(';', begin);
    time_ms += std::stoi(all.substr(time + 1));
    ++count;
    if (time_ms < 75 * 40) begin = all.find('{', time);
  }
  EXPECT_EQ(time_ms, 75 * 40) << all;
  EXPECT_EQ(all.substr(begin, 4), "{12;") << all;
  EXPECT_GE(count, 15) << all;
  EXPECT_LE(count, 36) << all;
  EXPECT_EQ(server.terminate(), 0);
}

TEST_F(LiveSources, EveryFaceGetsAStreamWhenItIsFirstSeen) {
  const auto path = folder_.path() / "room.fifo";
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  std::filesystem::create_directory(folder_.path() / "kept");
  RunningTransmitter server({"--source-timeout", "0", "--face-id", "all", "--record",
                             (folder_.path() / "kept").string(), path.string()});
  std::string reply;
  RawClient followed = say_hello(server, "{hello v=2 window=0 stream=room}", reply);
  RawClient early = say_hello(server, "{hello v=2 window=0 stream=room-1}", reply);
  EXPECT_TRUE(reply.starts_with("{error 404")) << reply;
  const int writer = ::open(path.c_str(), O_WRONLY);
  const auto write = [writer](const std::string& text) {
    EXPECT_EQ(::write(writer, text.data(), text.size()), static_cast<ssize_t>(text.size()));
  };
  write(std::string(kHeader) + "0,0,1,1\n");
  EXPECT_EQ(followed.receive_until("}"), "{12:20;40}");
  write("1,0.04,1,4\n0,0.04,1,2\n");
  EXPECT_NE(followed.receive_until("{12:40;").find("{12:40;"), std::string::npos);
  // Who was there before goes on; who comes now finds each face.
  RawClient one = say_hello(server, "{hello v=2 window=0 stream=room-1}", reply);
  EXPECT_TRUE(reply.starts_with("{hello")) << reply;
  RawClient zero = say_hello(server, "{hello v=2 window=0 stream=room-0}", reply);
  EXPECT_TRUE(reply.starts_with("{hello")) << reply;
  write("1,0.08,1,5\n0,0.08,1,3\n");
  EXPECT_NE(followed.receive_until("{12:60;").find("{12:60;"), std::string::npos);
  EXPECT_NE(one.receive_until("{12;").find("{12;"), std::string::npos);
  EXPECT_NE(zero.receive_until("{12:60;").find("{12:60;"), std::string::npos);
  ::close(writer);
  EXPECT_EQ(server.terminate(), 0);
  const auto kept = std::distance(std::filesystem::directory_iterator(folder_.path() / "kept"), {});
  EXPECT_EQ(kept, 3);
}

/// A recorded stream that is sent live and the faces of a source are served side by side: who
/// watches the one sees no gap when another face of the other comes.
TEST_F(LiveSources, AFaceThatComesDisturbsNoRecordedStreamBesideIt) {
  const auto path = folder_.path() / "room.fifo";
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  const auto recorded = folder_.write("rec.txt", "Beg_Stream\n1;20\n2;20\n4;20\nEnd_Stream\n");
  RunningTransmitter server({"--live", "--loop", "--source-timeout", "0", "--face-id", "all",
                             recorded.string(), path.string()});
  std::string reply;
  RawClient client = say_hello(server, "{hello v=2 window=0 stream=rec}", reply);
  EXPECT_NE(reply.find("live=1"), std::string::npos) << reply;
  const int writer = ::open(path.c_str(), O_WRONLY);
  const auto write = [writer](const std::string& text) {
    EXPECT_EQ(::write(writer, text.data(), text.size()), static_cast<ssize_t>(text.size()));
  };
  write(std::string(kHeader) + "0,0,1,1\n");
  for (const char* face : {"1", "2", "3"}) {
    write(std::string(face) + ",0.04,1,4\n");
    EXPECT_TRUE(logs(server, std::string("is the stream room-") + face));
    EXPECT_EQ(client.receive_until("{4;20}{1;20}{2;20}").find("{-2}"), std::string::npos);
    RawClient later = say_hello(server, "{hello v=2 window=0 stream=rec}", reply);
    EXPECT_NE(later.receive_until("{4;20}").find("{4;20}"), std::string::npos);
  }
  ::close(writer);
  EXPECT_EQ(server.terminate(), 0);
}

TEST_F(LiveSources, AFileThatHasBecomeAPipeIsNotServedByAReload) {
  const auto path = folder_.write("a.txt", "Beg_Stream\n1\nEnd_Stream\n");
  const auto other = folder_.write("b.txt", "Beg_Stream\n2\nEnd_Stream\n");
  RunningTransmitter server({path.string(), other.string()});
  std::filesystem::remove(path);
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  server.process().signal(SIGHUP);
  EXPECT_TRUE(logs(server, "a: it is written live now and was not at the start"));
  RawClient client = server.connect();
  EXPECT_EQ(client.receive_until("}"), "{2}") << "the first stream that is left";
  EXPECT_EQ(server.terminate(), 0);
}

TEST_F(LiveSources, AMissingFileIsRefused) {
  const Finished missing = run({program("au-transmitter"), "--follow", "--port", "0",
                                (folder_.path() / "missing.csv").string()});
  EXPECT_EQ(missing.exit_code, 4);
}

}  // namespace
}  // namespace aucast::test

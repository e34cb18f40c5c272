// --record through the real transmitter: what is served is what is kept.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <thread>

#include <gtest/gtest.h>

#include "tests/integration/server_running.h"
#include "tests/support/eventually.h"
#include "tests/support/temp_folder.h"

namespace aucast::test {
namespace {

/// OpenFace 2 at 25 pictures a second, from row `from` on.
std::string rows(int from, int count) {
  std::string text;
  for (int frame = from; frame < from + count; ++frame) {
    const int ms = frame * 40;
    text += "0," + std::to_string(ms / 1000) + "." + std::to_string(1000 + ms % 1000).substr(1) +
            ",1," + std::to_string(frame % 50 / 10.0) + "\n";
  }
  return text;
}

constexpr const char* kHeader = "face_id,timestamp,success,AU12_r\n";

/// A FIFO that stays open, as a recogniser keeps it.
class Writer {
 public:
  explicit Writer(const std::filesystem::path& path) : file_(::open(path.c_str(), O_WRONLY)) {}
  ~Writer() { ::close(file_); }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
  void write(const std::string& text) const {
    EXPECT_EQ(::write(file_, text.data(), text.size()), static_cast<ssize_t>(text.size()));
  }

 private:
  int file_;
};

class Record : public ::testing::Test {
 protected:
  void SetUp() override { ASSERT_EQ(::mkfifo(fifo_.c_str(), 0600), 0); }

  /// What is on the lines of a stream file, as packets.
  static std::string packets_of(const std::string& text) {
    std::string packets;
    std::size_t begin = 0;
    for (std::size_t end = text.find('\n'); end != std::string::npos;
         end = text.find('\n', begin)) {
      const std::string line = text.substr(begin, end - begin);
      if (!line.ends_with("_Stream")) packets += "{" + line + "}";
      begin = end + 1;
    }
    return packets;
  }

  /// Waits until the file has the line: it is written on a thread of its own.
  [[nodiscard]] bool comes(const std::string& line) const {
    return eventually(
        [&] { return folder_.read("kept.txt").find(line + "\n") != std::string::npos; });
  }

  TempFolder folder_;
  std::filesystem::path fifo_ = folder_.path() / "face.fifo";
  std::filesystem::path kept_ = folder_.path() / "kept.txt";
};

TEST_F(Record, IsServedAgainTheSame) {
  RunningTransmitter server({"--record", kept_.string(), fifo_.string()});
  std::string reply;
  RawClient client = say_hello(server, "{hello v=2 window=0}", reply);
  const Writer writer(fifo_);
  writer.write(kHeader);
  for (int frame = 0; frame < 50; ++frame) {
    writer.write(rows(frame, 1));
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  const std::string live = client.receive_until("{12:98;40}");
  EXPECT_EQ(server.terminate(), 0) << server.log();
  const std::string kept = folder_.read("kept.txt");
  EXPECT_EQ(packets_of(kept), live);
  EXPECT_NE(server.log().find("50 keyframes recorded to " + kept_.string()), std::string::npos);

  EXPECT_EQ(run({program("au-transmitter"), "--check", kept_.string()}).exit_code, 0);
  RunningTransmitter again({kept_.string()});
  RawClient other = say_hello(again, "{hello v=2 window=64}", reply);
  EXPECT_EQ(other.receive(live.size()), live);
  other.send(std::string(50, '1'));
  EXPECT_EQ(other.receive_all(), kEnd);
}

TEST_F(Record, IsWholeWhenTheTransmitterIsKilled) {
  RunningTransmitter server({"--record", kept_.string(), fifo_.string()});
  const Writer writer(fifo_);
  writer.write(kHeader + rows(0, 10));
  ASSERT_TRUE(comes("12:18;40"));
  server.process().signal(SIGKILL);
  ASSERT_TRUE(server.process().wait(kPatience));
  const Finished check = run({program("au-transmitter"), "--check", kept_.string()});
  EXPECT_EQ(check.exit_code, 0) << check.err;
  EXPECT_NE(check.out.find("keyframes   10,"), std::string::npos) << check.out;
}

TEST_F(Record, IsNotWrittenOver) {
  folder_.write("kept.txt", "Beg_Stream\n1\nEnd_Stream\n");
  const Finished refused =
      run({program("au-transmitter"), "--port", "0", "--record", kept_.string(), fifo_.string()});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_NE(refused.err.find("never writes over"), std::string::npos) << refused.err;
  EXPECT_EQ(refused.out, "");
}

TEST_F(Record, NeedsALiveSource) {
  const auto file = folder_.write("talk.txt", "Beg_Stream\n1\nEnd_Stream\n");
  const Finished refused =
      run({program("au-transmitter"), "--port", "0", "--record", kept_.string(), file.string()});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_NE(refused.err.find("au-transmitter convert"), std::string::npos) << refused.err;
}

TEST_F(Record, OfSeveralSourcesAFolderKeepsEach) {
  const auto other = folder_.path() / "other.fifo";
  ASSERT_EQ(::mkfifo(other.c_str(), 0600), 0);
  std::filesystem::create_directory(folder_.path() / "kept");
  RunningTransmitter server(
      {"--record", (folder_.path() / "kept").string(), fifo_.string(), other.string()});
  std::string reply;
  RawClient first = say_hello(server, "{hello v=2 window=0 stream=face}", reply);
  RawClient second = say_hello(server, "{hello v=2 window=0 stream=other}", reply);
  const Writer one(fifo_);
  const Writer two(other);
  one.write(kHeader + rows(1, 1));
  two.write(kHeader + rows(2, 1));
  EXPECT_EQ(first.receive_until("}"), "{12:2;40}");
  EXPECT_EQ(second.receive_until("}"), "{12:4;40}");
  EXPECT_EQ(server.terminate(), 0);
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder_.path() / "kept")) {
    const std::string name = entry.path().filename().string();
    const std::string text = folder_.read("kept/" + name);
    EXPECT_EQ(packets_of(text), name.starts_with("face-") ? "{12:2;40}" : "{12:4;40}") << name;
    ++count;
  }
  EXPECT_EQ(count, 2);
}

/// A limit to the size of files stands for the full disk: it needs no disk. Runs the transmitter
/// under it on a whole recording from stdin.
Finished run_limited(const std::filesystem::path& recording, const std::filesystem::path& kept) {
  return run({"sh", "-c",
              "ulimit -f 2; cat " + recording.string() + " | " + program("au-transmitter") +
                  " --port 0 --record " + kept.string() + " -"});
}

TEST_F(Record, AFullDiskEndsTheRecordingAndNotTheStream) {
  const auto recording = folder_.write("face.csv", kHeader + rows(0, 200));
  const Finished done = run_limited(recording, kept_);
  EXPECT_EQ(done.exit_code, 1) << done.err;
  EXPECT_NE(done.err.find("the recording ends here, serving goes on"), std::string::npos)
      << done.err;
  EXPECT_NE(done.err.find("stdin: it has ended, and so has the stream"), std::string::npos)
      << done.err;
  const std::string kept = folder_.read("kept.txt");
  EXPECT_TRUE(kept.starts_with("Beg_Stream\n0;40\n12:2;40\n")) << kept;
  EXPECT_TRUE(kept.ends_with(";40\nEnd_Stream\n")) << kept;
  EXPECT_GT(kept.size(), 1000U);
}

TEST_F(Record, WhatAPowerCutToreIsMended) {
  const auto torn = folder_.write("torn.txt", "Beg_Stream\n12:20;40\n12:40;33\n12:6").string();
  EXPECT_EQ(run({program("au-transmitter"), "--check", torn}).exit_code, 3);
  const Finished mended = run({program("au-transmitter"), "convert", "--mend", torn, "-"});
  EXPECT_EQ(mended.exit_code, 0) << mended.err;
  EXPECT_EQ(mended.out, "Beg_Stream\n12:20;40\n12:40;33\nEnd_Stream\n");
  EXPECT_NE(mended.err.find("1 torn line at the end left out"), std::string::npos) << mended.err;
}

TEST_F(Record, AfterTheEndOfStdinTheTransmitterEnds) {
  const auto recording = folder_.write("face.csv", kHeader + rows(0, 5));
  const Finished done = run({"sh", "-c",
                             program("au-transmitter") + " --port 0 --record " + kept_.string() +
                                 " - < " + recording.string()});
  EXPECT_EQ(done.exit_code, 0) << done.err;
  EXPECT_NE(done.err.find("all sources have ended"), std::string::npos) << done.err;
  EXPECT_TRUE(folder_.read("kept.txt").ends_with("0;100\nEnd_Stream\n"));
  const Finished nothing = run({"sh", "-c", program("au-transmitter") + " --port 0 - < /dev/null"});
  EXPECT_EQ(nothing.exit_code, 3);
  EXPECT_NE(nothing.err.find("the source ended before a keyframe came"), std::string::npos);
}

}  // namespace
}  // namespace aucast::test

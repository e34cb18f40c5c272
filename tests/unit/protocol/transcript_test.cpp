#include "tests/unit/protocol/transcript.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "common/files.h"

namespace aucast::test {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> transcripts() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(AUCAST_PROTOCOL_FOLDER "/transcripts")) {
    if (entry.path().extension() == ".txt") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

TEST(Transcripts, AreWhatBothSidesDo) {
  std::size_t servers = 0;
  std::size_t clients = 0;
  std::size_t publishers = 0;
  for (const fs::path& file : transcripts()) {
    const auto text = read_file(file);
    ASSERT_TRUE(text.has_value()) << text.error().message;
    if (is_for(*text, "server")) {
      EXPECT_EQ(replay_on_server(*text), "") << file.filename() << ", server";
      ++servers;
    }
    if (is_for(*text, "client")) {
      EXPECT_EQ(replay_on_client(*text), "") << file.filename() << ", client";
      ++clients;
    }
    if (text->find("\nroles turn\n") != std::string::npos) {
      EXPECT_EQ(replay_on_publisher(*text), "") << file.filename() << ", publisher";
      ++publishers;
    }
  }
  EXPECT_GE(publishers, 3U);
  EXPECT_GE(servers, 20U);
  EXPECT_GE(clients, 20U);
}

TEST(Transcripts, AreReadClosely) {
  EXPECT_EQ(replay_on_server("t 100ms\nS> {1}\n"), "");
  EXPECT_EQ(replay_on_server("t 100ms\nS> {2}\n"), "line 2: the server said '{1}'");
  EXPECT_EQ(replay_on_server("t 100ms\n"), "the server also said '{1}'");
  EXPECT_EQ(replay_on_server("t 100ms\nC> 1\n"), "line 2: the server also said '{1}'");
  EXPECT_EQ(replay_on_server("S end\n"), "line 1: no end of sending");
  EXPECT_EQ(replay_on_server("S is classic awaiting\n"), "line 1: the server is classic idle");
  EXPECT_EQ(replay_on_server("C < 1\n"), "line 1: 'C <' is none of the words of a transcript");
  EXPECT_EQ(
      replay_on_publisher("publisher x\npublish talk token=x\nC> {hello token=x publish=talk}\n"
                          "S hands over\nroles turn\n"),
      "the publisher said '{hello v=2 window=1 token=x publish=talk}'");
  EXPECT_EQ(replay_on_client("client classic\nS> {1}\nC> -1\nC is classic paused unanswered=0\n"),
            "");
  EXPECT_EQ(replay_on_client("client classic\nS> {1}\nC stores 2\n"), "line 3: stored was 1");
  EXPECT_EQ(replay_on_client("S> {-2}\nC ends properly\n"),
            "at the end: the client also said '{hello v=2 window=1}'");
}

TEST(Unescaped, KnowsEachEscape) {
  EXPECT_EQ(unescaped("a\\n\\r\\t\\\\\\x1bz\\*3[ab]"), "a\n\r\t\\\x1bzababab");
}

}  // namespace
}  // namespace aucast::test

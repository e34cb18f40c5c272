// The log as programs read it.
#include "common/log.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <climits>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace aucast {
namespace {

/// What the log writes to stderr when `message` is logged.
std::string logged(const std::string& message, LogFormat format) {
  std::array<int, 2> pipe{};
  EXPECT_EQ(::pipe2(pipe.data(), O_CLOEXEC), 0);
  const int own = ::dup(STDERR_FILENO);
  ::dup2(pipe[1], STDERR_FILENO);
  EXPECT_TRUE(set_up_log("au-transmitter", "info", format));
  spdlog::info("{}", message);
  ::dup2(own, STDERR_FILENO);
  ::close(own);
  ::close(pipe[1]);
  std::string line;
  std::array<char, 4096> chunk{};
  for (ssize_t got = 0; (got = ::read(pipe[0], chunk.data(), chunk.size())) > 0;) {
    line.append(chunk.data(), static_cast<std::size_t>(got));
  }
  ::close(pipe[0]);
  return line;
}

TEST(JsonLog, IsJsonHoweverLongTheMessage) {
  // Every length near the limit, so that the cut falls on each byte of an escape.
  for (const char* piece : {"x", "\"", "\\", "\n", "\xc3\xa4"}) {
    for (std::size_t before = 0; before < 8; ++before) {
      std::string message(before, 'a');
      while (message.size() < 10'000) message += piece;
      const std::string line = logged(message, LogFormat::Json);
      ASSERT_TRUE(line.ends_with("\n"));
      EXPECT_LE(line.size(), static_cast<std::size_t>(PIPE_BUF));
      EXPECT_GE(line.size(), static_cast<std::size_t>(PIPE_BUF) - 8);
      const auto json = nlohmann::json::parse(line, nullptr, false);
      ASSERT_FALSE(json.is_discarded()) << line.substr(line.size() - 20);
      EXPECT_EQ(json["program"], "au-transmitter");
    }
  }
}

TEST(TextLog, IsOneLineHoweverLongTheMessage) {
  const std::string line = logged(std::string(10'000, 'x'), LogFormat::Text);
  EXPECT_EQ(line.size(), static_cast<std::size_t>(PIPE_BUF));
  EXPECT_TRUE(line.ends_with("x\n"));
}

}  // namespace
}  // namespace aucast

// Files that are not what they should be, and files that the transmitter writes.
#include <sys/stat.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "tests/integration/server_running.h"
#include "tests/support/certificates.h"
#include "tests/support/temp_folder.h"

namespace aucast::test {
namespace {

namespace fs = std::filesystem;

void make_fifo(const fs::path& path) {
  fs::remove(path);
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
}

constexpr const char* kStream = "Beg_Stream\n1;100\nEnd_Stream\n";

class ServerFiles : public ::testing::Test {
 protected:
  ServerFiles() { fs::create_directory(served_); }

  TempFolder folder_;
  fs::path served_ = folder_.path() / "served";
};

TEST_F(ServerFiles, AFifoInAServedFolderIsRefusedAtOnce) {
  folder_.write("served/a.txt", kStream);
  make_fifo(served_ / "z.txt");
  for (const char* option : {"--port=0", "--check"}) {
    const Finished refused = run({program("au-transmitter"), option, served_.string()});
    EXPECT_EQ(refused.exit_code, 4) << option << refused.err;
    EXPECT_TRUE(has(refused.err, "z.txt: cannot be read: it is a pipe")) << refused.err;
  }
  RunningTransmitter server({"--skip-bad", served_.string()});
  EXPECT_EQ(server.terminate(), 0);
  EXPECT_TRUE(has(server.log(), "left out: " + served_.string() + "/z.txt")) << server.log();
}

TEST_F(ServerFiles, AFifoThatComesBeforeAReloadHoldsUpNeitherReloadsNorTheExit) {
  folder_.write("served/a.txt", kStream);
  RunningTransmitter server({served_.string()});
  make_fifo(served_ / "z.txt");
  server.process().signal(SIGHUP);
  EXPECT_TRUE(logs(server, "z.txt: cannot be read: it is a pipe")) << server.log();
  fs::remove(served_ / "z.txt");
  folder_.write("served/b.txt", kStream);
  server.process().signal(SIGHUP);
  EXPECT_TRUE(logs(server, "2 streams")) << server.log();
  EXPECT_EQ(server.terminate(), 0) << server.log();
}

TEST_F(ServerFiles, ATokenThatBecomesAFifoChangesNothing) {
  const auto token = folder_.write("token", "0123456789abcdef0123456789abcdef\n");
  RunningTransmitter server({"--token-file", token.string(), folder_.write("a.txt", kStream)});
  make_fifo(token);
  server.process().signal(SIGHUP);
  EXPECT_TRUE(logs(server, "the certificates and token in use stay")) << server.log();
  std::string reply;
  say_hello(server, "{hello v=2 token=0123456789abcdef0123456789abcdef}", reply);
  EXPECT_TRUE(reply.starts_with("{hello")) << reply;
  EXPECT_EQ(server.terminate(), 0);
}

TEST_F(ServerFiles, AProfileAndASettingsFileAreNoFifosEither) {
  const auto stream = folder_.write("a.txt", kStream);
  make_fifo(folder_.path() / "fifo");
  for (const char* option : {"--profile", "--config", "--tls-client-ca"}) {
    std::vector<std::string> arguments = {
        program("au-transmitter"),          "--port",       "0", option,
        (folder_.path() / "fifo").string(), stream.string()};
    Authority authority;
    const Certificate own = authority.issue("own", "DNS:a");
    if (option == std::string("--tls-client-ca")) {
      arguments.insert(arguments.end(), {"--tls-cert", own.file, "--tls-key", own.key});
    }
    const Finished refused = run(arguments);
    EXPECT_EQ(refused.exit_code, 4) << option << refused.err;
    EXPECT_TRUE(has(refused.err, "it is a pipe")) << refused.err;
  }
}

TEST_F(ServerFiles, TheirNamesCannotCommandTheTerminal) {
  const auto evil = folder_.write("a\x1b[2J\n.txt", "Beg_Stream\n99x\nEnd_Stream\n");
  for (const char* option : {"--port=0", "--check"}) {
    const Finished refused = run({program("au-transmitter"), option, evil.string()});
    EXPECT_NE(refused.exit_code, 0);
    EXPECT_TRUE(has(refused.err, "a\\x1b[2J\\x0a.txt")) << refused.err;
    EXPECT_FALSE(has(refused.err + refused.out, "\x1b")) << refused.err;
  }
  const auto missing = folder_.path() / "\x1b]0;x\x07\n.txt";
  const Finished none = run({program("au-transmitter"), "--check", missing.string()});
  EXPECT_NE(none.exit_code, 0);
  EXPECT_EQ(none.err.find('\n'), none.err.size() - 1) << none.err;
  EXPECT_FALSE(has(none.err, "\x1b")) << none.err;
}

TEST_F(ServerFiles, OldStatisticsStayUntilThereAreNewOnes) {
  const auto stats = folder_.write("stats.json", "{\"clients_total\": 7}\n");
  const auto victim = folder_.write("victim", "dear");
  RunningTransmitter server({"--stats", stats.string(), folder_.write("a.txt", kStream)});
  EXPECT_EQ(folder_.read("stats.json"), "{\"clients_total\": 7}\n");
  // Where the temporary file would be if its name could be guessed.
  fs::create_symlink(victim, stats.string() + ".part-" + std::to_string(server.process().pid()));
  EXPECT_EQ(server.terminate(), 0);
  EXPECT_TRUE(has(folder_.read("stats.json"), "\"clients_total\": 0"))
      << folder_.read("stats.json");
  EXPECT_EQ(folder_.read("victim"), "dear");
}

TEST_F(ServerFiles, SecretsThatAreNoneAreWarnedOfAtTheStartAndOnReload) {
  const auto token = folder_.write("token", "x\n");
  fs::permissions(token, fs::perms::owner_all);
  Authority authority;
  const Certificate own = authority.issue("own", "DNS:a");
  fs::permissions(own.key, fs::perms::others_read, fs::perm_options::add);
  RunningTransmitter server({"--tls-cert", own.file, "--tls-key", own.key, "--token-file",
                             token.string(), folder_.write("a.txt", kStream)});
  server.process().signal(SIGHUP);
  const std::string key_is_open = "other users have access to the private key (chmod 600)";
  const std::string token_is_short = "1 token of fewer than 16 characters";
  EXPECT_TRUE(logs(server, key_is_open, 2)) << server.log();
  EXPECT_TRUE(logs(server, token_is_short, 2)) << server.log();
  EXPECT_EQ(server.terminate(), 0);
}

}  // namespace
}  // namespace aucast::test

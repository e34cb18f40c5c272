// The real face-player and au-transmitter over TLS and with a token: what they say to each other,
// and to somebody else.
#include <gtest/gtest.h>

#include "tests/integration/player_run.h"
#include "tests/support/certificates.h"
#include "tests/support/served.h"

namespace aucast::test {
namespace {

class PlayerTls : public ::testing::Test {
 protected:
  static PlayerRun watch(const Served& server, std::vector<std::string> more = {},
                         const std::string& host = "127.0.0.1") {
    const std::string port = server.address().substr(server.address().rfind(':'));
    std::vector<std::string> arguments{"--headless", "--fast", host + port};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_player(std::move(arguments));
  }

  static void expect_played(const PlayerRun& run) {
    EXPECT_EQ(run.finished.exit_code, 0) << run.finished.err;
    EXPECT_EQ(run.stats["keyframes_played"], 6);
    EXPECT_EQ(run.stats["protocol_level"], 2);
  }

  static void expect_refused(const PlayerRun& run, const std::string& end_reason,
                             const std::string& text) {
    EXPECT_EQ(run.finished.exit_code, 5);
    EXPECT_EQ(run.stats["end_reason"], end_reason);
    EXPECT_EQ(run.stats["keyframes_played"], 0);
    EXPECT_NE(run.finished.err.find(text), std::string::npos) << run.finished.err;
  }

  Served serve(const Certificate& own, std::vector<std::string> more = {}) {
    more.insert(more.begin(),
                {stream_file("six_expressions.txt"), "--tls-cert", own.file, "--tls-key", own.key});
    return Served(std::move(more));
  }

  Authority authority_;
  Certificate own_ = authority_.issue("server", "DNS:localhost,IP:127.0.0.1");
};

TEST_F(PlayerTls, BelievesTheRightServerByNameAndAddress) {
  const Served server = serve(own_);
  expect_played(watch(server, {"--tls-ca", authority_.file()}));
  expect_played(watch(server, {"--tls", "--tls-ca", authority_.file()}, "localhost"));
}

TEST_F(PlayerTls, SaysWhyItBelievesNoOther) {
  const Served server = serve(own_);
  expect_refused(watch(server, {"--tls"}), "refused", "authority that is not known here; --tls-ca");
  const Authority stranger("stranger");
  expect_refused(watch(server, {"--tls-ca", stranger.file()}), "refused",
                 "authority that is not known here");
  const Served old = serve(authority_.issue("old", "IP:127.0.0.1", -9, 2));
  expect_refused(watch(old, {"--tls-ca", authority_.file()}), "refused",
                 "the server's certificate has expired on ");
  const Served other = serve(authority_.issue("other", "DNS:other.example"));
  expect_refused(watch(other, {"--tls-ca", authority_.file()}), "refused",
                 "is for other.example, not for 127.0.0.1");
}

TEST_F(PlayerTls, SaysWhenOneOfThemSpeaksPlain) {
  const Served plain({stream_file("six_expressions.txt")});
  expect_refused(watch(plain, {"--tls-ca", authority_.file(), "--connect-timeout", "5"}),
                 "unreachable", "within the TLS handshake; does it speak TLS?");
  const Served server = serve(own_);
  expect_refused(watch(server), "refused", "400 this server speaks TLS only");
}

TEST_F(PlayerTls, ShowsItsOwnCertificate) {
  Authority clients("clients");
  const Certificate mine = clients.issue("player", "DNS:player");
  const Served server = serve(own_, {"--tls-client-ca", clients.file()});
  expect_played(watch(
      server, {"--tls-ca", authority_.file(), "--tls-cert", mine.file, "--tls-key", mine.key}));
  expect_refused(watch(server, {"--tls-ca", authority_.file()}), "refused",
                 "--tls-cert and --tls-key show one");
}

TEST_F(PlayerTls, ShowsItsToken) {
  const TempFolder folder;
  const std::string right = folder.write("right", "s3cret-word\n");
  const std::string wrong = folder.write("wrong", "other-word\n");
  const Served server({stream_file("six_expressions.txt"), "--token-file", right});
  expect_played(watch(server, {"--token-file", right}));
  expect_refused(watch(server, {"--token-file", wrong}), "refused", "401 this token");
  expect_refused(watch(server), "refused", "401 a token is needed");
  const Served secure = serve(own_, {"--token-file", right});
  expect_played(watch(secure, {"--token-file", right, "--tls-ca", authority_.file()}));
}

TEST_F(PlayerTls, AsksBeforeItShowsATokenToEverybody) {
  const TempFolder folder;
  const std::string token = folder.write("token", "s3cret-word\n");
  const auto usage = [](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {program("face-player"), "--headless"});
    const Finished finished = run(std::move(arguments));
    EXPECT_EQ(finished.err.find("s3cret"), std::string::npos);
    return finished;
  };
  const Finished open = usage({"192.0.2.1", "--token-file", token});
  EXPECT_EQ(open.exit_code, 2);
  EXPECT_NE(open.err.find("could read the token: add --tls, or --insecure-token"),
            std::string::npos)
      << open.err;
  EXPECT_EQ(usage({"127.0.0.1", "--token-file", "/nowhere"}).exit_code, 4);
  EXPECT_EQ(usage({"127.0.0.1", "--token-file", folder.write("none", "\n")}).exit_code, 3);
  EXPECT_EQ(usage({"127.0.0.1", "--tls-cert", own_.file}).exit_code, 2);
  EXPECT_EQ(usage({"127.0.0.1", "--tls-ca", "/nowhere"}).exit_code, 4);
  EXPECT_EQ(usage({"127.0.0.1", "--protocol", "classic", "--token-file", token}).exit_code, 2);
}

}  // namespace
}  // namespace aucast::test

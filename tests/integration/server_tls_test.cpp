// au-transmitter with certificates and a token: who gets in, who does not, and that neither costs
// the others anything.
#include <algorithm>
#include <chrono>
#include <filesystem>

#include <gtest/gtest.h>

#include "tests/integration/server_running.h"
#include "tests/support/certificates.h"
#include "tests/support/tls_client.h"

namespace aucast::test {
namespace {

using namespace std::chrono_literals;

tls::Context believing(const std::string& authority, const Certificate& own = {}) {
  auto context = tls::Context::for_client({own.file, own.key, authority});
  EXPECT_TRUE(context) << context.error().message;
  return *context;
}

/// Waits until the log says it: signals are worked on when the server gets to it.
bool says(RunningTransmitter& server, const std::string& text) {
  const auto until = std::chrono::steady_clock::now() + kPatience;
  while (server.log().find(text) == std::string::npos) {
    if (std::chrono::steady_clock::now() > until) return false;
    static_cast<void>(server.process().wait(20ms));  // it goes on; its log is read meanwhile
  }
  return true;
}

const std::string kHello = "{hello v=2 window=2}";

void expect_six_over_tls(TlsClient& client) {
  ASSERT_TRUE(client.layer().ready() || client.shake_hands(kHello)) << client.layer().reason();
  EXPECT_EQ(client.receive_until("}").substr(0, 7), "{hello ");
  for (const std::string& packet : kSixPackets) {
    EXPECT_EQ(client.receive_until("}"), packet);
    client.send("1");
  }
  EXPECT_EQ(client.receive_all(), kEnd);
  EXPECT_TRUE(client.layer().ended()) << "close_notify before the end of the connection";
  client.end_sending();
}

class ServerTls : public ::testing::Test {
 protected:
  RunningTransmitter start(std::vector<std::string> more = {}) {
    std::vector<std::string> arguments{stream_file("six_expressions.txt"), "--tls-cert", own_.file,
                                       "--tls-key", own_.key};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return RunningTransmitter(std::move(arguments));
  }

  Authority authority_;
  Certificate own_ = authority_.issue("server", "DNS:localhost,IP:127.0.0.1");
  tls::Context context_ = believing(authority_.file());
};

TEST_F(ServerTls, ServesLevel2AndClassic) {
  auto server = start();
  TlsClient negotiated(server.address(), context_);
  expect_six_over_tls(negotiated);
  TlsClient classic(server.address(), context_, "127.0.0.1");
  ASSERT_TRUE(classic.shake_hands("1111111"));
  EXPECT_EQ(classic.receive_all(), joined(kSixPackets) + kEnd);
  classic.end_sending();
  EXPECT_EQ(server.terminate(), 0) << server.log();
}

TEST_F(ServerTls, TellsAPlainClientThatItSpeaksTls) {
  auto server = start();
  RawClient plain = server.connect();
  plain.send("{hello v=2}");
  EXPECT_EQ(plain.receive_all(), "{error 400 this server speaks TLS only (face-player --tls)}");
  plain.end_sending();
  EXPECT_EQ(server.terminate(), 0);
  EXPECT_NE(server.log().find("the client does not speak TLS"), std::string::npos) << server.log();
}

TEST_F(ServerTls, APlainServerSaysThatAClientSpeaksTls) {
  RunningTransmitter server({stream_file("six_expressions.txt")});
  TlsClient client(server.address(), context_);
  EXPECT_FALSE(client.shake_hands());
  client.raw().end_sending();
  EXPECT_EQ(server.terminate(), 0);
  EXPECT_NE(server.log().find("the client speaks TLS, which this server does not"),
            std::string::npos)
      << server.log();
}

TEST_F(ServerTls, HandshakesThatGoWrongCostOneConnectionEach) {
  auto server = start();
  TlsClient before(server.address(), context_);
  ASSERT_TRUE(before.shake_hands(kHello));
  RawClient stuck = server.connect();
  stuck.send("\x16\x03\x01");
  RawClient gone = server.connect();
  gone.send("\x16\x03\x01\x02");
  gone.reset();
  RawClient half = server.connect();
  half.send("\x16\x03");
  half.end_sending();
  EXPECT_EQ(half.receive_all(), "");
  RawClient noise = server.connect();
  noise.send("\x16\x03\x01\x01\x01" + std::string(300, 'x'));
  EXPECT_TRUE(noise.wait_for_end());
  TlsClient stranger(server.address(), believing(Authority("other").file()));
  EXPECT_FALSE(stranger.shake_hands());
  stranger.raw().end_sending();
  expect_six_over_tls(before);
  TlsClient after(server.address(), context_);
  expect_six_over_tls(after);
  EXPECT_EQ(server.terminate(), 0) << server.log();
}

TEST_F(ServerTls, AStuckHandshakeIsClosedInTime) {
  auto server = start();
  RawClient stuck = server.connect();
  stuck.send("\x16\x03\x01");
  EXPECT_TRUE(stuck.wait_for_end(30s));
  EXPECT_EQ(server.terminate(), 0);
  EXPECT_NE(server.log().find("no TLS handshake within 10 s"), std::string::npos) << server.log();
}

TEST_F(ServerTls, WantsClientsCertificates) {
  Authority clients("clients");
  const Certificate known = clients.issue("player", "DNS:player");
  auto server = start({"--tls-client-ca", clients.file()});
  TlsClient right(server.address(), believing(authority_.file(), known));
  expect_six_over_tls(right);
  TlsClient none(server.address(), context_);
  none.shake_hands();
  EXPECT_EQ(none.receive_all(), "");
  EXPECT_EQ(none.layer().why(), tls::Layer::Why::Untrusted);
  none.raw().end_sending();
  EXPECT_EQ(server.terminate(), 0);
  EXPECT_NE(server.log().find("the client showed no certificate"), std::string::npos);
}

TEST_F(ServerTls, ReadsItsCertificateAgainAndKeepsTheOldOneIfThatFails) {
  const TempFolder folder;
  const auto certificate = folder.path() / "cert.pem";
  const auto key = folder.path() / "key.pem";
  const auto put = [&](const Certificate& from) {
    const auto over = std::filesystem::copy_options::overwrite_existing;
    std::filesystem::copy_file(from.file, certificate, over);
    std::filesystem::copy_file(from.key, key, over);
  };
  put(own_);
  RunningTransmitter server(
      {stream_file("six_expressions.txt"), "--tls-cert", certificate, "--tls-key", key});
  TlsClient before(server.address(), context_);
  ASSERT_TRUE(before.shake_hands(kHello));

  Authority renewed("renewed");
  put(renewed.issue("server2", "DNS:localhost"));
  server.process().signal(SIGHUP);
  ASSERT_TRUE(says(server, "were read again")) << server.log();
  TlsClient with_new(server.address(), believing(renewed.file()));
  expect_six_over_tls(with_new);
  TlsClient with_old(server.address(), context_);
  EXPECT_FALSE(with_old.shake_hands());
  with_old.raw().end_sending();

  folder.write("cert.pem", "no certificate\n");
  server.process().signal(SIGHUP);
  ASSERT_TRUE(says(server, "in use stay")) << server.log();
  TlsClient still(server.address(), believing(renewed.file()));
  expect_six_over_tls(still);
  expect_six_over_tls(before);
  EXPECT_EQ(server.terminate(), 0) << server.log();
}

TEST_F(ServerTls, FilesThatAreMissingOrWrongEndTheStart) {
  const TempFolder folder;
  const auto junk = folder.write("junk.pem", "no certificate\n");
  const auto start_with = [](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(),
                     {program("au-transmitter"), stream_file("talk.txt"), "--port", "0"});
    return run(std::move(arguments));
  };
  EXPECT_EQ(start_with({"--tls-cert", own_.file}).exit_code, 2);
  EXPECT_EQ(start_with({"--tls-client-ca", authority_.file()}).exit_code, 2);
  EXPECT_EQ(start_with({"--tls-cert", "/nowhere.pem", "--tls-key", own_.key}).exit_code, 4);
  const Finished bad = start_with({"--tls-cert", junk, "--tls-key", own_.key});
  EXPECT_EQ(bad.exit_code, 3);
  EXPECT_EQ(bad.out, "");
  EXPECT_NE(bad.err.find("junk.pem: is no certificate"), std::string::npos) << bad.err;
  EXPECT_EQ(start_with({"--token-file", "/nowhere"}).exit_code, 4);
  EXPECT_EQ(start_with({"--token-file", folder.write("empty", " \n")}).exit_code, 3);
}

TEST(ServerToken, LetsInWhoShowsItAndNobodyElse) {
  const TempFolder folder;
  const auto token = folder.write("token", "s3cret-word\n");
  std::filesystem::permissions(
      token, std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
  RunningTransmitter server({stream_file("six_expressions.txt"), "--token-file", token});
  RawClient right = server.connect();
  right.send("{hello v=2 token=s3cret-word}");
  EXPECT_EQ(right.receive_until("}").substr(0, 7), "{hello ");
  for (const std::string wrong :
       {"{hello v=2 token=s3cret-wor}", "{hello v=2}", "1", "{streams}"}) {
    RawClient client = server.connect();
    client.send(wrong);
    EXPECT_EQ(client.receive_all().substr(0, 11), "{error 401 ") << wrong;
    client.end_sending();
  }
  folder.write("token", "another\n");
  server.process().signal(SIGHUP);
  ASSERT_TRUE(says(server, "were read again"));
  RawClient late = server.connect();
  late.send("{hello v=2 token=s3cret-word}");
  EXPECT_EQ(late.receive_all().substr(0, 11), "{error 401 ");
  late.end_sending();
  expect_six_packets(right);
  right.end_sending();
  EXPECT_EQ(server.terminate(), 0);
  EXPECT_EQ(server.log().find("s3cret"), std::string::npos) << "never logged";
  EXPECT_EQ(server.log().find("chmod"), std::string::npos);
}

TEST(ServerToken, WarnsOfAFileThatOthersCanRead) {
  const TempFolder folder;
  const auto token = folder.write("token", "s3cret-word");
  std::filesystem::permissions(token, std::filesystem::perms::others_read,
                               std::filesystem::perm_options::add);
  RunningTransmitter server({stream_file("six_expressions.txt"), "--token-file", token});
  EXPECT_EQ(server.terminate(), 0);
  EXPECT_NE(server.log().find("(chmod 600)"), std::string::npos) << server.log();
}

TEST(ServerLimits, SoManyClientsFromOneAddress) {
  RunningTransmitter server({stream_file("six_expressions.txt"), "--max-clients-per-address", "2"});
  std::string reply;
  RawClient first = say_hello(server, "{hello v=2}", reply);
  RawClient second = say_hello(server, "{hello v=2}", reply);
  RawClient third = say_hello(server, "{hello v=2}", reply);
  EXPECT_EQ(reply, "{error 503 too many clients from this address}");
  third.end_sending();
  EXPECT_TRUE(third.wait_for_end());
  first.send("-4");
  first.end_sending();
  EXPECT_TRUE(first.wait_for_end());
  RawClient next = say_hello(server, "{hello v=2}", reply);
  EXPECT_EQ(reply.substr(0, 7), "{hello ");
  second.reset();
  next.reset();
  EXPECT_EQ(server.terminate(), 0);
}

TEST(ServerThinLinks, BatchesSmallWritesAndLosesNone) {
  RunningTransmitter server({stream_file("six_expressions.txt"), "--batch", "150"});
  std::string reply;
  RawClient client = say_hello(server, "{hello v=2 window=64}111111", reply);
  EXPECT_EQ(reply.substr(0, 7), "{hello ");
  EXPECT_EQ(client.receive_all(), joined(kSixPackets) + kEnd);
  client.end_sending();
  // One code, one packet: each waits its time and comes by itself.
  RawClient slow = server.connect();
  expect_six_packets(slow);
  slow.end_sending();
  EXPECT_EQ(server.terminate(), 0) << server.log();
}

TEST(ServerThinLinks, EstimatesAndServesWithinABitrate) {
  const auto lines = [](const Finished& finished) {
    return std::count(finished.out.begin(), finished.out.end(), '\n');
  };
  const Finished whole = run({program("au-transmitter"), stream_file("talk.txt"), "--estimate"});
  EXPECT_EQ(whole.exit_code, 0) << whole.err;
  EXPECT_EQ(lines(whole), 6) << whole.out;
  const Finished thin =
      run({program("au-transmitter"), stream_file("talk.txt"), "--estimate", "--max-bitrate", "8"});
  EXPECT_EQ(thin.exit_code, 0) << thin.err;
  EXPECT_NE(thin.out, whole.out);
  EXPECT_EQ(run({program("au-transmitter"), stream_file("talk.txt"), "--batch", "1001"}).exit_code,
            2);
}

}  // namespace
}  // namespace aucast::test

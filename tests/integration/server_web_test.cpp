// au-transmitter --web: the page and the WebSocket, to good and to hostile peers.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>

#include <gtest/gtest.h>

#include "tests/integration/server_running.h"
#include "tests/support/certificates.h"
#include "tests/support/temp_folder.h"
#include "tests/support/tls_client.h"
#include "tests/support/web_frames.h"

namespace aucast::test {
namespace {

using namespace std::chrono_literals;

const std::string kHello = "{hello v=2 window=2}";

/// The transmitter and its second ready line.
class Web {
 public:
  explicit Web(std::vector<std::string> more = {}, std::vector<std::string> variables = {})
      : server_(with(std::move(more)), std::move(variables)) {
    const std::string ready = "web on ";
    const auto line = server_.process().read_line(kPatience);
    EXPECT_TRUE(line && line->starts_with(ready)) << server_.log();
    if (line) address_ = line->substr(std::min(ready.size(), line->size()));
  }

  [[nodiscard]] RunningTransmitter& server() { return server_; }
  [[nodiscard]] const std::string& address() const { return address_; }

  /// A request for the WebSocket as a browser writes it.
  [[nodiscard]] std::string request(const std::string& host, const std::string& more = {}) const {
    return "GET /aucast HTTP/1.1\r\nHost: " + (host.empty() ? address_ : host) +
           "\r\nConnection: keep-alive, Upgrade\r\nUpgrade: websocket\r\n" + more +
           "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n"
           "Sec-WebSocket-Extensions: permessage-deflate\r\n\r\n";
  }
  /// The answer to a request, its head alone when it is upgraded.
  [[nodiscard]] std::string ask(const std::string& request) const {
    RawClient client(address_);
    client.send(request);
    return client.receive_until("\r\n\r\n") + client.receive_all();
  }
  [[nodiscard]] std::string get(const std::string& path, const std::string& more = {}) const {
    return ask("GET " + path + " HTTP/1.1\r\nHost: " + address_ + "\r\n" + more + "\r\n");
  }
  /// Upgraded, with the answer read.
  [[nodiscard]] RawClient upgraded(const std::string& more = {}) const {
    RawClient client(address_);
    client.send(request({}, more));
    const std::string answer = client.receive_until("\r\n\r\n");
    EXPECT_TRUE(answer.starts_with("HTTP/1.1 101 ")) << answer;
    EXPECT_NE(answer.find("\r\nSec-WebSocket-Accept: s3pPLMBiTxaQ9kYGzzhZRbK+xOo=\r\n"),
              std::string::npos);
    EXPECT_EQ(answer.find("Extensions"), std::string::npos);
    return client;
  }

 private:
  static std::vector<std::string> with(std::vector<std::string> more) {
    more.insert(more.begin(), {stream_file("six_expressions.txt"), "--web", "127.0.0.1:0"});
    return more;
  }

  RunningTransmitter server_;
  std::string address_;
};

/// The text of the server's next frame, which must be one of text; what is said instead otherwise.
std::string next_text(RawClient& client) {
  const std::string head = client.receive(2);
  if (head.size() < 2 || head[0] != '\x81') return "[no text]";
  const auto byte = [](char c) -> std::size_t { return static_cast<unsigned char>(c); };
  if (byte(head[1]) < 126) return client.receive(byte(head[1]));
  const std::string length = client.receive(2);
  return client.receive(byte(length[0]) << 8U | byte(length[1]));
}

/// Text up to `end`, out of `held`, which keeps the rest.
std::string text_until(RawClient& client, std::string& held, const std::string& end) {
  while (held.find(end) == std::string::npos) {
    const std::string more = next_text(client);
    held += more;
    if (more == "[no text]") break;
  }
  const std::size_t found = held.find(end);
  const std::size_t count = found == std::string::npos ? held.size() : found + end.size();
  const std::string text = held.substr(0, count);
  held.erase(0, count);
  return text;
}

/// The same, where a frame ends with it.
std::string text_until(RawClient& client, const std::string& end) {
  std::string held;
  return text_until(client, held, end);
}

void expect_six(RawClient& client) {
  client.send(client_text("{hel") + client_text("lo v=2 wind") + client_frame(0x01, "ow=") +
              client_frame(0x89, "?") + client_frame(0x80, "1}"));
  EXPECT_EQ(client.receive(3), server_frame(0x8a, "?"));
  std::string held;
  EXPECT_TRUE(text_until(client, held, "}").starts_with("{hello v=2 "));
  for (const std::string& packet : kSixPackets) {
    ASSERT_EQ(text_until(client, held, "}"), packet);
    client.send(client_text("1"));
  }
  EXPECT_EQ(text_until(client, held, "}"), kEnd);
  EXPECT_EQ(client.receive(4), server_close(1000));
  client.send(client_frame(0x88, "\x03\xe8"));
  EXPECT_EQ(client.receive_all(), "");
}

TEST(ServerWeb, PlaysAStreamOverAWebSocket) {
  Web web;
  RawClient client = web.upgraded("Origin: http://" + web.address() + "\r\n");
  expect_six(client);
  RawClient tcp = web.server().connect();
  expect_six_packets(tcp);
  EXPECT_EQ(web.server().terminate(), 0);
  EXPECT_NE(web.server().log().find("closed: finished"), std::string::npos);
}

TEST(ServerWeb, WhoSaysNoHelloIsRefused) {
  Web web;
  RawClient code = web.upgraded();
  code.send(client_text("1"));
  EXPECT_EQ(text_until(code, "}"), "{error 400 a hello is needed here, as the very first bytes}");
  EXPECT_EQ(code.receive(4), server_close(1000));
  RawClient silent = web.upgraded();
  EXPECT_EQ(text_until(silent, "}"), "{error 400 a hello is needed here, as the very first bytes}");
  EXPECT_EQ(web.server().terminate(), 0);
}

TEST(ServerWeb, LimitsAndTokensAreThoseOfAllClients) {
  const TempFolder folder;
  const auto token = folder.write("token", "0123456789abcdef\n");
  Web web({"--max-clients", "1", "--token-file", token.string()});
  RawClient without = web.upgraded();
  without.send(client_text(kHello));
  EXPECT_EQ(text_until(without, "}"), "{error 401 a token is needed here (--token-file)}");
  without.send(client_frame(0x88, ""));
  EXPECT_TRUE(without.wait_for_end());
  EXPECT_TRUE(logs(web.server(), "closed: refused"));
  RawClient first = web.upgraded();
  first.send(client_text("{hello v=2 token=0123456789abcdef}"));
  EXPECT_TRUE(text_until(first, "}").starts_with("{hello "));
  std::string reply;
  RawClient second = say_hello(web.server(), "{hello v=2 token=0123456789abcdef}", reply);
  EXPECT_EQ(reply, "{error 503 the server is full}");
  EXPECT_EQ(web.server().terminate(), 0);
}

TEST(ServerWeb, ATrustedProxysClientsAreToldApart) {
  Web web({"--max-clients-per-address", "1", "--web-trusted-proxy", "127.0.0.1"});
  RawClient first = web.upgraded("X-Forwarded-For: 9.9.9.9, 1.2.3.4\r\n");
  first.send(client_text(kHello));
  EXPECT_TRUE(next_text(first).starts_with("{hello "));
  RawClient same = web.upgraded("X-Forwarded-For: 1.2.3.4\r\n");
  same.send(client_text(kHello));
  EXPECT_EQ(next_text(same), "{error 503 too many clients from this address}");
  RawClient other = web.upgraded("X-Forwarded-For: 1.2.3.5\r\n");
  other.send(client_text(kHello));
  EXPECT_TRUE(next_text(other).starts_with("{hello "));
  RawClient with_port = web.upgraded("X-Forwarded-For: [2001:db8::1]:443\r\n");
  with_port.send(client_text(kHello));
  EXPECT_TRUE(next_text(with_port).starts_with("{hello "));
  RawClient unnamed = web.upgraded("X-Forwarded-For: unknown\r\n");
  unnamed.send(client_text(kHello));
  EXPECT_TRUE(next_text(unnamed).starts_with("{hello "));
  EXPECT_EQ(web.server().terminate(), 0);
  const std::string log = web.server().log();
  EXPECT_NE(log.find(" 1.2.3.4: "), std::string::npos) << "the proxy's port is not his: " << log;
  EXPECT_NE(log.find(" [2001:db8::1]: "), std::string::npos) << log;
  EXPECT_NE(log.find("X-Forwarded-For has 'unknown', which is no address"), std::string::npos)
      << log;
}

TEST(ServerWeb, EverybodyGetsTheEndWhenItStops) {
  Web web({"--loop", "--live"});
  RawClient client = web.upgraded();
  client.send(client_text("{hello v=2 window=0}"));
  EXPECT_TRUE(text_until(client, "}").starts_with("{hello v=2 window=0 "));
  web.server().process().signal(SIGTERM);
  std::string text;
  while (!text.ends_with(kEnd) && !text.ends_with("[no text]")) text += next_text(client);
  EXPECT_TRUE(text.ends_with(kEnd)) << text;
  EXPECT_EQ(client.receive(4), server_close(1000));
  client.end_sending();
  EXPECT_EQ(web.server().process().wait(kPatience), 0);
}

TEST(ServerWeb, HostilePeersCostOneConnectionEach) {
  Web web;
  RawClient watching = web.upgraded();
  struct Attack {
    std::string wire;
    int code;
  };
  const Attack attacks[] = {
      {server_text(kHello), 1002},                                   // not masked
      {client_frame(0xc1, kHello), 1002},                            // compressed
      {client_frame(0x82, kHello), 1003},                            // binary
      {client_frame(0x89, std::string(200, 'x')), 1002},             // a long ping
      {client_frame(0x80, "1"), 1002},                               // a fragment of nothing
      {client_text("{hello \xff}"), 1007},                           // no ASCII
      {std::string("\x81\xff\0\0\0\0\x04\0\0\0", 10), 1009},         // 64 MB announced
      {client_text(std::string(std::size_t{1} << 20U, '1')), 1009},  // a MB sent
      {std::string("\x81\xfe\0\x05", 4), 1002},                      // a length in a long form
      {client_frame(0x88, "x"), 1002},                               // half a code
  };
  for (const Attack& attack : attacks) {
    RawClient client = web.upgraded();
    client.send(attack.wire);
    EXPECT_EQ(client.receive(4), server_close(attack.code));
  }
  RawClient pinging = web.upgraded();
  for (int i = 0; i < 2000; ++i) pinging.send(client_frame(0x89, std::string(100, 'p')));
  pinging.reset();
  RawClient gone = web.upgraded();
  gone.reset();
  RawClient early(web.address());
  early.send(web.request({}) + client_text(kHello));
  EXPECT_TRUE(early.receive_all().starts_with("HTTP/1.1 400 "));
  expect_six(watching);
  EXPECT_EQ(web.server().terminate(), 0);
  EXPECT_NE(web.server().log().find("protocol error: a frame is not masked"), std::string::npos);
}

TEST(ServerWeb, ForeignHostsAndPagesOfOthersAreRefused) {
  Web web({"--web-host", "au.example", "--web-host", "*.campus.example"});
  EXPECT_TRUE(web.ask(web.request("evil.example")).starts_with("HTTP/1.1 421 "));
  EXPECT_TRUE(web.ask("GET / HTTP/1.1\r\nHost: evil.example\r\n\r\n").starts_with("HTTP/1.1 421 "));
  EXPECT_TRUE(web.ask("HEAD / HTTP/1.1\r\nHost: evil.example\r\n\r\n").ends_with("\r\n\r\n"))
      << "no body";
  for (const char* origin : {"https://evil.example", "null", "http://6.6.6.6"}) {
    const std::string reply = web.ask(web.request({}, "Origin: " + std::string(origin) + "\r\n"));
    EXPECT_TRUE(reply.starts_with("HTTP/1.1 403 ")) << origin;
    EXPECT_NE(reply.find("--web-host"), std::string::npos);
  }
  for (const char* origin :
       {"http://au.example", "https://course.campus.example", "http://localhost:3000"}) {
    RawClient client = web.upgraded("Origin: " + std::string(origin) + "\r\n");
  }
  EXPECT_EQ(web.server().terminate(), 0);
}

TEST(ServerWeb, SlowAndManyAskersShutNobodyOut) {
  Web web;
  std::vector<std::unique_ptr<RawClient>> crowd;
  for (int i = 0; i < 300; ++i) {
    crowd.push_back(std::make_unique<RawClient>(web.address()));
    crowd.back()->send(i % 2 == 0 ? "GET /aucast HTTP/1.1\r\nHost: 127" : "");
  }
  RawClient client = web.upgraded();
  expect_six(client);
  for (const auto& asker : crowd) EXPECT_TRUE(asker->wait_for_end()) << "closed for its slowness";
  EXPECT_EQ(web.server().terminate(), 0);
}

TEST(ServerWeb, BadRequestsAreRefusedWithASentence) {
  Web web;
  EXPECT_TRUE(web.ask("POST / HTTP/1.1\r\nHost: a\r\n\r\n").starts_with("HTTP/1.1 405 "));
  EXPECT_TRUE(web.get("/aucast").starts_with("HTTP/1.1 426 "));
  EXPECT_TRUE(web.get("/../../etc/passwd").starts_with("HTTP/1.1 404 "));
  EXPECT_TRUE(web.get("/" + std::string(100'000, 'x')).starts_with("HTTP/1.1 431 "));
  EXPECT_TRUE(web.ask("{hello v=2}").starts_with("HTTP/1.1 400 "));
  EXPECT_EQ(web.server().terminate(), 0);
}

TEST(ServerWeb, WithoutAPageItSaysWhatIsMissing) {
  const TempFolder data;
  Web web({}, {"AUCAST_DATA=" + data.path().string()});
  const std::string reply = web.get("/");
  EXPECT_TRUE(reply.starts_with("HTTP/1.1 404 "));
  EXPECT_NE(reply.find("scripts/build_web.sh builds it"), std::string::npos);
  RawClient client = web.upgraded();
  expect_six(client);
  EXPECT_EQ(web.server().terminate(), 0);
  EXPECT_NE(web.server().log().find("--web: there is no page in " + data.path().string()),
            std::string::npos);
}

TEST(ServerWeb, GivesThePageToManyAtOnceWhateverItsSize) {
  const TempFolder data;
  std::filesystem::create_directory(data.path() / "web");
  const std::string large(std::size_t{5} << 20U, 'm');
  data.write("web/index.html", "<p>face");
  data.write("web/mesh.ply", large);
  Web web({"--live", "--loop"}, {"AUCAST_DATA=" + data.path().string()});
  EXPECT_TRUE(web.get("/").ends_with("\r\n\r\n<p>face"));
  const std::string head = web.ask("HEAD /mesh.ply HTTP/1.1\r\nHost: localhost\r\n\r\n");
  EXPECT_TRUE(head.ends_with("\r\n\r\n")) << "no body";
  EXPECT_NE(head.find("\r\nContent-Length: " + std::to_string(large.size()) + "\r\n"),
            std::string::npos);
  std::vector<std::unique_ptr<RawClient>> idle;
  for (int i = 0; i < 20; ++i) {
    idle.push_back(std::make_unique<RawClient>(web.address()));
    idle.back()->send("GET /mesh.ply HTTP/1.1\r\nHost: localhost\r\n\r\n");
  }
  const std::string reply = web.get("/mesh.ply");
  EXPECT_TRUE(reply.ends_with("\r\n\r\n" + large));
  EXPECT_EQ(web.server().terminate(), 0);
}

TEST(ServerWeb, SpeaksTlsWithItsOwnCertificateAndReadsItAgain) {
  Authority authority;
  const Certificate own = authority.issue("web", "DNS:au.example,DNS:localhost");
  const TempFolder folder;
  const auto put = [&folder](const Certificate& from) {
    const auto over = std::filesystem::copy_options::overwrite_existing;
    std::filesystem::copy_file(from.file, folder.path() / "cert.pem", over);
    std::filesystem::copy_file(from.key, folder.path() / "key.pem", over);
  };
  put(own);
  Web web({"--web-cert", (folder.path() / "cert.pem").string(), "--web-key",
           (folder.path() / "key.pem").string()});
  const auto context = tls::Context::for_client({{}, {}, authority.file()});
  ASSERT_TRUE(context);
  const auto play = [&](const std::string& host) {
    TlsClient client(web.address(), *context, host);
    if (!client.shake_hands(web.request(host))) return std::string("no TLS");
    const std::string answer = client.receive_until("\r\n\r\n");
    client.send(client_text("{hello v=2 window=8}"));
    const std::string hello = client.receive_until("}");
    return answer.substr(0, 13) + hello.substr(std::min(hello.find('{'), hello.size()), 10);
  };
  EXPECT_EQ(play("au.example"), "HTTP/1.1 101 {hello v=2");
  EXPECT_TRUE(web.ask(web.request({})).find("https and wss only") != std::string::npos);
  put(authority.issue("renewed", "DNS:renewed.example"));
  EXPECT_EQ(play("renewed.example"), "no TLS");
  web.server().process().signal(SIGHUP);
  EXPECT_TRUE(logs(web.server(), "certificates and token were read again"));
  EXPECT_EQ(play("renewed.example").substr(0, 13), "HTTP/1.1 101 ");
  RawClient tcp = web.server().connect();
  expect_six_packets(tcp);
  EXPECT_EQ(web.server().terminate(), 0);
}

TEST(ServerWeb, NodesOwnWebSocketPlaysAStream) {
  const Finished probe = run({"/usr/bin/env", "node", "--experimental-websocket", "-e",
                              "process.exit(typeof WebSocket === 'function' ? 0 : 1)"});
  if (probe.exit_code != 0) GTEST_SKIP() << "no node with a WebSocket of its own (20 or later)";
  Authority authority;
  const Certificate own = authority.issue("web", "DNS:localhost");
  Web plain;
  Web secure({"--web-cert", own.file, "--web-key", own.key});
  const auto port = [](const Web& web) {
    return web.address().substr(web.address().rfind(':') + 1);
  };
  for (const std::string& url :
       {"ws://" + plain.address() + "/aucast", "wss://localhost:" + port(secure) + "/aucast"}) {
    const Finished played =
        run({"/usr/bin/env", "node", "--experimental-websocket", AUCAST_WEB_CLIENT, url},
            {"NODE_EXTRA_CA_CERTS=" + authority.file()});
    std::string expected;
    for (const std::string& packet : kSixPackets) expected += packet + "\n";
    EXPECT_TRUE(played.out.ends_with("}\n" + expected + kEnd + "\nclosed 1000\n"))
        << url << "\n"
        << played.out << played.err;
  }
  EXPECT_EQ(plain.server().terminate(), 0);
  EXPECT_EQ(secure.server().terminate(), 0);
}

TEST(ServerWeb, OptionsThatDoNotFitEndTheStart) {
  const auto start = [](std::vector<std::string> more) {
    more.insert(more.begin(), {program("au-transmitter"), "--port", "0"});
    more.push_back(stream_file("six_expressions.txt"));
    return run(std::move(more));
  };
  EXPECT_EQ(start({"--web", "8080"}).exit_code, 2);
  EXPECT_EQ(start({"--web-host", "a"}).exit_code, 2);
  EXPECT_EQ(start({"--web", "127.0.0.1:0", "--web-cert", "a.pem"}).exit_code, 2);
  EXPECT_EQ(start({"--web", "127.0.0.1:0", "--web-trusted-proxy", "proxy"}).exit_code, 2);
  const Finished unread =
      start({"--web", "127.0.0.1:0", "--web-cert", "/nowhere/a.pem", "--web-key", "b"});
  EXPECT_EQ(unread.exit_code, 4);
  EXPECT_NE(unread.err.find("(--web-cert)"), std::string::npos) << unread.err;
  Web web;
  const Finished taken = start({"--web", web.address()});
  EXPECT_EQ(taken.exit_code, 5);
  EXPECT_NE(taken.err.find("choose one with --web"), std::string::npos) << taken.err;
  EXPECT_EQ(web.server().terminate(), 0);
}

}  // namespace
}  // namespace aucast::test

// au-transmitter's status by HTTP: while it streams, to good and to bad requests.
#include <memory>
#include <regex>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/integration/server_running.h"
#include "tests/support/eventually.h"

namespace aucast::test {
namespace {

using namespace std::chrono_literals;

class ServerHttp : public ::testing::Test {
 protected:
  ServerHttp() : server_({"--http", "127.0.0.1:0", stream_file("six_expressions.txt")}) {
    const std::regex line("status at http://([0-9.:]+)/");
    EXPECT_TRUE(eventually([&] {
      static_cast<void>(server_.process().wait(1ms));  // reads the log
      std::smatch match;
      const std::string log = server_.log();
      if (std::regex_search(log, match, line)) address_ = match[1];
      return !address_.empty();
    })) << server_.log();
  }

  [[nodiscard]] std::string ask(const std::string& request) const {
    RawClient client(address_);
    client.send(request);
    return client.receive_all();
  }
  [[nodiscard]] std::string get(const std::string& path) const {
    return ask("GET " + path + " HTTP/1.1\r\nHost: " + address_ + "\r\n\r\n");
  }
  [[nodiscard]] static std::string body(const std::string& reply) {
    const std::size_t end = reply.find("\r\n\r\n");
    return end == std::string::npos ? "" : reply.substr(end + 4);
  }
  /// The status is at most a quarter of a second old: asks until it says so.
  [[nodiscard]] bool shows(const std::string& line) const {
    return eventually([&] { return body(get("/metrics")).find(line) != std::string::npos; });
  }

  RunningTransmitter server_;
  std::string address_;
};

TEST_F(ServerHttp, AnswersWhatAMonitorAsks) {
  EXPECT_TRUE(get("/healthz").starts_with("HTTP/1.1 200 OK\r\n"));
  EXPECT_EQ(body(get("/healthz")), "ok\n");
  {
    RawClient client = server_.connect();
    expect_six_packets(client);
  }
  RawClient waiting = server_.connect();
  EXPECT_EQ(waiting.receive_until("}"), kSixPackets[0]);
  EXPECT_TRUE(shows("\naucast_clients 1.0\n"));
  EXPECT_TRUE(shows("\naucast_connects_total 2\n"));
  EXPECT_TRUE(shows("\naucast_disconnects_total{reason=\"finished\"} 1\n"));
  EXPECT_TRUE(shows("\naucast_packets_total 7\n"));
  const auto status = nlohmann::json::parse(body(get("/status.json")), nullptr, false);
  ASSERT_FALSE(status.is_discarded());
  EXPECT_EQ(status["streams"], nlohmann::json({"six_expressions"}));
  EXPECT_EQ(status["clients"], 1);
  EXPECT_GT(status["bytes_total"], 60);
  EXPECT_EQ(server_.terminate(), 0);
}

TEST_F(ServerHttp, BadRequestsAreRefused) {
  EXPECT_TRUE(get("/nothing").starts_with("HTTP/1.1 404 "));
  EXPECT_TRUE(get("/../etc/passwd").starts_with("HTTP/1.1 404 "));
  EXPECT_TRUE(ask("POST / HTTP/1.1\r\nHost: a\r\n\r\n").starts_with("HTTP/1.1 405 "));
  EXPECT_TRUE(ask("GET / HTTP/9.9\r\nHost: a\r\n\r\n").starts_with("HTTP/1.1 505 "));
  EXPECT_TRUE(ask("GET /" + std::string(100'000, 'x')).starts_with("HTTP/1.1 431 "));
  EXPECT_TRUE(ask(std::string("\0\1\2\n", 4)).starts_with("HTTP/1.1 400 "));
  EXPECT_EQ(body(ask("HEAD /metrics HTTP/1.0\r\n\r\n")), "");
  EXPECT_EQ(body(ask("HEAD /metrics HTTP/2.0\r\n\r\n")), "") << "refused";
  EXPECT_EQ(server_.terminate(), 0);
}

TEST_F(ServerHttp, SlowAndManyAskersDisturbNobody) {
  std::vector<std::unique_ptr<RawClient>> crowd;
  for (int i = 0; i < 100; ++i) {
    crowd.push_back(std::make_unique<RawClient>(address_));
    crowd.back()->send("GET /heal");
  }
  RawClient client = server_.connect();
  expect_six_packets(client);
  for (const auto& asker : crowd) EXPECT_TRUE(asker->wait_for_end()) << "closed for its slowness";
  EXPECT_EQ(body(get("/healthz")), "ok\n");
  EXPECT_EQ(server_.terminate(), 0);
}

TEST_F(ServerHttp, ManySilentOnesShutNoMonitorOut) {
  std::vector<std::unique_ptr<RawClient>> crowd;
  for (int i = 0; i < 40; ++i) {
    crowd.push_back(std::make_unique<RawClient>(address_));
    EXPECT_EQ(body(get("/healthz")), "ok\n") << i;
  }
  EXPECT_TRUE(crowd.front()->wait_for_end());
  EXPECT_EQ(server_.terminate(), 0);
}

TEST_F(ServerHttp, RequestsForOtherHostsAreRefused) {
  const std::string reply = ask("GET /status.json HTTP/1.1\r\nHost: evil.example\r\n\r\n");
  EXPECT_TRUE(reply.starts_with("HTTP/1.1 421 ")) << reply;
  EXPECT_EQ(reply.find("streams"), std::string::npos);
  EXPECT_NE(body(reply).find("use its IP address or localhost"), std::string::npos);
  EXPECT_EQ(body(ask("GET /healthz HTTP/1.1\r\nHost: localhost\r\n\r\n")), "ok\n");
  EXPECT_EQ(server_.terminate(), 0);
}

TEST_F(ServerHttp, StopDoesNotWaitForAskers) {
  RawClient idle(address_);
  idle.send("GET /");
  EXPECT_EQ(body(get("/healthz")), "ok\n");
  EXPECT_EQ(server_.terminate(), 0);
}

TEST(ServerHttpOff, NothingIsAnsweredUnlessAsked) {
  RunningTransmitter server({stream_file("six_expressions.txt")});
  RawClient client = server.connect();
  client.send("GET /healthz HTTP/1.1\r\nHost: a\r\n\r\n");
  EXPECT_EQ(client.receive_all().find("HTTP"), std::string::npos);
  EXPECT_EQ(server.terminate(), 0);
  EXPECT_EQ(server.log().find("http"), std::string::npos);
}

TEST(ServerHttpOff, AddressThatIsTakenEndsTheStart) {
  RunningTransmitter server({stream_file("six_expressions.txt")});
  const Finished second = run({program("au-transmitter"), "--port", "0", "--http", server.address(),
                               stream_file("six_expressions.txt")});
  EXPECT_EQ(second.exit_code, 5);
  EXPECT_NE(second.err.find("choose one with --http"), std::string::npos) << second.err;
  EXPECT_EQ(second.out, "");
  EXPECT_EQ(run({program("au-transmitter"), "--http", "9465", "a.txt"}).exit_code, 2);
}

}  // namespace
}  // namespace aucast::test

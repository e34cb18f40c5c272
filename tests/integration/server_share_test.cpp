// Several au-transmitters on one port, and one that leaves its clients to the next.
#include <memory>

#include <gtest/gtest.h>

#include "tests/integration/server_running.h"

namespace aucast::test {
namespace {

constexpr int kExitNetwork = 5;

/// Another au-transmitter on the port of `server`.
class Neighbour {
 public:
  Neighbour(const RunningTransmitter& server, std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {program("au-transmitter"), "--port", server.port()});
    process_ = std::make_unique<Process>(std::move(arguments));
    ready_ = process_->read_line(kPatience) == "listening on " + server.address();
  }
  [[nodiscard]] bool ready() const { return ready_; }
  [[nodiscard]] Process& process() { return *process_; }

 private:
  std::unique_ptr<Process> process_;
  bool ready_ = false;
};

TEST(ServerShare, ClientsOfOnePortComeToBothAndToWhoIsLeft) {
  RunningTransmitter first({"-v", "--reuse-port", stream_file("talk.txt")});
  Neighbour second(first, {"-v", "--reuse-port", stream_file("talk.txt")});
  ASSERT_TRUE(second.ready()) << second.process().err();
  // The system chooses by the ports of both ends: that all of 64 go one way will not happen.
  std::vector<RawClient> clients;
  for (int n = 0; n < 64; ++n) {
    clients.push_back(first.connect());
    EXPECT_FALSE(clients.back().receive_until("}").empty());
  }
  EXPECT_EQ(first.terminate(), 0);
  int ended = 0;
  for (RawClient& client : clients) {
    client.send("1");
    if (client.receive_until("}") == kEnd) ++ended;
  }
  EXPECT_GT(ended, 0) << "some were the first's";
  EXPECT_LT(ended, 64) << "and some the second's, which play on";
  for (int n = 0; n < 8; ++n) EXPECT_FALSE(first.connect().receive_until("}").empty());
  second.process().signal(SIGTERM);
  EXPECT_EQ(second.process().wait(kPatience), 0);
}

TEST(ServerShare, TheListenersOfOneDoNotShareAPort) {
  const auto refusal = [](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {program("au-transmitter"), stream_file("talk.txt")});
    const Finished refused = run(std::move(arguments));
    EXPECT_EQ(refused.exit_code, 2) << refused.err;
    return refused.err;
  };
  const auto says = [&](const std::vector<std::string>& arguments, const std::string& what) {
    const std::string said = refusal(arguments);
    EXPECT_NE(said.find(what), std::string::npos) << said;
  };
  RunningTransmitter taken({stream_file("talk.txt")});
  const std::string port = taken.port();
  says({"--reuse-port", "--port", port, "--http", "127.0.0.1:" + port}, "--port and --http");
  says({"--port", port, "--web", "0.0.0.0:" + port}, "--port and --web have one port, " + port);
  says({"--port", "0", "--web", "localhost:" + port, "--http", "[::]:" + port}, "--web and --http");
  RunningTransmitter any(
      {"--http", "127.0.0.1:0", "--web", "127.0.0.1:0", stream_file("talk.txt")});
  EXPECT_EQ(any.terminate(), 0) << "0 is any free port";
}

TEST(ServerShare, BothHaveToSaySo) {
  RunningTransmitter alone({stream_file("talk.txt")});
  Neighbour eager(alone, {"--reuse-port", stream_file("talk.txt")});
  EXPECT_EQ(eager.process().wait(kPatience), kExitNetwork);
  EXPECT_NE(eager.process().err().find("all that share it need --reuse-port and one user"),
            std::string::npos)
      << eager.process().err();
  RunningTransmitter shared({"--reuse-port", stream_file("talk.txt")});
  Neighbour other(shared, {stream_file("talk.txt")});
  EXPECT_EQ(other.process().wait(kPatience), kExitNetwork);
}

TEST(ServerShare, WhoLeavesSendsItsClientsToTheOther) {
  RunningTransmitter first({"--reuse-port", "--drain-time", "0.3", stream_file("talk.txt")});
  const std::string hello = "{hello v=2 window=1}";
  std::vector<RawClient> clients;
  std::string reply;
  for (int n = 0; n < 10; ++n) {
    clients.push_back(say_hello(first, hello, reply));
    EXPECT_FALSE(clients.back().receive_until("}").empty());
  }
  RawClient classic = first.connect();
  EXPECT_FALSE(classic.receive_until("}").empty());
  Neighbour second(first, {"--reuse-port", stream_file("talk.txt")});
  ASSERT_TRUE(second.ready()) << second.process().err();
  first.process().signal(SIGTERM);
  EXPECT_TRUE(
      logs(first, "sending 10 clients to other servers within 0.3 s; 1 other cannot be sent"));
  for (RawClient& client : clients) {
    EXPECT_EQ(client.receive_all(), "") << "no {-2}: the stream goes on";
    EXPECT_FALSE(client.broken());
  }
  EXPECT_EQ(classic.receive_all(), kEnd) << "it could not come again where it was";
  EXPECT_EQ(first.process().wait(kPatience), 0);
  EXPECT_NE(first.log().find("closed: sent away"), std::string::npos);
  for (int n = 0; n < 10; ++n) {
    const RawClient again = say_hello(first, "{hello v=2 window=1 from=500}", reply);
    EXPECT_TRUE(reply.starts_with("{hello ")) << reply;
  }
  second.process().signal(SIGTERM);
  EXPECT_EQ(second.process().wait(kPatience), 0);
}

TEST(ServerShare, ASecondSignalEndsTheWaitForClients) {
  RunningTransmitter server({"--drain-time", "3600", stream_file("talk.txt")});
  std::string reply;
  RawClient client = say_hello(server, "{hello v=2 window=1}", reply);
  EXPECT_FALSE(client.receive_until("}").empty());
  server.process().signal(SIGTERM);
  EXPECT_TRUE(logs(server, "to other servers"));
  EXPECT_TRUE(client.silent(std::chrono::milliseconds(100)));
  server.process().signal(SIGTERM);
  EXPECT_EQ(client.receive_all(), kEnd);
  EXPECT_EQ(server.process().wait(kPatience), 0);
}

}  // namespace
}  // namespace aucast::test

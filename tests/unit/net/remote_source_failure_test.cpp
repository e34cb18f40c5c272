// Servers that cannot be reached, fall silent, break off or talk nonsense: each ends with its
// reason and a sentence that names the place, and what came before is still played.

#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>

#include <gtest/gtest.h>

#include "client/net/remote_source.h"
#include "tests/support/eventually.h"
#include "tests/support/loopback.h"
#include "tests/support/sanitized.h"
#include "tests/support/scripted_server.h"
#include "tests/unit/net/remote_fixture.h"

namespace aucast::net {
namespace {

using namespace std::chrono_literals;
using namespace aucast::test;
using namespace test;
using playback::EndReason;
using playback::SourceStatus;
using Aus = std::vector<int>;

/// A port on which nobody listens: bound, so that nobody else takes it meanwhile.
class DeafPort {
 public:
  DeafPort() = default;
  ~DeafPort() { ::close(socket_.descriptor); }
  DeafPort(const DeafPort&) = delete;
  DeafPort& operator=(const DeafPort&) = delete;

  [[nodiscard]] std::uint16_t port() const { return socket_.port; }

 private:
  LoopbackSocket socket_ = bind_to_loopback();
};

bool holds(const SourceStatus& status, const std::string& text) {
  return status.detail.find(text) != std::string::npos;
}

/// Plays the steps against a classic player; the keyframes and how it ended.
SourceStatus status_after(std::vector<Step> steps, const Aus& expected) {
  ScriptedServer server(std::move(steps));
  RemoteSource source(options_for(server.port(), true));
  EXPECT_EQ(take_all(source), expected);
  EXPECT_EQ(server.finish(), "");
  const SourceStatus status = source.status();
  EXPECT_TRUE(holds(status, "127.0.0.1:" + std::to_string(server.port()))) << status.detail;
  EXPECT_FALSE(status.connected);
  return status;
}

TEST(RemoteSourceFailure, RefusedPort) {
  const DeafPort deaf;
  RemoteSource source(options_for(deaf.port()));
  EXPECT_TRUE(source.wait_until(patience()));
  EXPECT_FALSE(source.take());
  const auto status = source.status();
  EXPECT_EQ(status.end, EndReason::Unreachable);
  EXPECT_TRUE(holds(
      status, "cannot reach 127.0.0.1:" + std::to_string(deaf.port()) + ": Connection refused"))
      << status.detail;
  EXPECT_TRUE(holds(status, "is au-transmitter running there")) << status.detail;
}

TEST(RemoteSourceFailure, RefusedOnEveryAddressOfAName) {
  const DeafPort deaf;
  RemoteOptions options = options_for(deaf.port());
  options.host = "localhost";
  RemoteSource source(options);
  EXPECT_TRUE(source.wait_until(patience()));
  EXPECT_EQ(source.status().end, EndReason::Unreachable);
  EXPECT_TRUE(holds(source.status(), "localhost:" + std::to_string(deaf.port())));
}

TEST(RemoteSourceFailure, UnknownHost) {
  RemoteOptions options = options_for(4650);
  options.host = "no-such-host.invalid";
  RemoteSource source(options);
  EXPECT_TRUE(source.wait_until(patience()));
  const auto status = source.status();
  EXPECT_EQ(status.end, EndReason::Unreachable);
  EXPECT_TRUE(holds(status, "cannot reach no-such-host.invalid:4650: ")) << status.detail;
}

TEST(RemoteSourceFailure, Ipv6InItsBrackets) {
  RemoteOptions options = options_for(1);
  options.host = "::1";
  RemoteSource source(options);
  EXPECT_TRUE(source.wait_until(patience()));
  EXPECT_EQ(source.status().end, EndReason::Unreachable);
  EXPECT_TRUE(holds(source.status(), "cannot reach [::1]:1: ")) << source.status().detail;
}

TEST(RemoteSourceFailure, NoDescriptorLeft) {
  if (kSanitized) GTEST_SKIP() << "a sanitizer looks at an exception with descriptors of its own";
  rlimit usual{};
  ASSERT_EQ(::getrlimit(RLIMIT_NOFILE, &usual), 0);
  const int next = ::dup(STDERR_FILENO);
  ::close(next);
  rlimit none_left = usual;
  none_left.rlim_cur = static_cast<rlim_t>(next);
  ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &none_left), 0);
  RemoteSource source(options_for(1));
  ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &usual), 0);
  EXPECT_TRUE(source.wait_until(patience()));
  EXPECT_FALSE(source.take());
  EXPECT_EQ(source.status().end, EndReason::Refused);
  EXPECT_TRUE(holds(source.status(), "Too many open files")) << source.status().detail;
  source.stop();
}

TEST(RemoteSourceFailure, WithReconnectItOutlivesAShortageOfDescriptors) {
  if (kSanitized) GTEST_SKIP() << "a sanitizer looks at an exception with descriptors of its own";
  const DeafPort deaf;
  RemoteOptions options = options_for(deaf.port());
  options.reconnect = true;
  RemoteSource source(options);
  const auto waits_for = [&source](const std::string& cause) {
    return eventually([&] { return holds(source.status(), cause); });
  };
  ASSERT_TRUE(waits_for("Connection refused")) << source.status().detail;
  rlimit usual{};
  ASSERT_EQ(::getrlimit(RLIMIT_NOFILE, &usual), 0);
  const int next = ::dup(STDERR_FILENO);
  ::close(next);
  rlimit none_left = usual;
  none_left.rlim_cur = static_cast<rlim_t>(next);
  ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &none_left), 0);
  EXPECT_TRUE(waits_for("Too many open files")) << source.status().detail;
  ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &usual), 0);
  EXPECT_TRUE(waits_for("Connection refused")) << source.status().detail;
  EXPECT_EQ(source.status().end, EndReason::NotEnded);
}

TEST(RemoteSourceFailure, SilentServer) {
  for (const bool classic : {true, false}) {
    ScriptedServer server({Accept{}, ExpectEnd{}});
    RemoteOptions options = options_for(server.port(), classic);
    options.connect_timeout = 50ms;
    RemoteSource source(options);
    EXPECT_TRUE(source.wait_until(patience()));
    EXPECT_EQ(source.status().end, EndReason::Unreachable);
    EXPECT_TRUE(holds(source.status(), "nothing came from the server within 50 ms"))
        << source.status().detail;
    EXPECT_EQ(server.finish(), "");
  }
}

// A listener whose queue is full answers nothing: what a firewall that drops looks like.
TEST(RemoteSourceFailure, NoAnswerAtAll) {
  const LoopbackSocket listener = listen_on_loopback(0);
  const sockaddr_in address = loopback(listener.port);
  const int filler = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  ASSERT_EQ(::connect(filler, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);

  RemoteOptions options = options_for(listener.port);
  options.connect_timeout = 50ms;
  RemoteSource source(options);
  EXPECT_TRUE(source.wait_until(patience()));
  EXPECT_EQ(source.status().end, EndReason::Unreachable);
  EXPECT_TRUE(holds(source.status(), "no answer within 50 ms") ||
              holds(source.status(), "nothing came from the server within 50 ms"))
      << source.status().detail;
  ::close(filler);
  ::close(listener.descriptor);
}

TEST(RemoteSourceFailure, ClosedMidPacket) {
  const auto status = status_after(
      {Accept{}, Send{"{1}"}, Expect{"1"}, Send{"{2}"}, Expect{"1"}, Send{"{4,1"}, Close{}},
      {1, 2});
  EXPECT_EQ(status.end, EndReason::ConnectionLost);
  EXPECT_TRUE(holds(status, "within a packet")) << status.detail;
}

TEST(RemoteSourceFailure, ResetMidStream) {
  const auto status =
      status_after({Accept{}, Send{"{1}"}, Expect{"1"}, Send{"{2}"}, Expect{"1"}, Reset{}}, {1, 2});
  EXPECT_EQ(status.end, EndReason::ConnectionLost);
  EXPECT_EQ(status.keyframes_received, 2U);
}

TEST(RemoteSourceFailure, ClosedWithAPacketKeptBack) {
  ScriptedServer server({Accept{}, Send{"{1}"}, Expect{"1"}, Send{"{2}"}, Expect{"1"}, Send{"{4}"},
                         Expect{"-1"}, Close{}});
  RemoteOptions options = options_for(server.port(), true);
  options.buffers = {1, 1, 100};
  RemoteSource source(options);
  EXPECT_EQ(server.finish(), "");
  EXPECT_EQ(take_all(source), (Aus{1, 2, 4}));
  EXPECT_EQ(source.status().end, EndReason::ConnectionLost);
}

TEST(RemoteSourceFailure, Garbage) {
  const auto status =
      status_after({Accept{}, Send{"{1}"}, Expect{"1"}, Send{"HTTP/1.1 200 OK\r\n"}}, {1});
  EXPECT_EQ(status.end, EndReason::ProtocolError);
  EXPECT_TRUE(holds(status, "at byte 3")) << status.detail;
  EXPECT_TRUE(holds(status, "is it an au-transmitter?")) << status.detail;
}

TEST(RemoteSourceFailure, GarbageIsEscaped) {
  const auto status = status_after({Accept{}, Send{"{1}"}, Expect{"1"}, Send{"\x1b]0;boo\a"}}, {1});
  EXPECT_EQ(status.end, EndReason::ProtocolError);
  EXPECT_TRUE(holds(status, "\\x1b")) << status.detail;
  EXPECT_FALSE(holds(status, "\x1b"));
}

TEST(RemoteSourceFailure, TenMegabytesWithoutABrace) {
  const auto status = status_after({Accept{}, Send{std::string(10'000'000, '1')}}, {});
  EXPECT_EQ(status.end, EndReason::ProtocolError);
}

TEST(RemoteSourceFailure, TenMegabytesInOnePacket) {
  const auto status = status_after({Accept{}, Send{"{1" + std::string(10'000'000, ' ')}}, {});
  EXPECT_EQ(status.end, EndReason::ProtocolError);
}

TEST(RemoteSourceFailure, AnAuAboveNinetyNine) {
  const auto status = status_after({Accept{}, Send{"{1,100}"}}, {});
  EXPECT_EQ(status.end, EndReason::ProtocolError);
}

TEST(RemoteSourceFailure, EndFirst) {
  const auto status = status_after({Accept{}, Send{"{-2}"}, ExpectEnd{}}, {});
  EXPECT_EQ(status.end, EndReason::EndOfStream);
}

TEST(RemoteSourceFailure, Refused) {
  ScriptedServer server({Accept{}, ExpectHello{}, Send{"{error 404 no stream of that name}"},
                         HalfClose{}, ExpectEnd{}});
  RemoteSource source(options_for(server.port()));
  EXPECT_EQ(take_all(source), Aus{});
  EXPECT_EQ(source.status().end, EndReason::Refused);
  EXPECT_TRUE(holds(source.status(), "404 no stream of that name")) << source.status().detail;
  EXPECT_EQ(server.finish(), "");
}

TEST(RemoteSourceFailure, ClosesAtOnceTwice) {
  ScriptedServer server({Accept{}, Close{}, Accept{}, Close{}});
  RemoteSource source(options_for(server.port()));
  EXPECT_EQ(take_all(source), Aus{});
  EXPECT_EQ(source.status().end, EndReason::ConnectionLost) << source.status().detail;
  EXPECT_EQ(server.finish(), "");
}

TEST(RemoteSourceFailure, OfSeveralHostsTheNextIsTaken) {
  const DeafPort deaf;
  ScriptedServer server(
      {Accept{}, Send{"{1}"}, Expect{"1"}, Send{"{2}"}, Expect{"1"}, Send{"{-2}"}, HalfClose{}});
  RemoteOptions options = options_for(deaf.port(), true);
  options.others = {{"127.0.0.1", server.port()}};
  options.reconnect = true;
  RemoteSource source(std::move(options));
  EXPECT_EQ(take_all(source), (Aus{1, 2}));
  EXPECT_EQ(source.status().end, EndReason::EndOfStream);
}

TEST(RemoteSourceFailure, WhenAHostIsFullTheNextIsTaken) {
  ScriptedServer full(
      {Accept{}, ExpectHello{}, Send{"{error 503 the server is full}"}, HalfClose{}, ExpectEnd{}});
  ScriptedServer server({Accept{}, ExpectHello{}, Send{"{hello v=2 window=1}{1}"}, Expect{"1"},
                         Send{"{-2}"}, HalfClose{}});
  RemoteOptions options = options_for(full.port());
  options.others = {{"127.0.0.1", server.port()}};
  options.reconnect = true;
  RemoteSource source(std::move(options));
  EXPECT_EQ(take_all(source), Aus{1});
  EXPECT_EQ(source.status().end, EndReason::EndOfStream) << source.status().detail;
}

}  // namespace
}  // namespace aucast::net

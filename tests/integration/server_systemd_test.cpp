// au-transmitter under a service manager; the tests play systemd's part.
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <regex>

#include <gtest/gtest.h>

#include "tests/integration/server_running.h"
#include "tests/support/temp_folder.h"

namespace aucast::test {
namespace {

using namespace std::chrono_literals;

/// The socket that NOTIFY_SOCKET names.
class NotifySocket {
 public:
  explicit NotifySocket(const std::string& path) : socket_(::socket(AF_UNIX, SOCK_DGRAM, 0)) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    path.copy(address.sun_path, sizeof(address.sun_path) - 1);
    EXPECT_EQ(::bind(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof(address)), 0);
  }
  ~NotifySocket() { ::close(socket_); }
  NotifySocket(const NotifySocket&) = delete;
  NotifySocket& operator=(const NotifySocket&) = delete;

  /// The next message that has `part` in it; empty when none comes.
  [[nodiscard]] std::string wait_for(const std::string& part) const {
    const auto until = std::chrono::steady_clock::now() + kPatience;
    while (std::chrono::steady_clock::now() < until) {
      pollfd waiting{socket_, POLLIN, 0};
      if (::poll(&waiting, 1, 100) <= 0) continue;
      std::array<char, 4096> bytes{};
      const ssize_t got = ::recv(socket_, bytes.data(), bytes.size(), 0);
      if (got <= 0) continue;
      const std::string message(bytes.data(), static_cast<std::size_t>(got));
      if (message.find(part) != std::string::npos) return message;
    }
    return {};
  }

 private:
  int socket_;
};

TEST(ServerSystemd, IsToldOfEveryChange) {
  const TempFolder folder;
  const std::string path = (folder.path() / "notify").string();
  const NotifySocket manager(path);
  Process process({program("au-transmitter"), "--port", "0", stream_file("happiness.txt")},
                  {"NOTIFY_SOCKET=" + path, "WATCHDOG_USEC=200000"});
  EXPECT_EQ(manager.wait_for("READY=1"), "READY=1\nSTATUS=0 clients, 1 stream");
  for (int beat = 0; beat < 3; ++beat) EXPECT_EQ(manager.wait_for("WATCHDOG=1"), "WATCHDOG=1");
  EXPECT_EQ(manager.wait_for("STATUS="), "STATUS=0 clients, 1 stream");
  const auto line = process.read_line(kPatience);
  ASSERT_TRUE(line);
  RawClient client(line->substr(line->rfind(' ') + 1));
  EXPECT_FALSE(client.receive_until("}").empty());
  EXPECT_FALSE(manager.wait_for("STATUS=1 client, 1 stream").empty());
  process.signal(SIGHUP);
  const std::string reloading = manager.wait_for("RELOADING=1");
  EXPECT_TRUE(std::regex_match(reloading, std::regex("RELOADING=1\nMONOTONIC_USEC=[0-9]+")));
  EXPECT_FALSE(manager.wait_for("READY=1").empty()) << "whatever came of the reload";
  process.signal(SIGTERM);
  EXPECT_EQ(manager.wait_for("STOPPING=1"), "STOPPING=1");
  EXPECT_EQ(process.wait(kPatience), 0);
}

TEST(ServerSystemd, WatchdogOfAnotherProcessIsNotFed) {
  const TempFolder folder;
  const std::string path = (folder.path() / "notify").string();
  const NotifySocket manager(path);
  Process process({program("au-transmitter"), "--port", "0", stream_file("happiness.txt")},
                  {"NOTIFY_SOCKET=" + path, "WATCHDOG_USEC=1000", "WATCHDOG_PID=1"});
  EXPECT_FALSE(manager.wait_for("READY=1").empty());
  EXPECT_EQ(manager.wait_for(""), "STATUS=0 clients, 1 stream") << "no WATCHDOG=1 before";
  process.signal(SIGTERM);
  EXPECT_EQ(process.wait(kPatience), 0);
}

TEST(ServerSystemd, ManagerThatIsNotThereHarmsNothing) {
  Process process({program("au-transmitter"), "--port", "0", stream_file("happiness.txt")},
                  {"NOTIFY_SOCKET=/nowhere/notify", "WATCHDOG_USEC=1000"});
  EXPECT_TRUE(process.read_line(kPatience)) << process.err();
  process.signal(SIGTERM);
  EXPECT_EQ(process.wait(kPatience), 0);
}

/// Python plays systemd: it listens, and the program it becomes finds the socket as descriptor 3.
std::vector<std::string> activated(const std::string& make_socket, const std::string& pid) {
  const std::string start =
      "import os, socket, sys\n"
      "s = " +
      make_socket +
      "\n"
      "os.dup2(s.fileno(), 3)\n"
      "os.set_inheritable(3, True)\n"
      "os.environ['LISTEN_FDS'] = '1'\n"
      "os.environ['LISTEN_PID'] = " +
      pid +
      "\n"
      "os.execv(sys.argv[1], sys.argv[1:])\n";
  // Port 1 would be refused or taken: it must not be tried.
  return {"python3",
          "-c",
          start,
          program("au-transmitter"),
          "--port",
          "1",
          stream_file("happiness.txt")};
}

TEST(ServerSystemd, SocketThatIsPassedIsServed) {
  Process process(activated("socket.create_server(('127.0.0.1', 0))", "str(os.getpid())"));
  const auto line = process.read_line(kPatience);
  ASSERT_TRUE(line && line->starts_with("listening on 127.0.0.1:")) << process.err();
  RawClient client(line->substr(line->rfind(' ') + 1));
  client.send("1");
  EXPECT_EQ(client.receive_all(), kSixPackets[4] + kEnd);
  process.signal(SIGTERM);
  EXPECT_EQ(process.wait(kPatience), 0);
}

TEST(ServerSystemd, SocketThatCannotBeServedIsSaid) {
  for (const char* socket : {"socket.socket(socket.AF_INET, socket.SOCK_DGRAM)",
                             "socket.socket(socket.AF_INET, socket.SOCK_STREAM)"}) {
    Process process(activated(socket, "str(os.getpid())"));
    EXPECT_EQ(process.wait(kPatience), 2);
    EXPECT_NE(process.err().find("not a listening TCP socket"), std::string::npos) << process.err();
  }
}

TEST(ServerSystemd, SocketsOfAnotherProcessAreLeftAlone) {
  const std::string held = "socket.create_server(('127.0.0.1', 0))";
  std::vector<std::string> arguments = activated(held, "'1'");
  arguments[5] = "0";  // the port
  Process process(arguments);
  ASSERT_TRUE(process.read_line(kPatience)) << process.err();
  EXPECT_EQ(process.err().find("passed the socket"), std::string::npos);
  process.signal(SIGTERM);
  EXPECT_EQ(process.wait(kPatience), 0);
}

}  // namespace
}  // namespace aucast::test

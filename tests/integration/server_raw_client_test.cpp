// The test client itself, against a listening socket of the test.
#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <string_view>

#include <gtest/gtest.h>

#include "tests/support/raw_client.h"

namespace aucast::test {
namespace {

using namespace std::chrono_literals;

/// A listener on the loopback and the connection it took last.
class Peer {
 public:
  Peer() : listener_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    address_.sin_family = AF_INET;
    address_.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t length = sizeof(address_);
    auto* address = reinterpret_cast<sockaddr*>(&address_);
    EXPECT_EQ(::bind(listener_, address, length), 0);
    EXPECT_EQ(::listen(listener_, 4), 0);
    EXPECT_EQ(::getsockname(listener_, address, &length), 0);
  }
  ~Peer() {
    ::close(listener_);
    close();
  }
  Peer(const Peer&) = delete;
  Peer& operator=(const Peer&) = delete;

  [[nodiscard]] std::string address() const {
    return "127.0.0.1:" + std::to_string(ntohs(address_.sin_port));
  }
  void accept() { connection_ = ::accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC); }
  void say(std::string_view bytes) const {
    EXPECT_EQ(::send(connection_, bytes.data(), bytes.size(), MSG_NOSIGNAL),
              static_cast<ssize_t>(bytes.size()));
  }
  /// The result of one recv(): bytes, 0 at the end, -1 when broken.
  [[nodiscard]] ssize_t hear() const {
    char byte = 0;
    return ::recv(connection_, &byte, 1, 0);
  }
  void close() {
    if (connection_ >= 0) ::close(connection_);
    connection_ = -1;
  }

 private:
  int listener_;
  int connection_ = -1;
  sockaddr_in address_{};
};

TEST(RawClient, TakesWhatIsAskedForAndKeepsTheRest) {
  Peer peer;
  RawClient client(peer.address());
  ASSERT_TRUE(client.ok());
  EXPECT_GT(client.local_port(), 0);
  peer.accept();
  peer.say("abc{d}efg");
  EXPECT_EQ(client.receive(2), "ab");
  EXPECT_EQ(client.receive_until("}"), "c{d}");
  EXPECT_EQ(client.receive(10, 50ms), "efg") << "fewer when no more comes";
  EXPECT_TRUE(client.silent(20ms));
  peer.say("last");
  peer.close();
  EXPECT_EQ(client.receive_all(), "last");
  EXPECT_TRUE(client.ended());
  EXPECT_FALSE(client.broken());
  EXPECT_FALSE(client.silent(20ms)) << "ended is not silent";
}

TEST(RawClient, WaitsForTheEndAndDropsTheRest) {
  Peer peer;
  RawClient client(peer.address());
  peer.accept();
  peer.say("dropped");
  EXPECT_FALSE(client.wait_for_end(50ms));
  peer.close();
  EXPECT_TRUE(client.wait_for_end());
  EXPECT_EQ(client.receive_all(), "");
}

TEST(RawClient, HalfCloseStillHears) {
  Peer peer;
  RawClient client(peer.address());
  peer.accept();
  client.end_sending();
  EXPECT_EQ(peer.hear(), 0);
  peer.say("more");
  EXPECT_EQ(client.receive(4), "more");
}

TEST(RawClient, ResetIsAReset) {
  Peer peer;
  RawClient client(peer.address());
  peer.accept();
  client.reset();
  EXPECT_EQ(peer.hear(), -1);
  EXPECT_FALSE(client.ok());
}

TEST(RawClient, NobodyThereIsNotOk) {
  std::string address;
  {
    const Peer peer;
    address = peer.address();
  }
  EXPECT_FALSE(RawClient(address).ok());
  EXPECT_FALSE(RawClient("nonsense").ok());
}

}  // namespace
}  // namespace aucast::test

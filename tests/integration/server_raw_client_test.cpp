// The test client itself, against a listening socket of the test.
#include <sys/socket.h>
#include <unistd.h>

#include <string_view>

#include <gtest/gtest.h>

#include "tests/support/loopback.h"
#include "tests/support/raw_client.h"

namespace aucast::test {
namespace {

using namespace std::chrono_literals;

/// A listener on the loopback and the connection it took last.
class Peer {
 public:
  Peer() = default;
  ~Peer() {
    ::close(listener_.descriptor);
    close();
  }
  Peer(const Peer&) = delete;
  Peer& operator=(const Peer&) = delete;

  [[nodiscard]] std::string address() const { return listener_.address(); }
  void accept() { connection_ = ::accept4(listener_.descriptor, nullptr, nullptr, SOCK_CLOEXEC); }
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
  LoopbackSocket listener_ = listen_on_loopback();
  int connection_ = -1;
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

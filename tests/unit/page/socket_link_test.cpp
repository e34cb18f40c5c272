#include "client/web/socket_link.h"

#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/page/fake_browser.h"

namespace aucast::web {
namespace {

using test::fake_browser;

/// Keeps what the link tells it.
class Kept final : public link::LinkUser {
 public:
  std::vector<std::string> told;

 private:
  void on_open() override { told.emplace_back("open"); }
  void on_bytes(std::string_view bytes) override { told.emplace_back(bytes); }
  void on_peer_end() override { told.emplace_back("peer end"); }
  void on_time() override { told.emplace_back("time"); }
  void on_closed(const link::Ending& ending) override {
    told.emplace_back(ending.why == link::Ending::Why::Finished ? "finished" : ending.reason);
  }
};

class SocketLinkTest : public testing::Test {
 protected:
  using Told = std::vector<std::string>;

  SocketLinkTest() {
    fake_browser() = {};
    link_->start(user_);
    socket_ = *fake_browser().sockets.begin();
  }
  ~SocketLinkTest() override { link_->close(); }
  void open() {
    SocketLink::opened(socket_);
    user_.told.clear();
  }

  Kept user_;
  std::shared_ptr<SocketLink> link_ = SocketLink::create();
  std::uint32_t socket_ = 0;
};

TEST_F(SocketLinkTest, HandsOutWhatComes) {
  link_->write("too early");
  SocketLink::opened(socket_);
  link_->write("hello");
  SocketLink::received(socket_, "a");
  SocketLink::received(socket_, "b");
  fake_browser().close(socket_);
  EXPECT_EQ(user_.told, (Told{"open", "a", "b", "peer end"}));
  EXPECT_EQ(fake_browser().sent[socket_], "hello");
}

TEST_F(SocketLinkTest, KeepsWhatComesWhileReadingIsOff) {
  open();
  link_->set_reading(false);
  SocketLink::received(socket_, "a");
  SocketLink::received(socket_, "b");
  fake_browser().close(socket_);
  EXPECT_EQ(user_.told, Told{});
  link_->set_reading(true);
  EXPECT_EQ(user_.told, Told{}) << "not within a call by its user";
  fake_browser().ring();
  EXPECT_EQ(user_.told, (Told{"ab", "peer end"}));
}

TEST_F(SocketLinkTest, ClosesWhenTheBrowserHasSentAll) {
  open();
  link_->finish();
  EXPECT_TRUE(fake_browser().ending.contains(socket_));
  SocketLink::received(socket_, "late");
  fake_browser().close(socket_);
  EXPECT_EQ(user_.told, Told{"finished"});
}

TEST_F(SocketLinkTest, ClosesTooWhenTheBrowsersSocketWasGoneBefore) {
  for (const bool reading : {false, true}) {
    SocketLinkTest::open();
    link_->set_reading(reading);
    fake_browser().close(socket_);
    EXPECT_EQ(user_.told, reading ? Told{"peer end"} : Told{});
    user_.told.clear();
    link_->finish();
    EXPECT_EQ(user_.told, Told{}) << "not within a call by its user";
    fake_browser().ring();
    EXPECT_EQ(user_.told, Told{"finished"}) << reading;
    link_ = SocketLink::create();
    link_->start(user_);
    socket_ = *fake_browser().sockets.begin();
  }
}

TEST_F(SocketLinkTest, SaysThatTheServerIsNotThere) {
  fake_browser().close(socket_);
  EXPECT_EQ(user_.told, Told{"it is not there, or does not let this page in"});
}

TEST_F(SocketLinkTest, IsLostWhenTheServerSendsMoreThanWasAskedFor) {
  open();
  link_->set_reading(false);
  SocketLink::received(socket_, std::string(SocketLink::kHeldMax, 'x'));
  EXPECT_EQ(user_.told, Told{});
  SocketLink::received(socket_, "x");
  EXPECT_EQ(user_.told, Told{"the server sends more than it was asked for"});
  EXPECT_FALSE(fake_browser().sockets.contains(socket_));
}

TEST_F(SocketLinkTest, SaysNothingAfterClose) {
  open();
  link_->wake_at(link_->now());
  link_->close();
  fake_browser().ring();
  SocketLink::received(socket_, "a");
  SocketLink::closed(socket_);
  EXPECT_EQ(user_.told, Told{});
}

}  // namespace
}  // namespace aucast::web

// Streams that are brought to a server which the test plays, on the same loop.
#include "server/push/pushers.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <asio/buffer.hpp>
#include <asio/ip/tcp.hpp>
#include <asio/read_until.hpp>
#include <asio/write.hpp>

#include "protocol/live_feed.h"
#include "tests/support/kept_log.h"
#include "tests/support/quiet_log.h"
#include "tests/support/run_until.h"

namespace aucast::server {
namespace {

using asio::ip::tcp;
using Why = protocol::CloseConnection::Why;

class PushersTest : public ::testing::Test {
 protected:
  PushSettings to(std::vector<std::string> addresses) {
    PushSettings settings;
    settings.addresses = std::move(addresses);
    return settings;
  }
  [[nodiscard]] std::string here() const {
    return "aucast://127.0.0.1:" + std::to_string(acceptor_.local_endpoint().port()) + "/one";
  }
  /// Takes whatever is brought.
  void accept() {
    acceptor_.async_accept([this](const std::error_code& error, tcp::socket socket) {
      if (error) return;
      auto peer = std::make_shared<tcp::socket>(std::move(socket));
      auto hello = std::make_shared<std::string>();
      asio::async_read_until(*peer, asio::dynamic_buffer(*hello), '}',
                             [this, peer, hello](const std::error_code& cut_off, std::size_t) {
                               if (cut_off) return;
                               hellos_.push_back(*hello);
                               std::error_code ignored;
                               asio::write(*peer, asio::buffer(kTakes), ignored);
                             });
      accept();
    });
  }
  /// Whether somebody has connected whom accept() has not taken.
  [[nodiscard]] bool knocked() {
    acceptor_.non_blocking(true);
    std::error_code error;
    static_cast<void>(acceptor_.accept(error));
    return !error;
  }
  [[nodiscard]] bool runs_until_taken(std::size_t times) {
    return test::run_until(io_, [&] { return served_.size() == times; });
  }
  /// Until it was looked so many times whether there is something to bring.
  [[nodiscard]] bool runs_until_asked(int times) {
    const int until = asked_ + times;
    return test::run_until(io_, [&] { return asked_ >= until; });
  }
  /// The connection that was taken last has ended, after so many keyframes.
  void end_last(protocol::CloseConnection::Why why, std::uint64_t keyframes) const {
    ClientRecord record;
    record.sent.keyframes = keyframes;
    record.end_reason = ClientEnd(why);
    served_.back()(record, "it was cut off");
  }

  static constexpr std::string_view kTakes = "{hello v=2 window=2 stream=one takes=1}";

  const test::QuietLog quiet_;
  asio::io_context io_;
  tcp::acceptor acceptor_{io_, {asio::ip::address_v4::loopback(), 0}};
  std::optional<protocol::ServedStream> stream_;
  int asked_ = 0;
  std::vector<std::string> hellos_;  ///< what those who were taken have said
  std::vector<Pusher::OnServed> served_;
  Pushers pushers_{
      io_,
      {[this](const std::string&) {
         ++asked_;
         return stream_ ? &*stream_ : nullptr;
       },
       [this](const std::string&, const std::string&, const std::shared_ptr<link::Link>& link,
              std::string_view, Pusher::OnServed on_served) {
         link->close();
         served_.push_back(std::move(on_served));
       }}};
};

TEST_F(PushersTest, EachAddressHasAConnectionOfItsOwn) {
  ASSERT_TRUE(pushers_.open(to({"aucast://a.example/one", "aucast://b.example:4651/two"}), 0));
  Status status;
  pushers_.describe(status);
  ASSERT_EQ(status.pushes.size(), 2U);
  EXPECT_EQ(status.pushes[0].stream, "one");
  EXPECT_EQ(status.pushes[0].server, "a.example:4650");
  EXPECT_EQ(status.pushes[1].stream, "two");
  EXPECT_EQ(status.pushes[1].server, "b.example:4651");
  EXPECT_FALSE(status.pushes[1].sending);
}

TEST_F(PushersTest, AnAddressThatIsNoneIsAUsageError) {
  const auto opened = pushers_.open(to({"aucast://"}), 0);
  ASSERT_FALSE(opened.has_value());
  EXPECT_EQ(opened.error().kind, ErrorKind::Usage);
}

TEST_F(PushersTest, NobodyIsDialledWhileThereIsNothingToBring) {
  ASSERT_TRUE(pushers_.open(to({here()}), 0));
  pushers_.start();
  EXPECT_TRUE(runs_until_asked(2));
  EXPECT_FALSE(knocked());
}

TEST_F(PushersTest, ALiveStreamThatHasEndedIsBroughtAgainWhenItGoesOn) {
  const auto feed = std::make_shared<protocol::LiveFeed>(250, 20);
  stream_ = protocol::ServedStream{"one", std::shared_ptr<const protocol::LiveChannel>(feed)};
  ASSERT_TRUE(pushers_.open(to({here()}), 0));
  pushers_.start();
  accept();
  ASSERT_TRUE(runs_until_taken(1));
  feed->end();
  end_last(Why::Finished, 1);
  EXPECT_TRUE(runs_until_asked(2));
  EXPECT_EQ(served_.size(), 1U) << "not before";
  feed->add({});
  EXPECT_TRUE(runs_until_taken(2));
}

TEST_F(PushersTest, EachIsKnownByAnIdOfItsOwnWheneverItComes) {
  stream_ = protocol::ServedStream{"one", std::make_shared<const protocol::LiveFeed>(250, 20)};
  ASSERT_TRUE(pushers_.open(to({here(), here()}), 0));
  pushers_.start();
  accept();
  ASSERT_TRUE(runs_until_taken(2));
  EXPECT_NE(hellos_[0], hellos_[1]) << "each would displace the other for ever";
  end_last(Why::PeerGone, 0);
  ASSERT_TRUE(runs_until_taken(3));
  EXPECT_TRUE(hellos_[2] == hellos_[0] || hellos_[2] == hellos_[1]) << "it has come back";
}

TEST_F(PushersTest, AFailureIsSaidAgainAfterTheOtherServerHadAllOfTheStream) {
  stream_ = protocol::ServedStream{"one", std::make_shared<const protocol::LiveFeed>(250, 20)};
  ASSERT_TRUE(pushers_.open(to({here()}), 0));
  pushers_.start();
  accept();
  const test::KeptLog log;
  ASSERT_TRUE(runs_until_taken(1));
  end_last(Why::PeerGone, 0);
  const std::string first = log.said();
  EXPECT_NE(first.find("it was cut off"), std::string::npos) << first;
  ASSERT_TRUE(runs_until_taken(2));
  end_last(Why::Finished, 0);
  ASSERT_TRUE(runs_until_taken(3));
  end_last(Why::PeerGone, 0);
  EXPECT_NE(log.said().substr(first.size()).find("it was cut off"), std::string::npos);
}

TEST_F(PushersTest, WithoutAddressesNothingIsWaitedFor) {
  ASSERT_TRUE(pushers_.open(to({}), 0));
  pushers_.start();
  EXPECT_EQ(io_.run(), 0U);
}

}  // namespace
}  // namespace aucast::server

#include "common/link/web_link.h"

#include <memory>

#include <gtest/gtest.h>

#include "tests/support/fake_link.h"
#include "tests/support/web_frames.h"
#include "tests/unit/link/recording_user.h"

namespace aucast::link {
namespace {

using namespace std::chrono_literals;
using aucast::test::client_frame;
using aucast::test::client_text;
using aucast::test::FakeLink;
using aucast::test::server_close;
using aucast::test::server_frame;
using aucast::test::server_text;
using test::RecordingUser;
using Why = Ending::Why;

/// A link over a fake one, whose first user has read the request.
class WebLinkTest : public ::testing::Test {
 protected:
  WebLinkTest() {
    below_->start(before_);
    below_->wake_at(below_->now() + 5s);
    says_.when_open = [this] { web_->write("{early}"); };
    web_->start(says_);
  }
  ~WebLinkTest() override { web_->close(); }

  std::shared_ptr<FakeLink> below_ = std::make_shared<FakeLink>();
  RecordingUser before_;
  RecordingUser says_;
  std::shared_ptr<Link> web_ =
      web_link(below_, "HTTP/1.1 101 \r\n\r\n",
               Limits{.frame_bytes = 1000, .ping_idle = 25s, .pong_time = 30s});
};

TEST_F(WebLinkTest, AnswersTheRequestAndTakesTheLinkOver) {
  EXPECT_TRUE(says_.opened);
  EXPECT_EQ(below_->heard(), "HTTP/1.1 101 \r\n\r\n" + server_text("{early}"));
  below_->say(client_text("{hello v=2}"));
  EXPECT_EQ(says_.heard, "{hello v=2}");
  EXPECT_EQ(before_.heard, "");
  below_->advance(6s);
  EXPECT_EQ(says_.times + before_.times, 0) << "the time of the request means nothing any more";
  web_->wake_at(web_->now() + 1s);
  below_->advance(1s);
  EXPECT_EQ(says_.times, 1);
}

TEST_F(WebLinkTest, AnswersPingsByItself) {
  static_cast<void>(below_->heard());
  below_->say(client_frame(0x89, "?"));
  EXPECT_EQ(says_.heard, "");
  EXPECT_EQ(below_->heard(), server_frame(0x8a, "?"));
}

TEST_F(WebLinkTest, ASilentPeerIsAskedWhetherItIsThere) {
  static_cast<void>(below_->heard());
  web_->wake_at(web_->now() + 40s);
  below_->advance(24999ms);
  EXPECT_EQ(below_->heard(), "");
  below_->advance(1ms);
  EXPECT_EQ(below_->heard(), server_frame(0x89, ""));
  below_->advance(20s);
  EXPECT_EQ(says_.times, 1) << "the user's own time";
  below_->say(client_frame(0x8a, ""));
  EXPECT_EQ(says_.heard, "");
  below_->advance(24999ms);
  EXPECT_EQ(below_->heard(), "");
  below_->advance(1ms);
  EXPECT_EQ(below_->heard(), server_frame(0x89, "")) << "25 s after the Pong";
  below_->say(client_frame(0x8a, ""));
  below_->advance(25s);
  EXPECT_EQ(below_->heard(), server_frame(0x89, "")) << "also after a quick one";
  below_->advance(29999ms);
  EXPECT_FALSE(below_->finished());
  below_->advance(1ms);
  EXPECT_TRUE(below_->finished());
  below_->end({});
  EXPECT_TRUE(says_.closed_as(Why::Lost));
  EXPECT_EQ(says_.ending->reason, "the client does not answer a Ping");
  EXPECT_EQ(below_->heard(), "");
}

TEST_F(WebLinkTest, WhoSpeaksIsNotAsked) {
  static_cast<void>(below_->heard());
  for (int code = 0; code < 10; ++code) {
    below_->say(client_text("1"));
    below_->advance(24s);
  }
  EXPECT_EQ(below_->heard(), "");
  below_->advance(1s);
  EXPECT_EQ(below_->heard(), server_frame(0x89, "")) << "25 s after its last word";
}

TEST_F(WebLinkTest, APingDoesNotStandInAQueue) {
  below_->take(0);
  web_->write("{1}");
  below_->advance(100s);
  EXPECT_EQ(web_->unsent_bytes(), 5U);
  EXPECT_FALSE(below_->finished()) << "TCP says when that peer is gone";
  static_cast<void>(below_->heard());
  below_->take(100);
  below_->advance(25s);
  EXPECT_EQ(below_->heard(), server_text("{1}") + server_frame(0x89, ""));
}

TEST_F(WebLinkTest, FinishClosesInOrder) {
  web_->write("{-2}");
  static_cast<void>(below_->heard());
  web_->finish();
  EXPECT_EQ(below_->heard(), server_close(1000));
  EXPECT_TRUE(below_->finished());
  web_->write("{1}");
  below_->say(client_frame(0x88, "\x03\xe8"));
  below_->end({});
  EXPECT_TRUE(says_.closed_as(Why::Finished));
  EXPECT_EQ(below_->heard(), "");
}

TEST_F(WebLinkTest, ThePeersCloseIsAnsweredAndTheUserHasLostIt) {
  static_cast<void>(below_->heard());
  below_->say(client_text("1") + client_frame(0x88, "\x03\xe9 bye"));
  EXPECT_EQ(says_.heard, "1");
  EXPECT_EQ(below_->heard(), server_close(1001));
  EXPECT_TRUE(below_->finished());
  web_->write("{1}");
  EXPECT_EQ(below_->heard(), "") << "nothing comes after a Close";
  below_->end({});
  EXPECT_TRUE(says_.closed_as(Why::Lost));
  EXPECT_FALSE(says_.failure || says_.peer_ended);
}

TEST_F(WebLinkTest, AnEndWithoutACloseIsALoss) {
  below_->end_sending();
  EXPECT_TRUE(below_->finished());
  below_->end({});
  EXPECT_TRUE(says_.closed_as(Why::Lost));
}

TEST_F(WebLinkTest, BrokenFramesAreAFailureThatThePeerIsTold) {
  static_cast<void>(below_->heard());
  below_->say(client_text("1") + server_text("1"));
  EXPECT_EQ(says_.heard, "1");
  EXPECT_EQ(below_->heard(), server_close(1002));
  ASSERT_TRUE(says_.failure);
  EXPECT_EQ(says_.failure->why, Why::WebSocketFailed);
  EXPECT_EQ(says_.failure->reason, "a frame is not masked");
  EXPECT_FALSE(says_.ending) << "the Close is drained first";
  below_->end({});
  EXPECT_TRUE(says_.closed_as(Why::WebSocketFailed));
}

TEST_F(WebLinkTest, AFailureBelowIsHandedOn) {
  below_->fail({Why::TlsFailed, "bad record"});
  ASSERT_TRUE(says_.failure);
  EXPECT_EQ(says_.failure->why, Why::TlsFailed);
  below_->end({});
  EXPECT_TRUE(says_.closed_as(Why::TlsFailed));
}

TEST_F(WebLinkTest, TellsWhenTheLinkBelowHasRoom) {
  static_cast<void>(below_->heard());
  below_->take(0);
  web_->write("{1}");
  EXPECT_TRUE(web_->blocked());
  EXPECT_EQ(web_->unsent_bytes(), 5U);
  below_->take(5);
  EXPECT_EQ(says_.rooms, 1);
}

}  // namespace
}  // namespace aucast::link

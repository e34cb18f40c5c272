// The page's source without a browser: the test is the server, and lets timers ring.
#include "client/web/socket_source.h"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "client/web/socket_link.h"
#include "tests/unit/page/fake_browser.h"

namespace aucast::web {
namespace {

using playback::EndReason;
using test::fake_browser;

class SocketSourceTest : public testing::Test {
 protected:
  SocketSourceTest() { fake_browser() = {}; }
  void begin(const std::string& token = {}, bool voice = false) {
    source_.emplace("lecture.example.org", "talk", token, voice);
    connect();
  }
  /// Lets the timer ring for which the source waits, and the socket open that it then wants.
  void connect() {
    ASSERT_TRUE(fake_browser().sockets.empty());
    fake_browser().ring();
    ASSERT_EQ(fake_browser().sockets.size(), 1U);
    socket_ = *fake_browser().sockets.begin();
    SocketLink::opened(socket_);
  }
  void say(const std::string& bytes) const { SocketLink::received(socket_, bytes); }
  /// What the source has sent since the last call.
  std::string heard() { return std::exchange(fake_browser().sent[socket_], {}); }
  [[nodiscard]] bool ready() { return source_->wait_until({}); }

  std::optional<SocketSource> source_;
  std::uint32_t socket_ = 0;
};

TEST_F(SocketSourceTest, DialsFromATimerAndAsksForTheStream) {
  source_.emplace("lecture.example.org", "talk", "secret", true);
  EXPECT_TRUE(fake_browser().sockets.empty()) << "not from within the call";
  connect();
  const std::string hello = heard();
  for (const char* wish : {"stream=talk", "token=secret", "voice=opus", "text=1"}) {
    EXPECT_NE(hello.find(wish), std::string::npos) << wish << " in " << hello;
  }
  EXPECT_TRUE(source_->status().connected);
}

TEST_F(SocketSourceTest, AsksForNoVoiceUnlessWanted) {
  begin();
  EXPECT_EQ(heard().find("voice="), std::string::npos);
}

TEST_F(SocketSourceTest, HandsOutKeyframesAndAnswersThem) {
  begin();
  heard();
  EXPECT_FALSE(ready());
  say("{hello v=2 window=8 stream=talk keyframe=1000}{1}{2}");
  EXPECT_EQ(heard(), "11");
  ASSERT_TRUE(ready());
  EXPECT_EQ(source_->take()->place, Milliseconds(1000));
  say("{-2}");
  EXPECT_TRUE(source_->take());
  EXPECT_FALSE(source_->take());
  EXPECT_EQ(source_->status().end, EndReason::EndOfStream);
  EXPECT_TRUE(fake_browser().timers.empty()) << "it dials no more";
}

TEST_F(SocketSourceTest, GoesOnWhereTheConnectionWasLost) {
  begin();
  say("{hello v=2 window=8 stream=talk keyframe=500}{1}{2}");
  fake_browser().close(socket_);
  EXPECT_EQ(source_->status().end, EndReason::NotEnded);
  EXPECT_FALSE(source_->status().connected);
  connect();
  EXPECT_NE(heard().find("from=1000"), std::string::npos);
  say("{hello v=2 window=8 stream=talk keyframe=500 from=1000}{4}{-2}");
  int keyframes = 0;
  while (source_->take()) ++keyframes;
  EXPECT_EQ(keyframes, 3);
  EXPECT_EQ(source_->status().end, EndReason::EndOfStream);
}

TEST_F(SocketSourceTest, AServerThatIsNotThereIsTriedAgain) {
  source_.emplace("lecture.example.org", "talk", "", false);
  fake_browser().ring();
  fake_browser().close(*fake_browser().sockets.begin());
  EXPECT_EQ(source_->status().end, EndReason::NotEnded);
  EXPECT_NE(source_->status().detail.find("lecture.example.org"), std::string::npos)
      << source_->status().detail;
  connect();
  EXPECT_TRUE(source_->status().connected);
}

TEST_F(SocketSourceTest, PausesTheServerAtOnce) {
  begin();
  say("{hello v=2 window=8 stream=talk keyframe=500}{1}");
  heard();
  source_->pause();
  const std::string pause = heard();
  EXPECT_NE(pause.find("-1"), std::string::npos) << pause;
  source_->resume();
  EXPECT_FALSE(heard().empty());
}

TEST_F(SocketSourceTest, WhenTheUserLeavesItHangsUpAndDialsNoMore) {
  begin();
  say("{hello v=2 window=8 stream=talk keyframe=500}{1}{2}");
  source_->stop();
  EXPECT_TRUE(fake_browser().ending.contains(socket_)) << "once the last bytes are sent";
  fake_browser().close(socket_);
  EXPECT_EQ(source_->status().end, EndReason::Stopped);
  fake_browser().ring();
  EXPECT_TRUE(fake_browser().sockets.empty());
}

TEST_F(SocketSourceTest, StoppedBetweenTwoAttemptsItDialsNoMore) {
  begin();
  say("{hello v=2 window=8 stream=talk keyframe=500}{1}{2}");
  fake_browser().close(socket_);
  source_->stop();
  fake_browser().ring();
  EXPECT_TRUE(fake_browser().sockets.empty());
}

}  // namespace
}  // namespace aucast::web

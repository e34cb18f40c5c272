#include "client/net/remote_source.h"

#include <condition_variable>
#include <functional>
#include <future>
#include <memory>
#include <mutex>

#include <gtest/gtest.h>

#include "tests/support/scripted_server.h"
#include "tests/unit/net/remote_fixture.h"

namespace aucast::net {
namespace {

using namespace aucast::test;
using namespace test;
using playback::EndReason;
using Aus = std::vector<int>;

/// Counts wakeups and lets a test wait until the source is in a certain state.
class Wakeups {
 public:
  [[nodiscard]] std::function<void()> callback() {
    return [this] {
      const std::lock_guard lock(mutex_);
      ++count_;
      news_.notify_all();
    };
  }
  bool wait(const std::function<bool()>& state) {
    std::unique_lock lock(mutex_);
    while (!state()) {
      if (news_.wait_until(lock, patience()) == std::cv_status::timeout) return false;
    }
    return true;
  }
  [[nodiscard]] int count() {
    const std::lock_guard lock(mutex_);
    return count_;
  }

 private:
  std::mutex mutex_;
  std::condition_variable news_;
  int count_ = 0;
};

TEST(RemoteSource, PlaysTheSixExpressionsInClassic) {
  const std::vector<std::string> packets{"{1,2,5,15,16,20,26}", "{1,2,4,5,15,20,26}",
                                         "{2,4,9,15,17}",       "{2,4,7,9,10,20,26}",
                                         "{1,6,12,14}",         "{1,4,15,23}"};
  std::vector<Step> steps{Accept{}};
  for (const std::string& packet : packets) {
    steps.emplace_back(Send{packet});
    steps.emplace_back(Expect{"1"});
  }
  steps.insert(steps.end(), {Send{"{-2}"}, HalfClose{}, ExpectEnd{}});
  ScriptedServer server(steps);
  RemoteSource source(options_for(server.port(), true));
  EXPECT_EQ(take_all(source), (Aus{1, 1, 2, 2, 1, 1}));
  EXPECT_EQ(server.finish(), "");
  EXPECT_EQ(server.received(), "111111") << "and not a byte more";

  const auto status = source.status();
  EXPECT_EQ(status.end, EndReason::EndOfStream);
  EXPECT_FALSE(status.negotiated);
  EXPECT_EQ(status.keyframes_received, 6U);
  EXPECT_EQ(status.bytes_received, 90U) << "table 5.5: 19 + 18 + 13 + 18 + 11 + 11";
  EXPECT_GT(status.receive_seconds, 0);
}

TEST(RemoteSource, PlaysLevel2WithAWindow) {
  ScriptedServer server({Accept{}, ExpectHello{}, Send{"{hello v=2 window=4 keyframe=80}", 3},
                         Send{"{1;40}{2:50}{4}{5}"}, Expect{"1111"}, Send{"{6}{-2}", 1},
                         ExpectEnd{}});
  RemoteSource source(options_for(server.port()));
  ASSERT_TRUE(source.wait_until(patience()));
  const auto first = source.take();
  ASSERT_TRUE(first);
  EXPECT_EQ(first->time, Milliseconds(40));
  EXPECT_EQ(take_all(source), (Aus{2, 4, 5, 6}));
  EXPECT_EQ(server.finish(), "");
  EXPECT_TRUE(source.status().negotiated);
  EXPECT_EQ(source.status().keyframe_time, Milliseconds(80));
}

TEST(RemoteSource, AsksForTheStreamByName) {
  ScriptedServer server(
      {Accept{}, ExpectHello{}, Send{"{hello v=2 stream=talk}{-2}"}, ExpectEnd{}});
  RemoteOptions options = options_for(server.port());
  options.stream = "talk";
  RemoteSource source(options);
  EXPECT_EQ(take_all(source), Aus{});
  EXPECT_EQ(server.finish(), "");
  EXPECT_NE(server.received().find("stream=talk"), std::string::npos) << server.received();
}

TEST(RemoteSource, FindsTheServerBehindAName) {
  ScriptedServer server({Accept{}, Send{"{-2}"}, ExpectEnd{}});
  RemoteOptions options = options_for(server.port(), true);
  options.host = "localhost";
  RemoteSource source(options);
  EXPECT_EQ(take_all(source), Aus{});
  EXPECT_EQ(source.status().end, EndReason::EndOfStream) << source.status().detail;
}

TEST(RemoteSource, JoinsWhatTcpHasSplit) {
  ScriptedServer server({Accept{}, Send{"{1,", 1}, Send{"6}", 1}, Expect{"1"}, Send{" {2", 1},
                         Send{"}\r\n", 1}, Expect{"1"}, Send{"{-2}", 1}, ExpectEnd{}});
  RemoteSource source(options_for(server.port(), true));
  EXPECT_EQ(take_all(source), (Aus{1, 2}));
  EXPECT_EQ(server.finish(), "");
}

// The first packet has been answered and perhaps handed on when the classic server closes.
TEST(RemoteSource, ConnectsAgainToAClassicServerAndShowsNothingTwice) {
  for (const bool by_reset : {false, true}) {
    std::vector<Step> steps{Accept{}, ExpectHello{}, Send{"{1}"}, Expect{"1"}};
    if (by_reset) {
      steps.emplace_back(Reset{});
    } else {
      steps.emplace_back(Close{});
    }
    steps.insert(steps.end(), {Accept{}, Send{"{1}"}, Expect{"1"}, Send{"{2}"}, Expect{"1"},
                               Send{"{4}"}, Expect{"1"}, Send{"{-2}"}, ExpectEnd{}});
    ScriptedServer server(steps);
    RemoteSource source(options_for(server.port()));
    EXPECT_EQ(take_all(source), (Aus{1, 2, 4}));
    EXPECT_EQ(server.finish(), "");
    EXPECT_EQ(source.status().end, EndReason::EndOfStream);
    EXPECT_EQ(source.status().keyframes_received, 3U);
  }
}

TEST(RemoteSource, GoesOnInClassicWhenTheServerIgnoresTheHello) {
  ScriptedServer server({Accept{}, ExpectHello{}, Send{"{1}"}, Expect{"1"}, Send{"{2}"},
                         Expect{"1"}, Send{"{-2}"}, ExpectEnd{}});
  RemoteSource source(options_for(server.port()));
  EXPECT_EQ(take_all(source), (Aus{1, 2}));
  EXPECT_EQ(server.finish(), "");
}

TEST(RemoteSource, PausesAndResumesWithTinyBuffers) {
  ScriptedServer server({Accept{}, Send{"{1}"}, Expect{"1"}, Send{"{2}"}, Expect{"1"}, Send{"{4}"},
                         Expect{"-1"}, Expect{"-3"}, Send{"{5}"}, Expect{"-1"}, Expect{"-3"},
                         Send{"{-2}"}, ExpectEnd{}});
  Wakeups wakeups;
  RemoteOptions options = options_for(server.port(), true);
  options.buffers = {1, 1, 100};
  options.wakeup = wakeups.callback();
  RemoteSource source(options);
  Aus taken;
  for (std::uint64_t pause = 1; pause <= 2; ++pause) {
    ASSERT_TRUE(wakeups.wait([&] { return source.status().pauses_sent == pause; }));
    EXPECT_TRUE(source.status().paused);
    taken.push_back(take_au(source));
  }
  for (const int au : take_all(source)) taken.push_back(au);
  EXPECT_EQ(taken, (Aus{1, 2, 4, 5}));
  EXPECT_EQ(server.finish(), "");
  EXPECT_EQ(source.status().pauses_sent, 2U);
  EXPECT_EQ(source.status().resumes_sent, 2U);
}

TEST(RemoteSource, TheUserPausesAndResumesInLevel2) {
  ScriptedServer server({Accept{}, ExpectHello{}, Send{"{hello v=2 window=4}{1}{2}"}, Expect{"11"},
                         Expect{"-1"}, Expect{"-3"}, Send{"{4}{-2}"}, ExpectEnd{}});
  Wakeups wakeups;
  RemoteOptions options = options_for(server.port());
  options.wakeup = wakeups.callback();
  RemoteSource source(options);
  ASSERT_TRUE(wakeups.wait([&] { return source.status().keyframes_received == 2; }));
  source.pause();
  EXPECT_TRUE(source.status().paused);
  ASSERT_TRUE(wakeups.wait([&] { return source.status().pauses_sent == 1; }));
  source.resume();
  EXPECT_EQ(take_all(source), (Aus{1, 2, 4}));
  EXPECT_EQ(server.finish(), "");
}

TEST(RemoteSource, TheUserPausesInPlaceOfAnAnswerInClassic) {
  std::promise<void> paused;
  ScriptedServer server({Accept{}, Send{"{1}"}, Expect{"1"}, Until{paused.get_future().share()},
                         Send{"{2}"}, Expect{"-1"}, Expect{"-3"}, Send{"{4}"}, Expect{"1"},
                         Send{"{-2}"}, ExpectEnd{}});
  Wakeups wakeups;
  RemoteOptions options = options_for(server.port(), true);
  options.wakeup = wakeups.callback();
  RemoteSource source(options);
  ASSERT_TRUE(wakeups.wait([&] { return source.status().keyframes_received == 1; }));
  source.pause();
  paused.set_value();
  ASSERT_TRUE(wakeups.wait([&] { return source.status().pauses_sent == 1; }));
  source.resume();
  EXPECT_EQ(take_all(source), (Aus{1, 2, 4}));
  EXPECT_EQ(server.finish(), "");
}

TEST(RemoteSource, WakesThePlayerOnlyForNews) {
  ScriptedServer server(
      {Accept{}, Send{"{1", 1}, Send{"}"}, Expect{"1"}, Send{"{-2}"}, ExpectEnd{}});
  Wakeups wakeups;
  RemoteOptions options = options_for(server.port(), true);
  options.wakeup = wakeups.callback();
  {
    RemoteSource source(options);
    EXPECT_EQ(take_all(source), Aus{1});
    EXPECT_EQ(server.finish(), "");
  }
  EXPECT_EQ(wakeups.count(), 3) << "connected, a keyframe, the end";
}

TEST(RemoteSource, ReadsAServerThatDoesNotWaitNoFasterThanItPlays) {
  std::string flood;
  for (int i = 0; i < 20'000; ++i) flood += "{1,6,12,14}";
  ScriptedServer server({Accept{}, Send{flood + "{-2}"}, ExpectEnd{}});
  RemoteOptions options = options_for(server.port(), true);
  options.buffers = {4, 2, 50};
  RemoteSource source(options);
  EXPECT_EQ(take_all(source).size(), 20'000U);
  EXPECT_EQ(source.status().end, EndReason::EndOfStream) << source.status().detail;
  EXPECT_EQ(server.finish(), "");
}

// === Leaving.

TEST(RemoteSource, StopSaysFourAndGivesNothingMore) {
  ScriptedServer server({Accept{}, Send{"{1}"}, Expect{"1"}, Send{"{2}"}, Expect{"1"}, Expect{"-4"},
                         Send{"{-2}"}, HalfClose{}, ExpectEnd{}});
  RemoteSource source(options_for(server.port(), true));
  ASSERT_EQ(take_au(source), 1);
  source.stop();
  EXPECT_EQ(source.status().end, EndReason::Stopped);
  EXPECT_TRUE(source.ready());
  EXPECT_FALSE(source.take());
  EXPECT_EQ(server.finish(), "");
  EXPECT_EQ(server.received(), "11-4");
  EXPECT_EQ(source.status().end, EndReason::Stopped);
}

TEST(RemoteSource, StopWhilePausedSaysFour) {
  ScriptedServer server({Accept{}, Send{"{1}"}, Expect{"1"}, Send{"{2}"}, Expect{"1"}, Send{"{4}"},
                         Expect{"-1"}, Expect{"-4"}, HalfClose{}, ExpectEnd{}});
  Wakeups wakeups;
  RemoteOptions options = options_for(server.port(), true);
  options.buffers = {1, 1, 100};
  options.wakeup = wakeups.callback();
  RemoteSource source(options);
  ASSERT_TRUE(wakeups.wait([&] { return source.status().paused; }));
  source.stop();
  EXPECT_EQ(server.finish(), "");
}

TEST(RemoteSource, StopsOnceHoweverOftenItIsAsked) {
  ScriptedServer server({Accept{}, ExpectHello{}, Send{"{hello v=2 window=2}{1}{2}"}, Expect{"11"},
                         Expect{"-4"}, HalfClose{}, ExpectEnd{}});
  {
    RemoteSource source(options_for(server.port()));
    ASSERT_EQ(take_au(source), 1);
    ASSERT_EQ(take_au(source), 2);
    source.stop();
    source.stop();
  }
  EXPECT_EQ(server.finish(), "");
  EXPECT_TRUE(server.received().ends_with("11-4")) << server.received();
}

/// A server that plays so many steps of a conversation and then says nothing more.
std::vector<Step> first_steps(std::size_t count) {
  std::vector<Step> steps{Accept{},    ExpectHello{}, Send{"{hello v=2 window=4}"},
                          Send{"{1}"}, Expect{"1"},   Send{"{2"},
                          Send{"}"},   Expect{"1"},   Send{"{-2}"},
                          HalfClose{}};
  steps.resize(count);
  return steps;
}

// All at the same time, because a server that never ends costs each of them its second.
TEST(RemoteSource, GoesAwayAtEveryStep) {
  constexpr std::size_t kSteps = 10;
  std::vector<std::unique_ptr<ScriptedServer>> servers;
  std::vector<std::unique_ptr<RemoteSource>> sources;
  for (const bool at_once : {true, false}) {
    for (std::size_t count = 0; count <= kSteps; ++count) {
      SCOPED_TRACE(::testing::Message() << count << " steps" << (at_once ? ", at once" : ""));
      servers.push_back(std::make_unique<ScriptedServer>(first_steps(count)));
      sources.push_back(std::make_unique<RemoteSource>(options_for(servers.back()->port())));
      if (!at_once) {
        EXPECT_EQ(servers.back()->finish(), "");
      }
      sources.back()->stop();
    }
  }
  const Instant before = std::chrono::steady_clock::now();
  sources.clear();
  EXPECT_LT(std::chrono::steady_clock::now() - before, kPatience) << "bounded";
}

}  // namespace
}  // namespace aucast::net

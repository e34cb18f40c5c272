#include "server/engine/follower.h"

#include <gtest/gtest.h>

#include <string>
#include <variant>

#include "common/overloaded.h"
#include "protocol/codec.h"

namespace aucast::server {
namespace {

using Message = protocol::EngineMessage;
using Kind = Message::Kind;

/// Its events as text, one a line.
std::string text_of(const std::vector<Follower::Event>& events) {
  std::string text;
  for (const Follower::Event& event : events) {
    text += std::visit(Overloaded{
                           [](const Follower::Ask& ask) { return "ask " + ask.request; },
                           [](const Follower::Begin& begin) {
                             return "begin " + begin.origin + " " + begin.packets;
                           },
                           [](const Follower::GoOn& on) { return "on " + on.packets; },
                           [](const Follower::Lose& lose) { return "lose " + lose.reason; },
                           [](const Follower::Say& say) { return "say " + say.text; },
                       },
                       event) +
            "\n";
  }
  return text;
}

/// Of a stream that has come through these servers.
std::string hello_from(const std::string& servers) {
  protocol::HelloGranted hello;
  hello.stream = "talk";
  hello.live = true;
  hello.servers = servers;
  return encode(hello);
}

const std::string kHello = hello_from("org");

class FollowerTest : public ::testing::Test {
 protected:
  std::string batch(std::uint64_t seq, const std::string& packets,
                    const std::string& origin = "org") {
    return text_of(follower.on_broadcast(
        encode(Message{Kind::Batch, origin, seq, seq * 40, 0, packets}), now));
  }
  std::string state(std::uint64_t seq, const std::string& packets,
                    const std::string& origin = "org", const std::string& hello = kHello) {
    return text_of(follower.on_answer(
        encode(Message{Kind::State, origin, seq, seq * 40, 0, hello + packets}), now));
  }
  std::string since(std::uint64_t after, std::uint64_t seq, const std::string& packets) {
    return text_of(follower.on_answer(
        encode(Message{Kind::Since, "org", seq, seq * 40, after, packets}), now));
  }
  /// Connected, and at batch 5 of `org`.
  void join() {
    EXPECT_EQ(text_of(follower.on_connected(now)), "ask join\n");
    EXPECT_EQ(state(5, "{12:30}"), "begin org " + kHello + "{12:30}\n");
  }
  std::string wait(Milliseconds time) {
    now += time;
    return text_of(follower.on_time(now));
  }

  Follower follower{"me"};
  Instant now{std::chrono::hours(1)};
};

TEST_F(FollowerTest, JoinsAndGoesOn) {
  join();
  EXPECT_EQ(batch(6, "{~12:31}"), "on {~12:31}\n");
  EXPECT_EQ(batch(7, ""), "");
  EXPECT_EQ(batch(8, "{~12:32}"), "on {~12:32}\n");
}

TEST_F(FollowerTest, CountsPlacesFromWhereItBegan) {
  join();
  EXPECT_EQ(batch(6, "{a@240 SHVo}{12}"), "on {a@40 SHVo}{12}\n");
}

TEST_F(FollowerTest, KeepsWhatComesBeforeTheAnswer) {
  EXPECT_EQ(text_of(follower.on_connected(now)), "ask join\n");
  EXPECT_EQ(batch(5, "{~12:5}"), "");
  EXPECT_EQ(batch(6, "{~12:6}"), "");
  EXPECT_EQ(batch(6, "{~12:99}", "other"), "");
  EXPECT_EQ(state(5, "{12:5}"), "begin org " + kHello + "{12:5}\non {~12:6}\n");
}

TEST_F(FollowerTest, AsksAgainAndAgainEverLaterUntilItIsAnswered) {
  EXPECT_EQ(text_of(follower.on_connected(now)), "ask join\n");
  for (const int ms : {250, 500, 1000, 2000, 4000, 4000}) {
    EXPECT_EQ(wait(Milliseconds(ms - 1)), "") << ms;
    EXPECT_EQ(wait(Milliseconds(1)), "ask join\n") << ms;
  }
  state(6, "{1}");
  EXPECT_EQ(batch(7, "{2}"), "on {2}\n");
}

TEST_F(FollowerTest, AsksWhoBeginsToSendAtOnce) {
  EXPECT_EQ(text_of(follower.on_connected(now)), "ask join\n");
  for (const int ms : {250, 500, 1000, 2000}) EXPECT_EQ(wait(Milliseconds(ms)), "ask join\n");
  now += Milliseconds(249);
  EXPECT_EQ(batch(1, "{1}"), "") << "the last question may still be answered";
  now += Milliseconds(1);
  EXPECT_EQ(batch(2, "{2}"), "ask join\n");
  EXPECT_EQ(batch(3, "{3}"), "");
}

TEST_F(FollowerTest, TakesAnEmptyAnswerForNone) {
  EXPECT_EQ(text_of(follower.on_connected(now)), "ask join\n");
  EXPECT_EQ(text_of(follower.on_answer("", now)), "");
  EXPECT_EQ(wait(Milliseconds(250)), "ask join\n");
}

TEST_F(FollowerTest, SeesAHoleAndHasItMended) {
  join();
  EXPECT_EQ(batch(8, "{~8}"), "ask join origin=org after=5\n");
  EXPECT_EQ(batch(9, "{~9}"), "");
  EXPECT_EQ(since(5, 8, "{~6}{~7}{~8}"), "on {~6}{~7}{~8}\non {~9}\n");
  EXPECT_EQ(batch(10, "{~10}"), "on {~10}\n");
}

TEST_F(FollowerTest, BeginsAnewWhereWhatIsMissingIsPast) {
  join();
  EXPECT_EQ(batch(80, "{~8}"), "ask join origin=org after=5\n");
  EXPECT_EQ(state(80, "{8}"), std::string("lose more is missing than origin org still has\n"
                                          "begin org ") +
                                  kHello + "{8}\n");
  EXPECT_EQ(batch(81, "{~9}"), "on {~9}\n");
}

TEST_F(FollowerTest, PutsInOrderWhatCameOutOfIt) {
  join();
  EXPECT_EQ(batch(7, "{~7}"), "ask join origin=org after=5\n");
  EXPECT_EQ(batch(6, "{~6}"), "on {~6}\non {~7}\n");
  EXPECT_EQ(since(5, 7, "{~6}{~7}"), "");
  EXPECT_EQ(batch(8, "{~8}"), "on {~8}\n");
}

TEST_F(FollowerTest, TakesNothingTwice) {
  join();
  EXPECT_EQ(batch(5, "{1}"), "");
  EXPECT_EQ(batch(6, "{2}"), "on {2}\n");
  EXPECT_EQ(batch(6, "{2}"), "");
  EXPECT_EQ(batch(1, "{3}"), "");
}

TEST_F(FollowerTest, AsksWhatItMissedWhenTheEngineIsBack) {
  join();
  follower.on_disconnected();
  now += Milliseconds(100);
  EXPECT_EQ(text_of(follower.on_connected(now)), "ask join origin=org after=5\n");
  EXPECT_EQ(since(5, 7, "{~6}{~7}"), "on {~6}{~7}\n");
  EXPECT_EQ(batch(8, "{~8}"), "on {~8}\n");
}

TEST_F(FollowerTest, AsksNobodyWhileTheEngineIsAway) {
  join();
  follower.on_disconnected();
  EXPECT_EQ(wait(Follower::kSilence), "lose nothing has come from origin org for 2000 ms\n");
  EXPECT_FALSE(follower.deadline());
  EXPECT_EQ(text_of(follower.on_connected(now)), "ask join\n");
}

TEST_F(FollowerTest, KeepsTheFirstOfTwoOriginsAndSaysSo) {
  join();
  EXPECT_EQ(batch(1, "{1}", "other"), "say origin other sends it too and is left out\n");
  EXPECT_EQ(batch(2, "{1}", "other"), "");
  EXPECT_EQ(batch(6, "{6}"), "on {6}\n");
  now += Follower::kSayEvery;
  EXPECT_EQ(batch(3, "{1}", "other"), "say origin other sends it too and is left out (3 so far)\n");
}

TEST_F(FollowerTest, SaysThatAnotherOriginAnsweredToo) {
  join();
  EXPECT_EQ(state(9, "{9}", "other"), "say origin other sends it too and is left out\n");
  EXPECT_EQ(batch(6, "{6}"), "on {6}\n");
}

TEST_F(FollowerTest, TakesAnotherOriginWhenItsOwnIsSilent) {
  join();
  batch(1, "{1}", "other");
  ASSERT_TRUE(follower.deadline());
  EXPECT_EQ(*follower.deadline(), now + Follower::kSilence);
  EXPECT_EQ(wait(Follower::kSilence),
            "lose nothing has come from origin org for 2000 ms\nask join\n");
  EXPECT_EQ(state(2, "{2}", "other"), "begin other " + kHello + "{2}\n");
}

TEST_F(FollowerTest, StaysWithAnOriginThatOnlySaysThatItLives) {
  join();
  for (std::uint64_t seq = 6; seq < 20; ++seq) {
    EXPECT_EQ(batch(seq, ""), "");
    EXPECT_EQ(wait(Milliseconds(500)), "");
  }
}

TEST_F(FollowerTest, JoinsAgainWhenWhatBeganIsOver) {
  join();
  EXPECT_EQ(batch(6, "{-2}"), "on {-2}\n");
  EXPECT_EQ(text_of(follower.on_over(now)), "ask join\n");
  EXPECT_EQ(state(9, "{9}"), "begin org " + kHello + "{9}\n");
}

TEST_F(FollowerTest, HasPatienceWithAnOriginThatMakesNoSense) {
  join();
  std::size_t asked = 0;
  for (int ms = 0; ms < 10'000; ms += 10) {
    if (!text_of(follower.on_over(now)).empty()) ++asked;
    state(7, "{7}");
    batch(8, "{garbage}");
    wait(Milliseconds(10));
  }
  EXPECT_LE(asked, 10U);
}

TEST_F(FollowerTest, LeavesAStreamThatWouldBeItsOwn) {
  static_cast<void>(follower.on_connected(now));
  EXPECT_EQ(state(5, "{5}", "org", hello_from("me,org")),
            "say origin org is not followed: it would be this server's own again\n");
  EXPECT_EQ(state(5, "{5}", "org", hello_from("me,org")), "") << "once in a while is enough";
}

TEST_F(FollowerTest, LivesOnWithGarbage) {
  join();
  const std::string said = text_of(follower.on_broadcast("garbage \x01\n", now));
  EXPECT_EQ(said.substr(0, 40), "say a message on the subject is no batch");
  for (int i = 0; i < 1000; ++i) {
    EXPECT_TRUE(follower.on_broadcast(std::string(100'000, 'x'), now).empty());
    EXPECT_TRUE(follower.on_answer("{1}", now).empty());
  }
  EXPECT_EQ(batch(6, "{6}"), "on {6}\n");
}

TEST_F(FollowerTest, TakesNoAnswerFromTheSubject) {
  join();
  const std::string forged = encode(Message{Kind::State, "bad", 1, 0, 0, kHello});
  EXPECT_EQ(text_of(follower.on_broadcast(forged, now)),
            "say a message on the subject is no batch: it is an answer\n");
}

TEST_F(FollowerTest, LivesOnWithForgedNumbers) {
  join();
  EXPECT_EQ(batch(1'000'000, "{1}"), "ask join origin=org after=5\n");
  EXPECT_EQ(batch(6, "{6}"), "on {6}\n");
  EXPECT_EQ(since(5, 6, "{6}"), "");
  EXPECT_EQ(wait(Milliseconds(500)), "ask join origin=org after=6\n");
  EXPECT_EQ(since(6, 6, ""), "");
  EXPECT_EQ(wait(Milliseconds(1000)), "") << "nothing is missing";
  EXPECT_EQ(batch(7, "{7}"), "on {7}\n");
}

TEST_F(FollowerTest, HoldsOnlySoMuchWhileItWaits) {
  static_cast<void>(follower.on_connected(now));
  const std::string much = "{" + std::string(60'000, '1') + "}";
  for (std::uint64_t seq = 1; seq <= 500; ++seq) batch(seq, much);
  const std::size_t fit = Follower::kWaitingBytesMax / much.size();
  EXPECT_EQ(follower.left_out(), 500 - fit);
  const std::string begun = state(490, "{1}");
  EXPECT_EQ(std::count(begun.begin(), begun.end(), '\n'), 11);
  EXPECT_EQ(batch(501, "{2}"), "on {2}\n");
}

}  // namespace
}  // namespace aucast::server

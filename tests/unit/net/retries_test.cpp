#include "client/net/retries.h"

#include <string>

#include <gtest/gtest.h>

namespace aucast::net {
namespace {

using namespace std::chrono_literals;
using protocol::SessionFailed;
using Why = SessionFailed::Why;

constexpr Retries::Keyframes kNone;
constexpr Retries::Keyframes kNow{.now = true};
constexpr Retries::Keyframes kEarlier{.earlier = true};

SessionFailed failure(Why why, int code = 0) {
  SessionFailed event;
  event.why = why;
  event.code = code;
  return event;
}

SessionFailed refusal(int code) {
  return failure(Why::Refused, code);
}

TEST(Retries, ThereAreNoneUnlessAskedFor) {
  Retries retries({.reconnect = false, .hosts = 3});
  EXPECT_FALSE(retries.unreachable(kNone));
  EXPECT_FALSE(retries.failed(failure(Why::Lost), kNow));
  EXPECT_FALSE(retries.failed(refusal(503), kEarlier));
}

TEST(Retries, WaitTwiceAsLongEachTimeUntilAKeyframeComes) {
  Retries retries({.reconnect = true});
  EXPECT_EQ(retries.unreachable(kNone), 1s);
  EXPECT_EQ(retries.failed(failure(Why::Silent), kNone), 2s);
  retries.granted();
  EXPECT_EQ(retries.failed(failure(Why::Lost), kNone), 4s) << "a hello alone is not enough";
  retries.keyframe_came();
  EXPECT_EQ(retries.failed(failure(Why::Lost), kNow), 1s);
}

TEST(Retries, AServerThatRefusesOrIsNoneIsNotAskedAgain) {
  Retries retries({.reconnect = true});
  EXPECT_FALSE(retries.failed(refusal(401), kEarlier));
  EXPECT_FALSE(retries.failed(failure(Why::ProtocolError), kEarlier));
  EXPECT_FALSE(retries.failed(refusal(503), kNone)) << "it is the only one";
  EXPECT_FALSE(retries.failed(refusal(404), kNone));
}

TEST(Retries, AStreamThatWasHereIsWaitedFor) {
  Retries retries({.reconnect = true});
  EXPECT_TRUE(retries.failed(refusal(503), kEarlier));
  EXPECT_TRUE(retries.failed(refusal(503), kEarlier)) << "for as long as it takes";
  EXPECT_TRUE(retries.failed(refusal(404), kEarlier));
}

TEST(Retries, BusyHostsAreTriedUntilAllHaveSaidSo) {
  Retries retries({.reconnect = true, .hosts = 3});
  EXPECT_TRUE(retries.failed(refusal(503), kNone));
  EXPECT_TRUE(retries.failed(refusal(503), kNone));
  EXPECT_FALSE(retries.failed(refusal(503), kNone));
  EXPECT_FALSE(retries.failed(refusal(404), kNone)) << "that it has no such stream is final";
}

TEST(Retries, OnlyBusyHostsInARowCount) {
  Retries retries({.reconnect = true, .hosts = 2});
  EXPECT_TRUE(retries.failed(refusal(503), kNone));
  EXPECT_TRUE(retries.unreachable(kNone));
  EXPECT_TRUE(retries.failed(refusal(503), kNone));
  retries.keyframe_came();
  EXPECT_TRUE(retries.failed(refusal(503), kNone));
  EXPECT_FALSE(retries.failed(refusal(503), kNone));
}

TEST(Retries, InOneRoundEachHostIsTriedOnce) {
  Retries retries({.reconnect = true, .one_round = true, .hosts = 3});
  EXPECT_TRUE(retries.unreachable(kNone));
  EXPECT_TRUE(retries.failed(failure(Why::Silent), kNone));
  EXPECT_FALSE(retries.unreachable(kNone));
}

TEST(Retries, OnceAServerIsReachedThereIsNoEndOfThem) {
  Retries granted({.reconnect = true, .one_round = true});
  granted.granted();
  EXPECT_TRUE(granted.ever_granted());
  Retries played({.reconnect = true, .one_round = true});
  for (int attempt = 0; attempt < 5; ++attempt) {
    EXPECT_TRUE(granted.unreachable(kNone)) << "it has answered";
    EXPECT_TRUE(played.unreachable(attempt == 0 ? kNow : kEarlier)) << "a classic one has";
  }
}

}  // namespace
}  // namespace aucast::net

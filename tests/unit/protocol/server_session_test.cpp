#include "protocol/server_session.h"

#include <gtest/gtest.h>

#include "protocol/limits.h"
#include "protocol/secret.h"
#include "protocol/spare_codes.h"
#include "tests/unit/protocol/packets.h"
#include "tests/unit/protocol/session_text.h"

namespace aucast::protocol {
namespace {

using namespace std::chrono_literals;
using test::encoded;
using test::reason_of;
using test::served;
using test::text_of;

const std::string kWhole = "send {-2} | close finished";
const std::string kBye = "send {-2} | close stopped";

/// A server of two short streams and a hand on its clock.
class Server : public ::testing::Test {
 protected:
  Server() {
    EncodedStream talk = encoded({"{1:30}", "{2;40}", "{3}"}, {"{1}", "{2}", "{3}"});
    talk.duration_ms = 540;
    catalogue_.streams = {served("talk", talk), served("smile", encoded({"{6,12}"}))};
    start();
  }

  void start(Duration round_trip = 0ms) {
    now_ = Instant{} + 1h;
    session_.emplace(catalogue_, round_trip, now_);
  }

  /// From now on the first stream has packets of kLarge bytes and no end.
  void start_endless() {
    const std::string packet = '{' + std::string(kLarge - 2, '1') + '}';
    EncodedStream talk;
    talk.classic = talk.negotiated = test::packets({packet, packet});
    catalogue_.streams = {served("talk", talk)};
    catalogue_.loop = true;
    start();
  }

  std::string get(std::string_view bytes) { return text_of(session_->on_bytes(bytes, now_)); }
  std::string voice() { return text_of(session_->on_voice(now_)); }
  std::string peer_end() { return text_of(session_->on_peer_end(now_)); }
  std::string lost() { return text_of(session_->on_lost(now_)); }
  std::string stop() { return text_of(session_->stop(now_)); }
  std::string send_away() { return text_of(session_->send_away(now_)); }
  std::string pass(Duration time) {
    now_ += time;
    return text_of(session_->on_time(now_));
  }

  static constexpr std::size_t kLarge = 100;
  ServerCatalogue catalogue_;
  Instant now_;
  std::optional<ServerSession> session_;
};

TEST_F(Server, WaitsItsGraceAndThenSpeaksClassic) {
  EXPECT_EQ(session_->deadline(), now_ + 100ms);
  EXPECT_EQ(pass(99ms), "");
  EXPECT_FALSE(session_->awaiting_answer());
  EXPECT_EQ(pass(1ms), "send {1}");
  EXPECT_EQ(session_->level(), Level::Classic);
  EXPECT_TRUE(session_->awaiting_answer());
  EXPECT_FALSE(session_->deadline().has_value());
}

TEST_F(Server, ItsGraceIsThreeRoundTripsWithinBounds) {
  start(50ms);
  EXPECT_EQ(session_->deadline(), now_ + 150ms);
  start(10ms);
  EXPECT_EQ(session_->deadline(), now_ + 100ms);
  start(1h);
  EXPECT_EQ(session_->deadline(), now_ + 3s);
  start(-1s);
  EXPECT_EQ(session_->deadline(), now_ + 100ms);
}

TEST_F(Server, SendsOnePacketPerAnswerAndThenTheEnd) {
  EXPECT_EQ(pass(100ms), "send {1}");
  EXPECT_EQ(get("1"), "send {2}");
  EXPECT_EQ(get("\r\n1\n"), "send {3}");
  EXPECT_EQ(session_->sent().keyframes, 3U);
  EXPECT_EQ(session_->sent().payload_bytes, 9U);
  EXPECT_EQ(get("1"), kWhole);
  EXPECT_FALSE(session_->awaiting_answer());
  EXPECT_FALSE(session_->deadline()) << "the link drains";
  EXPECT_EQ(get("last words"), "") << "nothing after the close";
  EXPECT_EQ(peer_end(), "");
  EXPECT_EQ(lost(), "");
  EXPECT_EQ(stop(), "");
  EXPECT_EQ(pass(1h), "");
}

TEST_F(Server, ACodeEndsTheGraceAndAnswersTheFirstPacket) {
  EXPECT_EQ(get("1"), "send {1}{2}");
  EXPECT_TRUE(session_->awaiting_answer());
}

TEST_F(Server, BlanksNeitherEndNorExtendTheGrace) {
  EXPECT_EQ(get("\r\n  "), "");
  EXPECT_EQ(session_->deadline(), now_ + 100ms);
  EXPECT_EQ(get("-"), "") << "half a code";
  EXPECT_EQ(pass(100ms), "send {1}");
  EXPECT_EQ(get("1"), "") << "the -1 is complete";
  EXPECT_TRUE(session_->paused());
}

TEST_F(Server, UsesUpEarlyAnswersOfAHalfClosedClient) {
  EXPECT_EQ(get("1111111"), "send {1}{2}{3}{-2} | close finished");
  start();
  EXPECT_EQ(get("11"), "send {1}{2}{3}");
  const auto events = session_->on_peer_end(now_);
  EXPECT_EQ(text_of(events), "close peer gone");
  EXPECT_EQ(reason_of(events), "the client ended before it had answered everything");
}

TEST_F(Server, AHalfClosedClientWaitsForTheVoiceLikeAnyOther) {
  EncodedStream talk = encoded({"{1}", "{2}"});
  talk.times = {100ms, 100ms};
  talk.duration_ms = 200;
  catalogue_.streams = {served("talk", talk)};
  const auto track = std::make_shared<EncodedTrack>();
  std::get<RecordedStream>(catalogue_.streams.front().kind).spoken =
      std::make_shared<const SpokenTrack>(SpokenTrack{track});
  start();
  EXPECT_EQ(get("{hello voice=opus window=2}1"),
            "send {hello v=2 window=2 stream=talk duration=200 keyframe=250 voice=opus}");
  EXPECT_EQ(peer_end(), "") << "the voice is still being encoded";
  track->encoded_to(100ms);
  EXPECT_EQ(voice(), "send {1}");
  track->encoded_to(200ms);
  EXPECT_EQ(voice(), "send {2} | close peer gone");
}

TEST_F(Server, SendsASilentHalfClosedClientItsFirstPacket) {
  EXPECT_EQ(peer_end(), "send {1} | close peer gone");
}

TEST_F(Server, PausesInPlaceOfAnAnswerAndResumes) {
  pass(100ms);
  EXPECT_EQ(get("-1"), "");
  EXPECT_TRUE(session_->paused());
  EXPECT_FALSE(session_->awaiting_answer()) << "a paused client owes nothing";
  EXPECT_EQ(get("-1"), "") << "paused already";
  EXPECT_EQ(get("-3"), "send {2}");
  EXPECT_FALSE(session_->paused());
  EXPECT_EQ(get("-3"), "") << "not paused: no meaning";
  EXPECT_EQ(get("1"), "send {3}");
}

TEST_F(Server, BanksAnAnswerThatComesWhilePaused) {
  pass(100ms);
  EXPECT_EQ(get("-11"), "");
  EXPECT_EQ(get("-3"), "send {2}{3}");
}

TEST_F(Server, APausedClientGetsTheEndAfterItsResume) {
  EXPECT_EQ(get("11-1"), "send {1}{2}{3}");
  EXPECT_EQ(get("-3"), kWhole);
}

TEST_F(Server, AClientThatEndsWhilePausedIsGone) {
  EXPECT_EQ(get("-1"), "send {1}");
  const auto events = session_->on_peer_end(now_);
  EXPECT_EQ(text_of(events), "close peer gone");
  EXPECT_EQ(reason_of(events), "the client ended while it was paused");
}

TEST_F(Server, StopsAtOnce) {
  const auto events = session_->on_bytes("1-4", now_);
  EXPECT_EQ(text_of(events), "send {1}{2}{-2} | close stopped");
  EXPECT_EQ(reason_of(events), "the client sent -4");
  start();
  EXPECT_EQ(get("-4"), kBye) << "also as the first code";
  start();
  EXPECT_EQ(get("-1"), "send {1}");
  EXPECT_EQ(get("-4"), kBye) << "also while paused";
}

TEST_F(Server, TheServersStopSaysTheEndToEverybody) {
  EXPECT_EQ(stop(), kBye) << "in the grace";
  EXPECT_EQ(stop(), "") << "once";
  start();
  EXPECT_EQ(get("{hel"), "");
  EXPECT_EQ(stop(), kBye) << "within the hello";
  start();
  EXPECT_EQ(get("-1"), "send {1}");
  EXPECT_EQ(stop(), kBye) << "paused";
}

TEST_F(Server, WhoCanComeAgainIsSentAwayWithoutTheEnd) {
  EXPECT_EQ(send_away(), "") << "in the grace";
  EXPECT_EQ(pass(100ms), "send {1}");
  EXPECT_EQ(send_away(), "") << "classic";
  start();
  EXPECT_EQ(get("{hello v=2 wi"), "");
  EXPECT_EQ(send_away(), "") << "within the hello";
  EXPECT_NE(get("ndow=1}"), "");
  EXPECT_EQ(send_away(), "close sent away");
  EXPECT_EQ(send_away(), "") << "once";
}

TEST_F(Server, ALostConnectionIsClosedWithoutAWord) {
  pass(100ms);
  const auto events = session_->on_lost(now_);
  EXPECT_EQ(text_of(events), "close peer gone");
  EXPECT_EQ(reason_of(events), "the connection was lost");
  start();
  EXPECT_TRUE(get("111").ends_with("close finished"));
  EXPECT_EQ(lost(), "") << "everything had been said";
}

TEST_F(Server, RefusesWhatIsNoCode) {
  const auto events = session_->on_bytes("GET / HTTP/1.1", now_);
  EXPECT_EQ(text_of(events), "close protocol error");
  EXPECT_EQ(reason_of(events),
            "'G' is no control code; those are 1, -1, -3 and -4 (unknown code "
            "at byte 0)");
  start();
  EXPECT_EQ(get("1x"), "send {1}{2} | close protocol error");
}

TEST_F(Server, HandsOutAtMostSixtyFourKibibytesAtOnce) {
  start_endless();
  get("{hello v=2 window=1}");
  get("-1" + std::string(kEarlyAnswersMax, '1'));

  std::vector<ServerEvent> events = session_->on_bytes("-3", now_);
  std::uint64_t sent = session_->sent().keyframes;
  EXPECT_LE(sent, kOutputBytesMax / kLarge + 2);
  EXPECT_EQ(get("-1-3"), "") << "nothing more until there is room";
  int more = 0;
  for (; session_->blocked(); ++more) {
    events = session_->set_blocked(false, now_);
    ASSERT_EQ(events.size(), 1U);
    EXPECT_LT(std::get<SendBytes>(events[0]).bytes.size(), kOutputBytesMax + kLarge);
  }
  EXPECT_GT(more, 4);
  EXPECT_EQ(session_->sent().keyframes, kEarlyAnswersMax + 1);
  EXPECT_TRUE(session_->awaiting_answer());

  start();
  get("{hello v=2 window=1}");
  events = session_->on_bytes(std::string(kEarlyAnswersMax, '1'), now_);
  ASSERT_EQ(events.size(), 1U);
  EXPECT_LT(std::get<SendBytes>(events[0]).bytes.size(), kOutputBytesMax + kLarge)
      << "without a pause, too";
}

TEST_F(Server, WhatIsHeldGoesToAClientThatHasEndedItsSide) {
  start_endless();
  get("{hello v=2 window=1}");
  get("-1" + std::string(1000, '1') + "-3");
  ASSERT_TRUE(session_->blocked());
  EXPECT_EQ(peer_end(), "");
  const std::string rest = text_of(session_->set_blocked(false, now_));
  EXPECT_TRUE(rest.ends_with("} | close peer gone")) << rest.substr(rest.size() - 40);
  EXPECT_EQ(session_->sent().keyframes, 1001U);
}

TEST_F(Server, BoundsEarlyAnswersInOneCallAndWhilePaused) {
  catalogue_.loop = true;
  start();
  pass(100ms);
  const std::string flood(kEarlyAnswersMax + 1, '1');
  const auto sent = session_->on_bytes(flood, now_);
  EXPECT_EQ(std::get<SendBytes>(sent.front()).bytes.size(), flood.size() * 3)
      << "one answer was due";
  EXPECT_EQ(sent.size(), 1U);
  const auto events = session_->on_bytes(flood + "1", now_);
  EXPECT_TRUE(text_of(events).ends_with("close protocol error"));
  EXPECT_EQ(reason_of(events), "more than 4096 answers came before the packets they answer");

  start();
  EXPECT_EQ(get("-1"), "send {1}");
  EXPECT_EQ(get(std::string(4000, '1')), "");
  EXPECT_EQ(get(std::string(96, '1')), "");
  EXPECT_EQ(get("1"), "close protocol error");
}

TEST_F(Server, LoopsWithoutAnEnd) {
  catalogue_.loop = true;
  start();
  EXPECT_EQ(get("1111"), "send {1}{2}{3}{1}{2}");
  EXPECT_EQ(session_->sent().keyframes, 5U);
}

TEST_F(Server, GrantsAHelloAndFillsTheWindow) {
  EXPECT_EQ(get("{hello v=2 window=2}"),
            "send {hello v=2 window=2 stream=talk duration=540 keyframe=250}{1:30}{2;40}");
  EXPECT_EQ(session_->level(), Level::Negotiated);
  EXPECT_TRUE(session_->awaiting_answer());
  EXPECT_FALSE(session_->deadline().has_value());
  EXPECT_EQ(get("1"), "send {3}");
  EXPECT_EQ(get("1"), "");
  EXPECT_EQ(get("1"), kWhole);
}

TEST_F(Server, GrantsNoMoreThanItHas) {
  EXPECT_EQ(get("{hello window=999 stream=smile delta=1 token=x from=7}"),
            "send {hello v=2 window=256 stream=smile keyframe=250}{6,12}");
  EXPECT_EQ(session_->stream_name(), "smile");
  start();
  EXPECT_EQ(get("{hello window=0 stream=smile}"),
            "send {hello v=2 window=1 stream=smile keyframe=250}{6,12}")
      << "a recorded stream needs answers";
  start();
  EXPECT_EQ(get("{hello stream=smile}"),
            "send {hello v=2 window=1 stream=smile keyframe=250}{6,12}");
}

TEST_F(Server, PauseAndResumeAnswerNothingInLevel2) {
  EXPECT_NE(get("{hello window=2}"), "");
  EXPECT_EQ(get("-1"), "");
  EXPECT_EQ(get("11"), "") << "what was on its way is answered all the same";
  EXPECT_FALSE(session_->awaiting_answer());
  EXPECT_EQ(get("-3"), "send {3}");
  EXPECT_EQ(get("-11"), "") << "the end waits for the resume";
  EXPECT_EQ(get("-3"), kWhole);
}

TEST_F(Server, AHelloBegunHasFiveSeconds) {
  EXPECT_EQ(get("{hel"), "");
  EXPECT_EQ(session_->deadline(), now_ + 5s);
  EXPECT_EQ(pass(4999ms), "");
  EXPECT_EQ(get("lo v=2"), "");
  EXPECT_EQ(pass(1ms),
            "send {error 400 the hello was not complete within 5 seconds} | close refused");
}

TEST_F(Server, AClientThatEndsWithinItsHelloIsGone) {
  EXPECT_EQ(get("{hel"), "");
  EXPECT_EQ(peer_end(), "close peer gone");
}

TEST_F(Server, AnswersABadHelloWithAnError) {
  const std::pair<std::string, std::string> rows[] = {
      {"{hello v=3}", "{error 505 version 3 is not spoken here, only 2}"},
      {"{hello stream=none}", "{error 404 there is no stream 'none' here}"},
      {"{hello window=x}",
       "{error 400 window is a number of 0-999999, found 'x' (bad field at byte 14)}"},
      {"{hallo}",
       "{error 400 the word beginning 'ha' is none of the protocol's (unknown packet at byte 2)}"},
      {"{hello\n}",
       "{error 400 the word beginning 'hello\\x0a' is none of the protocol's "
       "(unknown packet at byte 6)}"},
      {"{hello v=2\n}",
       "{error 400 expected printable text or ')', found '\\x0a' (illegal byte "
       "at byte 10)}"},
  };
  for (const auto& [hello, error] : rows) {
    start();
    const auto events = session_->on_bytes(hello, now_);
    EXPECT_EQ(text_of(events), "send " + error + " | close refused");
    EXPECT_FALSE(reason_of(events).empty());
  }
  start();
  EXPECT_TRUE(get("{hello " + std::string(600, 'x')).starts_with("send {error 400 no closing"));
}

TEST_F(Server, IgnoresALateHelloButNotALaterOne) {
  pass(100ms);
  EXPECT_EQ(get("{hello v=2 window=64}"), "");
  EXPECT_EQ(session_->level(), Level::Classic);
  EXPECT_EQ(get("1"), "send {2}");
  EXPECT_EQ(get("{"), "close protocol error");
  start();
  pass(100ms);
  EXPECT_EQ(get("{streams}1"), "send {2}") << "the same for the other question";
  start();
  pass(100ms);
  EXPECT_EQ(get("{hello v=x}"), "close protocol error") << "not well-formed";
}

TEST_F(Server, ListsItsStreams) {
  EXPECT_EQ(get("{streams}"), "send {streams talk smile} | close finished");
}

TEST_F(Server, AHelloAfterTheGraceButBeforeTheTimerCounts) {
  now_ += 1s;
  EXPECT_TRUE(get("{hello}").starts_with("send {hello"));
}

TEST_F(Server, GivesTheSameForBytesCutAnywhere) {
  const std::string bytes = " {hello v=2 window=2}1-1-311";
  const std::string whole = get(bytes);
  for (std::size_t cut = 1; cut < bytes.size(); ++cut) {
    start();
    std::string sent;
    for (const std::string_view part :
         {std::string_view(bytes).substr(0, cut), std::string_view(bytes).substr(cut)}) {
      const std::string text = get(part);
      if (!text.empty()) sent += sent.empty() ? text : text.substr(text.find(' ') + 1);
    }
    EXPECT_EQ(sent, whole) << "cut at " << cut;
  }
}

TEST_F(Server, AStreamThatStartsAgainHasNoLength) {
  EXPECT_NE(get("{hello v=2}").find(" duration=540 "), std::string::npos);
  catalogue_.loop = true;
  start();
  EXPECT_EQ(get("{hello v=2}").find("duration"), std::string::npos);
}

TEST_F(Server, GoesOnWhenAStreamIsAddedToTheCatalogue) {
  EXPECT_EQ(get("{hello v=2 window=2}").substr(0, 12), "send {hello ");
  for (int i = 0; i < 100; ++i) catalogue_.streams.push_back(served("more", encoded({"{4}"})));
  EXPECT_EQ(get("1"), "send {3}");
  EXPECT_EQ(session_->stream_name(), "talk");
}

TEST_F(Server, AnEmptyStreamEndsAtOnce) {
  catalogue_.streams = {served("none", {})};
  catalogue_.loop = true;
  start();
  EXPECT_EQ(get("1-4"), kWhole);
}

TEST(CloseReason, HasANameForEach) {
  using Why = CloseConnection::Why;
  EXPECT_EQ(name(Why::Finished), "finished");
  EXPECT_EQ(name(Why::Stopped), "stopped");
  EXPECT_EQ(name(Why::PeerGone), "peer gone");
  EXPECT_EQ(name(Why::ProtocolError), "protocol error");
  EXPECT_EQ(name(Why::Refused), "refused");
}

TEST_F(Server, SaysWhenAClientSpeaksTls) {
  const auto events = session_->on_bytes("\x16\x03\x01\x02", now_);
  EXPECT_EQ(text_of(events), "close protocol error");
  EXPECT_NE(reason_of(events).find("speaks TLS"), std::string::npos);
}

TEST_F(Server, AFloodOfSpareCodesEndsTheConnection) {
  EXPECT_EQ(get("1").substr(0, 8), "send {1}");
  std::string pauses;
  for (std::size_t i = 0; i < kSpareCodesMax + 100; ++i) pauses += "-1";
  EXPECT_EQ(get(pauses), "close protocol error");
}

TEST(SpareCodes, NoTimeBetweenTwoCodesIsLost) {
  Instant now{};
  SpareCodes codes(now);
  for (int i = 0; i < 20'000; ++i) {
    now += std::chrono::microseconds(9900);  // 101 a second; 100 are earned
    ASSERT_TRUE(codes.spend(now)) << i;
  }
}

TEST_F(Server, SpareCodesAreEarnedByTimeAndByPackets) {
  EXPECT_EQ(get("{hello v=2 window=1}").substr(0, 6), "send {");
  // Twice as many as may come at once, but no faster than they are earned.
  std::string few;
  for (std::size_t i = 0; i < kSpareCodesPerSecond; ++i) few += i % 2 == 0 ? "-1" : "-3";
  for (std::size_t sent = 0; sent < 2 * kSpareCodesMax; sent += kSpareCodesPerSecond) {
    ASSERT_EQ(get(few), "");
    now_ += 1s;
  }
  // A client of tiny buffers pauses and resumes at every packet, as fast as it likes.
  catalogue_.loop = true;
  start();
  ASSERT_EQ(get("1").substr(0, 8), "send {1}");
  for (std::size_t i = 0; i < kSpareCodesMax; ++i) ASSERT_EQ(get("-1-3").substr(0, 5), "send ");
}

TEST(SameSecret, IsTheSameOrNot) {
  EXPECT_TRUE(same_secret("word", "word"));
  for (const char* other : {"", "w", "wor", "worx", "xord", "words", "wordword"}) {
    EXPECT_FALSE(same_secret(other, "word")) << other;
  }
}

TEST_F(Server, ATokenThatChangesShutsNobodyOut) {
  catalogue_.token = "one";
  start();
  EXPECT_EQ(get("{hello v=2 window=2 token=one}").substr(0, 12), "send {hello ");
  catalogue_.token = "two";
  EXPECT_EQ(get("1"), "send {3}");
  start();
  EXPECT_EQ(get("{hello v=2 window=2 token=one}"), "");
  start();
  EXPECT_EQ(get("{hello v=2 window=2 token=two}").substr(0, 12), "send {hello ");
}

TEST_F(Server, AWrongTokenIsRefusedOnlyAfterASecond) {
  catalogue_.token = "word";
  for (const char* guess : {"{hello token=wore}", "{streams token=wore}", "{hello token=w}x-4"}) {
    start();
    EXPECT_EQ(get(guess), "") << guess;
    EXPECT_EQ(get("garbage tells nothing sooner"), "");
    EXPECT_EQ(peer_end(), "");
    EXPECT_EQ(session_->deadline(), now_ + 1s);
    EXPECT_EQ(text_of(session_->on_time(now_ + 999ms)), "");
    EXPECT_TRUE(text_of(session_->on_time(now_ + 1s)).starts_with("send {error 401 ")) << guess;
  }
  start();
  EXPECT_TRUE(get("{hello}").starts_with("send {error 401 ")) << "no token is no guess";
}

TEST_F(Server, AnAddressHasSoManyWrongTokensASecondWhetherOrNotItStays) {
  catalogue_.token = "word";
  WrongTokens wrong;
  const auto said = [&](std::uint64_t address, std::string_view hello) {
    session_.emplace(catalogue_, 0ms, now_, Admission::Welcome, TokenCount{&wrong, address});
    return get(hello).substr(0, 15);
  };
  for (std::size_t i = 0; i < kWrongTokensMax; ++i) {
    EXPECT_EQ(said(1, "{hello token=wore}"), "");
    static_cast<void>(session_->on_lost(now_));
  }
  EXPECT_EQ(said(1, "{hello token=wore}"), "send {error 503");
  EXPECT_EQ(said(1, "{streams token=word}"), "send {error 503") << "which was right must not show";
  EXPECT_EQ(said(1, "{hello}"), "send {error 401") << "no token is no guess";
  EXPECT_EQ(said(2, "{hello token=word}"), "send {hello v=2") << "others do not wait";
  now_ += kWrongTokenWait - 1ms;
  EXPECT_EQ(said(1, "{hello token=word}"), "send {error 503");
  now_ += 1ms;
  EXPECT_EQ(said(1, "{hello token=word}"), "send {hello v=2");
}

TEST_F(Server, TellsAFullAddressFromAFullServer) {
  session_.emplace(catalogue_, 0ms, now_, Admission::FullAddress);
  EXPECT_TRUE(
      get("{hello v=2}").starts_with("send {error 503 too many clients from this address}"));
}

TEST_F(Server, RefusesForTheFirstReasonInOrder) {
  catalogue_.token = "word";
  const auto refused = [this](std::string_view hello) {
    session_.emplace(catalogue_, 0ms, now_, Admission::Full);
    std::string said = get(hello);
    if (said.empty()) said = text_of(session_->on_time(*session_->deadline()));
    return said.substr(0, 15);
  };
  EXPECT_EQ(refused("{hello v=3 nonsense}"), "send {error 400") << "what cannot be read";
  EXPECT_EQ(refused("{hello v=3 window=x}"), "send {error 505") << "the version, without a token";
  EXPECT_EQ(refused("{hello token=drow stream=none}"), "send {error 401") << "the token";
  EXPECT_EQ(refused("{hello token=word stream=none}"), "send {error 404") << "the stream";
  EXPECT_EQ(refused("{hello token=word}"), "send {error 503") << "room, at last";
  EXPECT_EQ(refused("{streams}"), "send {error 401");
  EXPECT_EQ(refused("{streams token=word}"), "send {streams t") << "which takes no room";
  EXPECT_EQ(refused("1"), "send {error 401") << "classic, where a token is wanted";
  catalogue_.token.clear();
  EXPECT_EQ(refused("1"), "close refused");
}

TEST_F(Server, WantingATokenMeetsAFarewellAndGarbageAsOthersDo) {
  catalogue_.token = "word";
  start();
  EXPECT_EQ(get("-4"), kBye);
  start();
  EXPECT_EQ(get("GET /"), "close protocol error");
}

TEST_F(Server, HasNoTimeLimitForALateHello) {
  pass(100ms);
  EXPECT_EQ(get("{hel"), "");
  EXPECT_FALSE(session_->deadline().has_value());
  EXPECT_EQ(get("lo}1"), "send {2}");
}

}  // namespace
}  // namespace aucast::protocol

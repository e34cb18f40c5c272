#include "protocol/client_session.h"

#include <gtest/gtest.h>

#include "protocol/limits.h"
#include "tests/unit/protocol/session_text.h"

namespace aucast::protocol {
namespace {

using namespace std::chrono_literals;
using test::reason_of;
using test::text_of;

class Client : public ::testing::Test {
 protected:
  Client() {
    options_.hello.window = 2;
    start();
  }

  void start() {
    now_ = Instant{} + 1h;
    session_.emplace(options_);
    connected_ = text_of(session_->on_connected(now_));
  }
  void start_classic() {
    options_.negotiate = false;
    start();
  }
  void start_granted(int window = 2) {
    options_.hello.window = window;
    start();
    const std::string hello = "{hello v=2 window=" + std::to_string(window) + " keyframe=40}";
    EXPECT_EQ(get(hello), "granted window=" + std::to_string(window));
  }

  std::string get(std::string_view bytes) { return text_of(test::read_all(*session_, bytes)); }
  std::string closed() { return text_of(session_->on_closed()); }
  std::string why(std::string_view bytes) { return reason_of(test::read_all(*session_, bytes)); }
  std::string pass(Duration time) {
    now_ += time;
    return text_of(session_->on_time(now_));
  }

  ClientSessionOptions options_;
  Instant now_;
  std::optional<ClientSession> session_;
  std::string connected_;
};

TEST_F(Client, AsksForLevel2WhenItMay) {
  EXPECT_EQ(connected_, "send {hello v=2 window=2}");
  EXPECT_EQ(text_of(session_->on_connected(now_)), "") << "once";
  start_classic();
  EXPECT_EQ(connected_, "");
}

TEST_F(Client, SaysNothingBeforeItIsConnected) {
  ClientSession session(options_);
  EXPECT_EQ(text_of(test::read_all(session, "{1}")), "");
  EXPECT_EQ(text_of(session.on_closed()), "");
  EXPECT_EQ(session.stop(), "");
  EXPECT_EQ(session.answer_received(), "");
  EXPECT_FALSE(session.deadline().has_value());
}

TEST_F(Client, IsGrantedLevel2) {
  EXPECT_EQ(get("{hello v=2 window=2 stream=talk keyframe=40}"), "granted window=2");
  EXPECT_EQ(session_->level(), Level::Negotiated);
  EXPECT_EQ(session_->window(), 2);
  EXPECT_EQ(get("{1:30;40@0}{L12}"), "store {1:30;40@0} | store {L12}");
  EXPECT_EQ(session_->unanswered(), 2U);
  EXPECT_EQ(session_->answer_received(), "1");
  EXPECT_EQ(session_->answer_received(), "1");
  EXPECT_EQ(session_->answer_received(), "") << "nothing is unanswered";
  EXPECT_EQ(get("{-2}"), "ended");
  EXPECT_EQ(session_->keyframes_received(), 2U);
  EXPECT_EQ(session_->payload_bytes(), 16U);
}

TEST_F(Client, GoesOnInClassicWhenAPacketComesFirst) {
  EXPECT_EQ(get("{1,6}"), "store {1,6}");
  EXPECT_EQ(session_->level(), Level::Classic);
  EXPECT_EQ(session_->window(), 1);
  EXPECT_EQ(session_->answer_received(), "1");
  EXPECT_EQ(get(" {2}\n"), "store {2}");
  EXPECT_EQ(closed(), "fail lost") << "two packets: the hello was not the reason";
}

TEST_F(Client, ReconnectsWhenAClassicServerTookTheHelloForGarbage) {
  EXPECT_EQ(get("{1,6}"), "store {1,6}");
  EXPECT_EQ(session_->answer_received(), "1");
  EXPECT_EQ(closed(), "reconnect");
  EXPECT_EQ(closed(), "") << "nothing after it";
  EXPECT_EQ(get("{2}"), "");
  start();
  EXPECT_EQ(closed(), "reconnect") << "its first packet may be lost in the reset";
  start();
  EXPECT_EQ(get("{1"), "");
  EXPECT_EQ(closed(), "reconnect");
}

TEST_F(Client, DoesNotReconnectWithoutAHello) {
  start_classic();
  EXPECT_EQ(get("{1,6}"), "store {1,6}");
  const auto events = session_->on_closed();
  EXPECT_EQ(text_of(events), "fail lost");
  EXPECT_EQ(reason_of(events), "the connection ended before the end of the stream, {-2}");
  start_classic();
  EXPECT_EQ(get("{1,"), "");
  EXPECT_EQ(reason_of(session_->on_closed()), "the connection ended within a packet");
}

TEST_F(Client, DoesNotReconnectOnceLevel2IsGranted) {
  start_granted();
  EXPECT_EQ(closed(), "fail lost");
}

TEST_F(Client, TheEndMayComeFirstAndNothingCountsAfterIt) {
  EXPECT_EQ(get("{-2}garbage"), "ended");
  EXPECT_EQ(get("more"), "");
  EXPECT_EQ(closed(), "");
  EXPECT_EQ(pass(1h), "");
  EXPECT_EQ(session_->stop(), "");
}

TEST_F(Client, WaitsForAFirstWordOnly) {
  EXPECT_EQ(session_->deadline(), now_ + 10s);
  EXPECT_EQ(pass(9999ms), "");
  now_ += 1ms;
  const auto events = session_->on_time(now_);
  EXPECT_EQ(text_of(events), "fail silent");
  EXPECT_EQ(reason_of(events), "nothing came from the server within 10000 ms");
  start();
  EXPECT_EQ(get("{1"), "");
  EXPECT_TRUE(session_->deadline().has_value()) << "half a packet is no word";
  EXPECT_EQ(get("}"), "store {1}");
  EXPECT_FALSE(session_->deadline().has_value());
  EXPECT_EQ(pass(1h), "");
  start_granted();
  EXPECT_FALSE(session_->deadline().has_value());
}

TEST_F(Client, ReportsARefusal) {
  const auto events = test::read_all(*session_, "{error 404 there is no stream 'x' here}");
  EXPECT_EQ(text_of(events), "fail refused");
  EXPECT_EQ(reason_of(events), "the server refused: 404 there is no stream 'x' here");
  start_granted();
  EXPECT_EQ(get("{1}{error 503 going down}"), "store {1} | fail refused");
}

TEST_F(Client, RefusesAHelloThatWasNotAskedSo) {
  EXPECT_EQ(why("{hello v=3}"), "the server answered in version 3, asked was 2");
  start();
  EXPECT_EQ(why("{hello v=2 window=3}"), "the server granted a window of 3, asked was 2");
  start();
  EXPECT_EQ(why("{hello v=2 window=0}"), "the server granted a window of 0, asked was 2");
  start();
  for (const auto& [word, granted] : {std::pair{"delta=1", "changes only, which was"},
                                      std::pair{"text=1", "captions, which were"},
                                      std::pair{"loop=1", "one turn of a loop, which was"},
                                      std::pair{"voice=opus", "a voice in opus, which was"}}) {
    start();
    EXPECT_EQ(why("{hello v=2 " + std::string(word) + "}"),
              "the server granted " + std::string(granted) + " not asked for");
  }
  options_.hello.from_ms = 500;
  start();
  EXPECT_EQ(why("{hello v=2 from=501}"), "the server begins at 501 ms, asked was 500");
  start();
  EXPECT_EQ(get("{hello v=2 from=480}"), "granted window=1") << "the keyframe under way then";
  start_granted();
  EXPECT_EQ(why("{hello v=2}"), "the server sent a hello where none was due");
  start();
  EXPECT_EQ(get("{1}"), "store {1}");
  EXPECT_EQ(get("{hello v=2}"), "fail protocol error");
  start();
  EXPECT_EQ(why("{streams a}"), "the server sent a list of streams that was not asked for");
  start_classic();
  EXPECT_EQ(get("{hello v=2}"), "fail protocol error");
}

TEST_F(Client, RefusesSoundAndCaptionsThatWereNotAgreed) {
  start_granted();
  EXPECT_EQ(why("{t@0 R29vZA}"), "the server sent captions, which were not agreed");
  start_granted();
  EXPECT_EQ(why("{a@0 WAE}"), "the server sent voice, which was not agreed");
  options_.hello.voice = kVoiceCodec;
  start();
  EXPECT_EQ(get("{hello v=2 window=2 voice=opus}"), "granted window=2");
  EXPECT_EQ(why("{a WAE}"), "the server's first voice packet has no place");
}

TEST_F(Client, WindowZeroMayBeGrantedAsOne) {
  start_granted(0);
  EXPECT_EQ(get("{1}{2}{3}"), "store {1} | store {2} | store {3}");
  EXPECT_EQ(session_->unanswered(), 0U);
  EXPECT_EQ(session_->answer_received(), "") << "no answers at all";
  start();
  EXPECT_EQ(get("{hello v=2 window=1}{1}"), "granted window=1 | store {1}");
  EXPECT_EQ(session_->answer_received(), "1");
}

TEST_F(Client, LeavesItToItsOwnerToReadNoFurtherThanThereIsRoom) {
  start_granted();
  EXPECT_EQ(get("{1}{2}{3}"), "store {1} | store {2} | store {3}") << "beyond the window of 2";
  EXPECT_EQ(session_->unanswered(), 3U);
  start_granted();
  std::string_view bytes = "{1}{2}";
  EXPECT_EQ(text_of(session_->on_bytes(bytes)), "store {1}");
  EXPECT_EQ(bytes, "{2}") << "to be read when there is room";
}

TEST_F(Client, AnswersNothingAfterTheEnd) {
  start_granted();
  EXPECT_EQ(get("{1}{-2}{2}"), "store {1} | ended") << "what follows is dropped";
  EXPECT_EQ(session_->answer_received(), "");
}

TEST_F(Client, WaitsForAWholePacketNotForBytes) {
  start_granted();
  EXPECT_FALSE(session_->deadline().has_value()) << "after the hello a server may take its time";
  start_classic();
  EXPECT_EQ(get(" \r\n{1"), "");
  EXPECT_EQ(pass(10s), "fail silent");
}

TEST_F(Client, RefusesGarbageAndDeliversWhatCameBeforeIt) {
  start_granted();
  const auto events = test::read_all(*session_, "{1}{2?}");
  EXPECT_EQ(text_of(events), "store {1} | fail protocol error");
  EXPECT_EQ(reason_of(events),
            "the server sent what is not the protocol: expected ':', a letter of A-E x y z, ',', "
            "';' or the end, found '?' (illegal byte at byte 37)");
}

TEST_F(Client, PausesInPlaceOfAnAnswerInClassic) {
  start_classic();
  EXPECT_EQ(get("{1}"), "store {1}");
  EXPECT_EQ(session_->pause(), "-1");
  EXPECT_TRUE(session_->paused());
  EXPECT_EQ(session_->unanswered(), 0U);
  EXPECT_EQ(session_->pause(), "") << "paused already";
  EXPECT_EQ(session_->answer_received(), "") << "the -1 was the answer";
  EXPECT_EQ(session_->resume(), "-3");
  EXPECT_EQ(session_->resume(), "");
  EXPECT_FALSE(session_->paused());
}

TEST_F(Client, AClassicPauseWaitsForTheNextAnswer) {
  start_classic();
  EXPECT_EQ(session_->pause(), "") << "never spontaneously";
  EXPECT_FALSE(session_->paused());
  EXPECT_EQ(get("{1}"), "store {1}");
  EXPECT_EQ(session_->answer_received(), "-1");
  EXPECT_TRUE(session_->paused());
  EXPECT_EQ(session_->resume(), "-3");
  EXPECT_EQ(session_->pause(), "");
  EXPECT_EQ(session_->resume(), "") << "the wish was taken back";
  EXPECT_EQ(get("{2}"), "store {2}");
  EXPECT_EQ(session_->answer_received(), "1");
}

TEST_F(Client, PauseIsSpontaneousInLevel2) {
  start_granted();
  EXPECT_EQ(session_->pause(), "-1");
  EXPECT_EQ(get("{1}"), "store {1}") << "was on its way";
  EXPECT_EQ(session_->answer_received(), "1") << "the pause answered nothing";
  EXPECT_EQ(session_->resume(), "-3");
}

TEST_F(Client, APauseBeforeTheGrantIsSaidWithIt) {
  EXPECT_EQ(session_->pause(), "");
  EXPECT_EQ(get("{hello v=2 window=2}"), "granted window=2 | send -1");
  EXPECT_TRUE(session_->paused());
}

TEST_F(Client, StopIsSaidOnceAndDropsWhatStillComes) {
  start_granted();
  EXPECT_EQ(get("{1}"), "store {1}");
  EXPECT_EQ(session_->stop(), "-4");
  EXPECT_EQ(session_->stop(), "");
  EXPECT_EQ(session_->answer_received(), "");
  EXPECT_EQ(session_->pause(), "");
  EXPECT_EQ(session_->resume(), "");
  EXPECT_EQ(get("{2}{3}{4}{5}"), "");
  EXPECT_EQ(get("{-2}"), "ended");
  start_granted();
  EXPECT_EQ(session_->stop(), "-4");
  EXPECT_EQ(closed(), "ended");
  start_granted();
  EXPECT_EQ(session_->stop(), "-4");
  EXPECT_EQ(get("garbage"), "ended");
  start();
  EXPECT_EQ(session_->stop(), "-4");
  EXPECT_EQ(closed(), "ended") << "no reconnecting for one who left";
}

TEST_F(Client, ResolvesChangesAgainstTheRunningFace) {
  options_.hello.delta = true;
  start();
  EXPECT_EQ(get("{hello v=2 window=2 delta=1}"), "granted window=2");
  EXPECT_EQ(get("{6,12:50}{~6:0,L12:80;33}"), "store {6,12:50} | store {L12:80,R12:50;33}");
  (void)session_->answer_received();
  (void)session_->answer_received();
  EXPECT_EQ(get("{~;33}{1}"), "store {L12:80,R12:50;33} | store {1}");
}

TEST_F(Client, RefusesChangesThatHaveNothingToChange) {
  options_.hello.delta = true;
  start();
  EXPECT_EQ(get("{hello v=2 window=2 delta=1}"), "granted window=2");
  EXPECT_EQ(why("{~6}"), "the first packet of the server names only changes");
  start_granted();
  EXPECT_EQ(get("{1}"), "store {1}");
  EXPECT_EQ(why("{~6}"), "the server sent changes only, which was not agreed");
}

}  // namespace
}  // namespace aucast::protocol

// The voice and the captions that come with a stream, on the reader's own clock.

#include <gtest/gtest.h>

#include "client/net/au_reader.h"
#include "protocol/codec.h"
#include "tests/support/manual_clock.h"

namespace aucast::net {
namespace {

using namespace std::chrono_literals;
using aucast::test::ManualClock;

/// 60 ms of wideband speech, as its first byte says.
const std::string kOpus("\x58 speech");

std::string voice(std::optional<std::uint64_t> place = std::nullopt) {
  return protocol::encode(protocol::VoiceData{place, kOpus});
}

class ReaderVoice : public ::testing::Test {
 protected:
  static AuReaderOptions options() {
    AuReaderOptions options;
    options.peer = "server:4650";
    options.buffers = {100, 100, 1, 0ms};
    options.reconnect = true;
    options.voice = true;
    options.captions = true;
    return options;
  }

  void connect(const std::string& granted) {
    said_ = reader_.connected(clock_.now()).send;
    feed("{hello v=2 window=64 " + granted + "}");
  }
  void feed(std::string_view bytes) {
    clock_.advance(1ms);
    (void)reader_.received(bytes, clock_.now());
  }
  Milliseconds next_voice() {
    const auto voice = reader_.take_voice();
    return voice ? voice->place : Milliseconds(-1);
  }

  ManualClock clock_;
  AuReader reader_{options()};
  std::string said_;
};

TEST_F(ReaderVoice, IsAskedForAndKeptWithItsPlaces) {
  connect("voice=opus");
  EXPECT_NE(said_.find("voice=opus"), std::string::npos) << said_;
  EXPECT_TRUE(reader_.status().voice);
  feed(voice(100) + voice() + "{12:50;400}" + voice(500) + "{12:50;400}");
  EXPECT_EQ(next_voice(), 100ms);
  EXPECT_EQ(next_voice(), 160ms);
  EXPECT_EQ(next_voice(), 500ms);
  EXPECT_EQ(next_voice(), -1ms);
  EXPECT_EQ(reader_.take()->place, 400ms);
  EXPECT_EQ(reader_.take()->place, 800ms);
}

TEST_F(ReaderVoice, IsNotAskedForUnlessWanted) {
  AuReaderOptions without = options();
  without.voice = false;
  without.captions = false;
  AuReader reader(without);
  const std::string said = reader.connected(clock_.now()).send;
  EXPECT_EQ(said.find("voice"), std::string::npos);
  EXPECT_EQ(said.find("text"), std::string::npos);
  EXPECT_FALSE(reader.status().voice);
}

TEST_F(ReaderVoice, GoesOnWhereItWasCutOff) {
  connect("voice=opus from=0");
  feed(voice(0) + "{12:50;400}");
  (void)reader_.closed(clock_.now());
  connect("voice=opus from=400");
  feed(voice(420) + "{12:50;400}");
  EXPECT_EQ(next_voice(), 0ms);
  EXPECT_EQ(next_voice(), 420ms);
  (void)reader_.take();
  EXPECT_EQ(reader_.take()->place, 800ms);
}

TEST_F(ReaderVoice, OfAStreamThatBeginsAnewFollowsWhatWasThere) {
  connect("voice=opus from=0");
  feed(voice(0) + "{12:50;400}");
  (void)reader_.closed(clock_.now());
  connect("voice=opus");
  feed(voice(20) + "{12:50;400}");
  EXPECT_EQ(next_voice(), 0ms);
  EXPECT_EQ(next_voice(), 420ms);
}

TEST_F(ReaderVoice, ALiveKeyframeIsSpokenWhileThereIsVoice) {
  connect("live=1 voice=opus");
  feed(voice(0) + "{12:50;40}{12:50;40}{12:50;40}");
  for (const bool spoken : {true, true, false}) {
    const auto keyframe = reader_.take();
    ASSERT_TRUE(keyframe);
    EXPECT_EQ(keyframe->spoken, spoken);
  }
}

TEST_F(ReaderVoice, CaptionsAreAskedForAndKeptWithTheirPlaces) {
  connect("text=1 from=0");
  EXPECT_NE(said_.find("text=1"), std::string::npos) << said_;
  EXPECT_TRUE(reader_.status().captions);
  feed(protocol::encode(protocol::CaptionData{0, "one"}) + "{12:50;400}" +
       protocol::encode(protocol::CaptionData{500, "zwei \xc3\xa4"}));
  (void)reader_.closed(clock_.now());
  connect("text=1");
  feed(protocol::encode(protocol::CaptionData{100, ""}));
  for (const auto& [place, text] : {std::pair(0ms, "one"), {500ms, "zwei \xc3\xa4"}, {500ms, ""}}) {
    const auto caption = reader_.take_caption();
    ASSERT_TRUE(caption);
    EXPECT_EQ(caption->place, place);
    EXPECT_EQ(caption->text, text);
  }
  EXPECT_FALSE(reader_.take_caption());
}

TEST_F(ReaderVoice, CaptionsThatNobodyTakesHaveALimit) {
  connect("text=1");
  for (std::size_t sent = 0; sent <= SpokenQueue::kCaptionsMax; ++sent) {
    feed(protocol::encode(protocol::CaptionData{sent, "one"}));
  }
  std::size_t taken = 0;
  while (reader_.take_caption()) ++taken;
  EXPECT_EQ(taken, SpokenQueue::kCaptionsMax);
  EXPECT_EQ(reader_.status().captions_left_out, 1U);
}

TEST_F(ReaderVoice, WhatNobodyTakesHasALimit) {
  connect("voice=opus");
  const std::string large = kOpus + std::string(1000, 'x');
  const std::size_t fit = playback::kVoiceBytesMax / large.size();
  feed(protocol::encode(protocol::VoiceData{0, large}));
  for (std::size_t sent = 0; sent <= fit; ++sent) {
    feed(protocol::encode(protocol::VoiceData{std::nullopt, large}));
  }
  std::size_t taken = 0;
  while (reader_.take_voice()) ++taken;
  EXPECT_EQ(taken, fit);
  EXPECT_EQ(reader_.status().voice_left_out, 2U);
}

TEST_F(ReaderVoice, AnswersWaitForEachOtherWhereThereIsAVoice) {
  connect("voice=opus");
  EXPECT_EQ(reader_.received("{12:50;40}{12:60;40}", clock_.now()).send, "");
  EXPECT_FALSE(reader_.has_output());
  const Instant since = clock_.now();
  ASSERT_TRUE(reader_.deadline());
  EXPECT_LE(*reader_.deadline() - since, 250ms);
  clock_.advance(100ms);
  EXPECT_EQ(reader_.received("{12:50;40}", clock_.now()).send, "");
  clock_.advance(150ms);
  EXPECT_EQ(reader_.time(clock_.now()).send, "111");
  std::string many;
  for (int i = 0; i < 16; ++i) many += i % 2 == 0 ? "{12:50;40}" : "{12:60;40}";
  EXPECT_EQ(reader_.received(many, clock_.now()).send, std::string(16, '1'))
      << "a quarter of the window is not kept waiting";
}

TEST_F(ReaderVoice, APauseTakesTheAnswersWithIt) {
  connect("voice=opus");
  EXPECT_EQ(reader_.received("{12:50;40}", clock_.now()).send, "");
  reader_.set_paused(true);
  EXPECT_EQ(reader_.speak(clock_.now()).send, "-11");
}

TEST_F(ReaderVoice, WithoutAVoiceAnAnswerGoesAtOnce) {
  connect("");
  EXPECT_EQ(reader_.received("{12:50;40}", clock_.now()).send, "1");
}

}  // namespace
}  // namespace aucast::net

#include "protocol/delivery.h"

#include <gtest/gtest.h>

#include "protocol/limits.h"
#include "protocol/live_feed.h"
#include "tests/unit/protocol/session_text.h"

namespace aucast::protocol {
namespace {

using namespace std::chrono_literals;
using test::served;

const std::string kOpus60 = "\x58\x01";  ///< 60 ms; WAE in base64

/// Keyframes of 100 ms and a voice that is still being encoded.
class VoiceInTheMaking : public ::testing::Test {
 protected:
  VoiceInTheMaking() {
    std::vector<Keyframe> keyframes(3);
    for (Keyframe& keyframe : keyframes) {
      keyframe.terms = {AuTerm{1}};
      keyframe.time_ms = 100;
    }
    stream_ = served("talk", encode_stream(keyframes, 250, 20));
    std::get<RecordedStream>(stream_.kind).spoken =
        std::make_shared<const SpokenTrack>(SpokenTrack{track_, {}});
    deliver(false);
  }

  void deliver(bool loop, std::uint64_t from_ms = 0) {
    delivery_.emplace(stream_, loop);
    HelloAsked asked;
    asked.window = 8;
    asked.voice = kVoiceCodec;
    asked.from_ms = from_ms;
    EXPECT_EQ(delivery_->grant(asked, 250).voice, kVoiceCodec);
  }

  std::string pump() {
    std::string bytes;
    delivery_->pump(bytes);
    return bytes;
  }

  std::shared_ptr<EncodedTrack> track_ = std::make_shared<EncodedTrack>();
  ServedStream stream_;
  std::optional<Delivery> delivery_;
};

TEST_F(VoiceInTheMaking, KeyframesWaitForTheirVoice) {
  EXPECT_EQ(pump(), "");
  track_->add({0ms, kOpus60});
  EXPECT_EQ(pump(), "");
  track_->encoded_to(100ms);
  EXPECT_EQ(pump(), "{a@0 WAE}{1;100}");
  track_->finish();
  EXPECT_EQ(pump(), "{1;100}{1;100}");
}

TEST_F(VoiceInTheMaking, TheEndWaitsForTheTail) {
  track_->encoded_to(300ms);
  EXPECT_EQ(pump(), "{1;100}{1;100}{1;100}");
  for (int i = 0; i < 3; ++i) delivery_->answer();
  EXPECT_EQ(pump(), "");
  EXPECT_FALSE(delivery_->complete());
  track_->add({320ms, kOpus60});
  track_->finish();
  EXPECT_EQ(pump(), "{a@320 WAE}");
  EXPECT_TRUE(delivery_->complete());
}

TEST_F(VoiceInTheMaking, InALoopTheEndOfATurnCostsNothingOfTheNext) {
  deliver(true);
  track_->add({0ms, kOpus60});
  track_->add({270ms, kOpus60});
  track_->finish();
  const std::string turn = "{1;100}{1;100}{1;100}";
  EXPECT_EQ(pump(), "{a@0 WAE}" + turn + "{a@300 WAE}" + turn + "{a@600 WAE}{1;100}{1;100}");
}

TEST_F(VoiceInTheMaking, ALoopOfAnotherServerIsCutLikeOnesOwn) {
  auto upstream = std::make_shared<UpstreamStream>();
  upstream->content = std::get<RecordedStream>(stream_.kind);
  upstream->loop = true;
  stream_ = {"talk", std::move(upstream)};
  deliver(false);
  track_->add({0ms, kOpus60});
  track_->add({270ms, kOpus60});
  track_->finish();
  const std::string turn = "{1;100}{1;100}{1;100}";
  EXPECT_EQ(pump(), "{a@0 WAE}" + turn + "{a@300 WAE}" + turn + "{a@600 WAE}{1;100}{1;100}");
}

TEST_F(VoiceInTheMaking, WhereALoopStillArrivesTheVoiceGoesOutBeforeItsKeyframe) {
  const std::vector<Keyframe> keyframes(2, {{AuTerm{1}}, false, 100, std::nullopt});
  auto arriving = std::make_shared<EncodedStream>(encode_stream(keyframes, 250, 20));
  arriving->duration_ms = 300;
  arriving->extent = Extent::Growing;
  auto upstream = std::make_shared<UpstreamStream>();
  upstream->content = RecordedStream{arriving, stream_.recorded()->spoken};
  upstream->loop = true;
  stream_ = {"talk", std::move(upstream)};
  deliver(false);
  track_->add({0ms, kOpus60});
  track_->add({170ms, kOpus60});
  EXPECT_EQ(pump(), "{a@0 WAE}{1;100}{a@170 WAE}{1;100}") << "200 ms are not the end of the turn";
}

TEST_F(VoiceInTheMaking, WhatIsEncodedOfTheTimeBeforeTheBeginningIsLeftOut) {
  deliver(true, 200);
  for (const auto at : {0ms, 60ms, 120ms, 180ms}) track_->add({at, kOpus60});
  track_->finish();
  EXPECT_TRUE(pump().starts_with("{a@180 WAE}{1;100}{a@300 WAE}{a WAE}{1;100}"))
      << "the next turn has it";
  EXPECT_EQ(delivery_->sent().voice_left_out, 0U);
}

TEST_F(VoiceInTheMaking, OfALongTailNoMoreComesAtOnceThanMayBePutOut) {
  const std::string loud = kOpus60 + std::string(900, 'x');
  constexpr std::uint64_t kPackets = 200;
  for (std::uint64_t i = 0; i < kPackets; ++i) track_->add({300ms + i * 60ms, loud});
  track_->finish();
  EXPECT_EQ(pump(), "{1;100}{1;100}{1;100}");
  for (int i = 0; i < 3; ++i) delivery_->answer();
  do {
    delivery_->set_blocked(false);
    const std::size_t bytes = pump().size();
    ASSERT_GT(bytes, 0U);
    EXPECT_LT(bytes, kOutputBytesMax + 2 * loud.size());
  } while (!delivery_->complete());
  EXPECT_EQ(delivery_->sent().voice_packets, kPackets);
}

TEST_F(VoiceInTheMaking, NothingSoundsDuringAPause) {
  track_->add({0ms, kOpus60});
  track_->finish();
  delivery_->pause();
  EXPECT_EQ(pump(), "");
  delivery_->resume();
  EXPECT_EQ(pump(), "{a@0 WAE}{1;100}{1;100}{1;100}");
}

/// A feed whose keyframes come every 100 ms.
class LiveVoice : public ::testing::Test {
 protected:
  LiveVoice() { feed_->add(keyframe_); }
  void join(int window = 100) {
    delivery_.emplace(ServedStream{"talk", feed_}, false);
    HelloAsked asked;
    asked.window = window;
    asked.voice = kVoiceCodec;
    asked.text = true;
    const HelloGranted granted = delivery_->grant(asked, 250);
    EXPECT_EQ(granted.voice, kVoiceCodec);
    EXPECT_TRUE(granted.text);
  }
  std::string pump() {
    std::string bytes;
    delivery_->pump(bytes);
    return bytes;
  }
  void say(Milliseconds from) { feed_->add_voice({from, kOpus60}); }

  const Keyframe keyframe_{{AuTerm{1}}, false, 100, std::nullopt};
  std::shared_ptr<LiveFeed> feed_ = std::make_shared<LiveFeed>(250, 20, true, true);
  std::optional<Delivery> delivery_;
};

TEST_F(LiveVoice, PlacesCountFromTheClientsFirstKeyframe) {
  for (int i = 0; i < 9; ++i) feed_->add(keyframe_);
  say(860ms);
  say(920ms);
  join();
  EXPECT_EQ(pump(), "{a@20 WAE}{1;100}");
  EXPECT_EQ(delivery_->sent().voice_left_out, 0U) << "what was before is nobody's loss";
  say(980ms);
  EXPECT_EQ(pump(), "{a WAE}");
}

TEST_F(LiveVoice, OldVoiceIsLeftOutWhileTheSocketIsFull) {
  join();
  EXPECT_EQ(pump(), "{1;100}");
  delivery_->set_blocked(true);
  for (auto at = 100ms; at < 5000ms; at += 100ms) {
    feed_->add(keyframe_);
    say(at);
    EXPECT_EQ(pump(), "");
  }
  EXPECT_LE(feed_->voice().size(), 2 + static_cast<std::size_t>(kLiveWindowTime / 100ms));
  delivery_->set_blocked(false);
  EXPECT_EQ(pump(), "{a@100 WAE}{1;100}");
}

TEST_F(LiveVoice, VoiceOfMomentsThatWaitForAnswersWaitsWithThem) {
  join(2);
  EXPECT_EQ(pump(), "{1;100}");
  feed_->add(keyframe_);
  say(100ms);
  EXPECT_EQ(pump(), "{a@100 WAE}{1;100}");
  for (auto at = 200ms; at < 5000ms; at += 100ms) {
    feed_->add(keyframe_);
    say(at);
    EXPECT_EQ(pump(), "");
  }
  delivery_->answer();
  EXPECT_EQ(pump(), "{a@200 WAE}{1;100}") << "of the newest moment, where the face is then";
  EXPECT_EQ(delivery_->sent().voice_left_out, 47U) << "from 200 to 4800 ms";
}

TEST_F(LiveVoice, WithoutRoomForAMomentItsVoiceIsNotSentAhead) {
  join(1);
  EXPECT_EQ(pump(), "{1;100}");
  say(60ms);
  say(120ms);
  EXPECT_EQ(pump(), "{a@60 WAE}");
  feed_->add(keyframe_);
  feed_->add(keyframe_);
  say(200ms);
  delivery_->answer();
  EXPECT_EQ(pump(), "{1;100}") << "60 ms from 60 ms on reach beyond 100 ms";
  say(260ms);
  EXPECT_EQ(pump(), "{a@160 WAE}");
  EXPECT_EQ(delivery_->sent().voice_left_out, 2U) << "those at 120 and 200 ms";
}

TEST_F(LiveVoice, LateVoiceOfMomentsLeftOutIsLeftOut) {
  join(1);
  EXPECT_EQ(pump(), "{1;100}");
  for (int i = 0; i < 9; ++i) feed_->add(keyframe_);
  delivery_->answer();
  EXPECT_EQ(pump(), "{1;100}");
  say(840ms);
  say(900ms);
  EXPECT_EQ(pump(), "{a@100 WAE}");
}

TEST_F(LiveVoice, EachMomentOfSeveralComesWithItsVoice) {
  join(100);
  EXPECT_EQ(pump(), "{1;100}");
  feed_->begin_moments();
  for (const auto at : {100ms, 200ms}) {
    say(at);
    feed_->add(keyframe_);
  }
  std::string bytes;
  delivery_->pump_new_moments(bytes);
  EXPECT_EQ(bytes, "{a@100 WAE}{1;100}{a@200 WAE}{1;100}");
}

TEST_F(LiveVoice, ACaptionThatDoesNotFitWithItsPlaceIsNotSent) {
  const std::string longest(759, 'x');  // {t@0 DATA} has 1018 bytes, so there is room for 7 digits
  join();
  EXPECT_EQ(pump(), "{1;100}");
  feed_->add_caption({1'000'000, longest});
  EXPECT_EQ(pump().size(), kCaptionBytesMax);
  feed_->add_caption({10'000'000, longest});
  EXPECT_EQ(pump(), "");
}

TEST_F(LiveVoice, PlacesOfCaptionsNeverDecrease) {
  join(1);
  EXPECT_EQ(pump(), "{1;100}");
  feed_->add_caption({90, "first"});
  EXPECT_EQ(pump(), "{t@90 Zmlyc3Q}");
  feed_->add_caption({250, "second"});
  for (int i = 0; i < 9; ++i) feed_->add(keyframe_);
  EXPECT_EQ(pump(), "");
  delivery_->answer();
  EXPECT_EQ(pump(), "{t@90 c2Vjb25k}{1;100}") << "by its own place it stands since -550 ms";
}

TEST_F(LiveVoice, VoiceGoesOnWithoutKeyframes) {
  join();
  EXPECT_EQ(pump(), "{1;100}");
  say(100ms);
  EXPECT_EQ(pump(), "{a@100 WAE}");
  say(160ms);
  EXPECT_EQ(pump(), "{a WAE}");
}

TEST_F(LiveVoice, WhoComesLateReadsTheCaptionThatStands) {
  feed_->add_caption({0, "first"});
  feed_->add_caption({150, "second"});
  for (int i = 0; i < 9; ++i) feed_->add(keyframe_);
  join();
  EXPECT_EQ(pump(), "{t@0 c2Vjb25k}{1;100}");
}

}  // namespace
}  // namespace aucast::protocol

#include "server/engine/outgoing_batches.h"

#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <string>
#include <utility>

#include "protocol/codec.h"
#include "protocol/encoded_stream.h"
#include "protocol/live_feed.h"
#include "protocol/live_replay.h"

namespace aucast::server {
namespace {

using namespace std::chrono_literals;

using protocol::EngineJoin;
using protocol::Keyframe;
using protocol::LiveFeed;

constexpr char kVoice20Ms = '\x48';  ///< the TOC byte of an Opus packet of 20 ms

/// A feed of smiles that grow by a percent, 40 ms each.
class OutgoingBatchesTest : public ::testing::Test {
 protected:
  void smile(int percent) {
    feed.add(face(percent));
    batches.collect(feed);
  }
  void speak(int place_ms) {
    feed.add_voice({Milliseconds(place_ms), std::string(1, kVoice20Ms) + "hi"});
    batches.collect(feed);
  }
  static Keyframe face(int percent) {
    Keyframe keyframe;
    const std::string text = "{1,12:" + std::to_string(percent) + ";40}";
    EXPECT_FALSE(protocol::parse_keyframe(text.substr(1, text.size() - 2),
                                          protocol::TermSyntax::Wire, keyframe));
    return keyframe;
  }
  [[nodiscard]] std::string answer(const EngineJoin& join) const {
    return batches.answer(join, hello).value_or("nothing");
  }

  LiveFeed feed{250, 20, true, true};
  OutgoingBatches batches{"org"};
  protocol::HelloGranted hello;
};

TEST_F(OutgoingBatchesTest, NumbersItsBatchesAndBeginsWithTheWholeFace) {
  smile(30);
  EXPECT_EQ(batches.next_batch(), "batch origin=org seq=1 place=0\n{1,12:30;40}");
  smile(31);
  smile(32);
  EXPECT_EQ(batches.next_batch(), "batch origin=org seq=2 place=40\n{~12:31;40}{~12:32;40}");
  EXPECT_EQ(batches.next_batch(), "batch origin=org seq=3 place=120\n");
}

TEST_F(OutgoingBatchesTest, SendsTheWholeFaceWhereAMomentWasMissed) {
  smile(30);
  feed.add(face(31));
  smile(32);
  EXPECT_EQ(batches.next_batch(), "batch origin=org seq=1 place=0\n{1,12:30;40}{1,12:32;40}");
}

/// Such as the stream of the six expressions, of which there is no changes-only form.
TEST_F(OutgoingBatchesTest, OfAStreamOfPlainNumbersItSendsEveryWholeFace) {
  protocol::EncodedStream plain;
  for (const char* const face : {"{1,2}", "{4}", "{12}"}) {
    plain.classic.push_back(face);
    plain.negotiated.push_back(face);
    plain.times.emplace_back(250);
  }
  const Instant begin{};
  protocol::LiveReplay replay(std::make_shared<const protocol::EncodedStream>(std::move(plain)),
                              false, begin);
  std::string sent;
  for (const Milliseconds passed : {0ms, 250ms, 500ms}) {
    EXPECT_TRUE(replay.advance(begin + passed));
    batches.collect(replay);
    sent += batches.next_batch() + "\n";
  }
  EXPECT_EQ(sent,
            "batch origin=org seq=1 place=0\n{1,2}\n"
            "batch origin=org seq=2 place=250\n{4}\n"
            "batch origin=org seq=3 place=500\n{12}\n");
}

TEST_F(OutgoingBatchesTest, SaysThePlaceOfEveryVoicePacket) {
  smile(30);
  speak(0);
  speak(20);
  feed.add_caption({30, "Hi"});
  batches.collect(feed);
  EXPECT_EQ(batches.next_batch(),
            "batch origin=org seq=1 place=0\n{1,12:30;40}{a@0 SGhp}{a@20 SGhp}{t@30 SGk}");
}

TEST_F(OutgoingBatchesTest, TellsWhoJoinsTheStateAsOfTheLastBatch) {
  EXPECT_EQ(answer({}), "nothing");
  smile(30);
  EXPECT_EQ(answer({}), "nothing");
  static_cast<void>(batches.next_batch());
  smile(31);
  EXPECT_EQ(answer({}), "state origin=org seq=1 place=0\n" + encode(hello) + "{1,12:30;40}");
  static_cast<void>(batches.next_batch());
  EXPECT_EQ(answer({"org", {}}),
            "state origin=org seq=2 place=40\n" + encode(hello) + "{1,12:31;40}");
}

TEST_F(OutgoingBatchesTest, LeavesTheQuestionsForOthersToThem) {
  smile(30);
  static_cast<void>(batches.next_batch());
  EXPECT_EQ(answer({"other", {}}), "nothing");
}

TEST_F(OutgoingBatchesTest, TellsTheStandingCaptionWithTheState) {
  smile(30);
  feed.add_caption({10, "Hi"});
  smile(31);
  static_cast<void>(batches.next_batch());
  EXPECT_EQ(answer({}),
            "state origin=org seq=1 place=40\n" + encode(hello) + "{t@10 SGk}{1,12:31;40}");
}

TEST_F(OutgoingBatchesTest, GivesWhatWasMissedAsItWas) {
  for (const int percent : {30, 31, 32}) {
    smile(percent);
    static_cast<void>(batches.next_batch());
  }
  EXPECT_EQ(answer({"org", 1}), "since origin=org seq=3 place=40 after=1\n{~12:31;40}{~12:32;40}");
  EXPECT_EQ(answer({"org", 3}), "since origin=org seq=3 place=120 after=3\n");
  EXPECT_EQ(answer({"org", 9}).substr(0, 5), "state") << "numbers that were never given";
}

TEST_F(OutgoingBatchesTest, GivesTheStateWhereWhatWasMissedIsPast) {
  for (int i = 0; i < 60; ++i) {
    smile(i);
    static_cast<void>(batches.next_batch());
  }
  EXPECT_EQ(answer({"org", 1}).substr(0, 5), "state");
  EXPECT_EQ(answer({"org", 12}).substr(0, 5), "since");
}

TEST_F(OutgoingBatchesTest, KeepsNoMoreThanOneAnswerHolds) {
  smile(30);
  for (int i = 0; i < 2000; ++i) static_cast<void>(batches.next_batch());
  EXPECT_EQ(answer({"org", 1}).substr(0, 5), "state");
  for (int i = 0; i < 1500; ++i) {
    feed.add_caption({40, std::string(600, 'x')});
    batches.collect(feed);
    static_cast<void>(batches.next_batch());
  }
  for (std::uint64_t after = 3401; after <= 3501; after += 10) {
    EXPECT_LE(answer({"org", after}).size(), protocol::kEngineBytesMax);
  }
}

TEST_F(OutgoingBatchesTest, EndsAndGoesOn) {
  smile(30);
  static_cast<void>(batches.next_batch());
  batches.collect_end();
  batches.collect_end();
  EXPECT_FALSE(batches.running());
  EXPECT_EQ(batches.next_batch(), "batch origin=org seq=2 place=40\n{-2}");
  EXPECT_EQ(answer({}), "nothing");
  smile(31);
  EXPECT_TRUE(batches.running());
  EXPECT_EQ(batches.next_batch(), "batch origin=org seq=3 place=40\n{1,12:31;40}");
}

}  // namespace
}  // namespace aucast::server

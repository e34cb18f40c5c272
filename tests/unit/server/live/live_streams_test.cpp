// What becomes of a live source, without a file and a clock: the test is who writes, and the time.
#include "server/live/live_streams.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "common/sources/hold.h"
#include "protocol/stream_file.h"
#include "tests/support/kept_log.h"
#include "tests/support/manual_clock.h"
#include "tests/support/quiet_log.h"
#include "tests/support/temp_folder.h"
#include "tests/unit/sources/tables.h"

namespace aucast::server {
namespace {

using namespace std::chrono_literals;
using sources::tables::kOpenFace2Header;
using Texts = std::vector<std::string>;

/// A row of the table that only says AU 12, of 0 to 5.
std::string smile(int frame, const std::string& seconds, int of_five,
                  const std::string& face = "0") {
  return sources::tables::openface2_row(frame, seconds,
                                        "0," + std::to_string(of_five) + ",0,0,0,0,0", face);
}

class LiveStreamsTest : public ::testing::Test {
 protected:
  LiveStreamsTest() { options_.each.path = "face.csv"; }

  LiveStreams& streams() {
    if (!streams_) {
      streams_.emplace(options_, LiveStreams::Events{[this] { note(); }, [this] { ++new_faces_; }});
    }
    return *streams_;
  }
  /// What was sent of the first stream since this was last asked.
  Texts fed(std::string_view bytes) {
    streams().feed(bytes, clock_.now());
    return sent();
  }
  Texts sent() { return std::exchange(sent_, {}); }
  /// Lets the time pass, and what is due on the way be sent.
  Texts after(Duration by) {
    const Instant until = clock_.now() + by;
    for (auto next = streams().next(); next && *next <= until; next = streams().next()) {
      clock_.advance(std::max(*next - clock_.now(), Duration::zero()));
      streams().advance(clock_.now());
    }
    clock_.advance(until - clock_.now());
    return sent();
  }
  [[nodiscard]] bool ended() { return streams().served().front().live()->ended(); }

  const test::QuietLog quiet_;
  test::ManualClock clock_;
  LiveStreamsOptions options_;
  std::optional<LiveStreams> streams_;
  Texts sent_;
  int new_faces_ = 0;

 private:
  void note() {
    const protocol::LiveMoment* newest = streams().served().front().live()->newest();
    const bool is_new = newest != nullptr && newest->number + 1 != noted_;
    if (!is_new) return;
    noted_ = newest->number + 1;
    sent_.push_back(newest->full);
  }

  std::uint64_t noted_ = 0;
};

TEST_F(LiveStreamsTest, ARowIsSentAsSoonAsItsLineEnds) {
  EXPECT_EQ(fed(kOpenFace2Header + smile(1, "0.00", 1)), Texts{"{12:20;40}"});
  clock_.advance(40ms);
  const std::string row = smile(2, "0.04", 2);
  EXPECT_EQ(fed(row.substr(0, 20)), Texts{});
  EXPECT_EQ(fed(row.substr(20)), Texts{"{12:40;40}"});
  EXPECT_FALSE(streams().full());
}

TEST_F(LiveStreamsTest, OfAFollowedFileOnlyTheLastRowIsNotPast) {
  options_.follow = true;
  EXPECT_EQ(fed(kOpenFace2Header + smile(1, "0.00", 1) + smile(2, "0.04", 2)), Texts{});
  EXPECT_EQ(streams().next(), std::nullopt);
  streams().advance(clock_.now());
  EXPECT_EQ(sent(), Texts{});
  streams().caught_up(clock_.now());
  EXPECT_EQ(sent(), Texts{"{12:40;40}"});
  clock_.advance(40ms);
  EXPECT_EQ(fed(smile(3, "0.08", 3)), Texts{"{12:60;40}"});
}

TEST_F(LiveStreamsTest, AFileThatIsReadAnewIsPastToo) {
  options_.follow = true;
  fed(kOpenFace2Header + smile(1, "0.00", 1));
  streams().caught_up(clock_.now());
  sent();
  streams().begin_anew("it was rewritten");
  EXPECT_EQ(fed(kOpenFace2Header + smile(1, "0.00", 2) + smile(2, "0.04", 3)), Texts{});
  streams().caught_up(clock_.now());
  EXPECT_EQ(sent().size(), 1U);
}

TEST_F(LiveStreamsTest, InSilenceTheFaceGoesToNeutralAndTheStreamEnds) {
  options_.each.timeout = 5s;
  fed(kOpenFace2Header + smile(1, "0.00", 1));
  EXPECT_EQ(after(490ms), Texts{}) << "the face holds";
  const Texts eased = after(2s);
  ASSERT_FALSE(eased.empty());
  EXPECT_EQ(eased.back().find("12:"), std::string::npos) << eased.back();
  EXPECT_FALSE(ended());
  after(2490ms);
  EXPECT_FALSE(ended());
  after(100ms);
  EXPECT_TRUE(ended());
  EXPECT_FALSE(streams().over()) << "it may come back";
  EXPECT_EQ(fed(smile(2, "6.00", 2)).size(), 1U);
  EXPECT_FALSE(ended());
}

TEST_F(LiveStreamsTest, WithoutATimeOutSilenceEndsNothing) {
  options_.each.timeout = 0ms;
  fed(kOpenFace2Header + smile(1, "0.00", 1));
  after(1h);
  EXPECT_FALSE(ended());
}

TEST_F(LiveStreamsTest, AfterItsEndTheFaceGoesToNeutralFirst) {
  fed(kOpenFace2Header + smile(1, "0.00", 1));
  streams().end_input(clock_.now(), true);
  EXPECT_FALSE(streams().over());
  after(std::chrono::duration_cast<Duration>(
      std::chrono::duration<double>(sources::kHoldSeconds + sources::kEaseSeconds + 0.1)));
  EXPECT_TRUE(streams().over());
  EXPECT_FALSE(streams().nothing_came());
  EXPECT_EQ(streams().next(), std::nullopt);
}

TEST_F(LiveStreamsTest, AnEndBeforeTheFirstKeyframeIsToldApart) {
  fed(kOpenFace2Header);
  streams().end_input(clock_.now(), true);
  after(0s);
  EXPECT_TRUE(streams().over());
  EXPECT_TRUE(streams().nothing_came());
}

TEST_F(LiveStreamsTest, ARecordingThatIsPouredInIsPlayedAtItsOwnSpeed) {
  std::string table = kOpenFace2Header;
  for (int frame = 0; frame < 600; ++frame) {
    table += smile(frame, std::to_string(frame * 0.04), frame % 5 + 1);
  }
  EXPECT_LE(fed(table).size(), 26U) << "a second ahead at most";
  EXPECT_TRUE(streams().full());
  const std::size_t in_ten_seconds = after(10s).size();
  EXPECT_GE(in_ten_seconds, 249U);
  EXPECT_LE(in_ten_seconds, 251U);
  after(5s);
  EXPECT_FALSE(streams().full());
}

TEST_F(LiveStreamsTest, AThinnedStreamSendsTheNewestWhenItsTimeHasCome) {
  options_.each.link.kbits = 2;
  fed(kOpenFace2Header);
  Texts all;
  for (int frame = 1; frame <= 100; ++frame) {
    const std::string hundredths = std::to_string(100 + frame % 100).substr(1);
    for (std::string& text :
         fed(smile(frame, std::to_string(frame / 100) + "." + hundredths, frame % 5 + 1))) {
      all.push_back(std::move(text));
    }
    for (std::string& text : after(10ms)) all.push_back(std::move(text));
  }
  EXPECT_GE(all.size(), 2U);
  EXPECT_LE(all.size(), 4U) << "a second's worth of 2 kbit/s, and the next";
}

TEST_F(LiveStreamsTest, EveryFaceGetsAStreamFromItsFirstRowOn) {
  options_.each.reader.recording.all_faces = true;
  fed(kOpenFace2Header + smile(1, "0.00", 1, "0"));
  EXPECT_EQ(streams().served().size(), 2U) << "the first stream, and one for the face";
  EXPECT_EQ(new_faces_, 1);
  fed(smile(2, "0.04", 2, "7"));
  ASSERT_EQ(new_faces_, 2);
  const auto served = streams().served();
  EXPECT_EQ(served[1].name, "face-0");
  EXPECT_EQ(served[2].name, "face-7");
  ASSERT_NE(served[2].live()->newest(), nullptr);
  EXPECT_EQ(served[2].live()->newest()->full, "{12:40;40}");
}

TEST_F(LiveStreamsTest, AFaceWhoseNameAnotherStreamHasGetsNone) {
  options_.each.reader.recording.all_faces = true;
  options_.take_name = [](const std::string& name) { return name != "face-0"; };
  const test::KeptLog log;
  fed(kOpenFace2Header + smile(1, "0.00", 1, "0") + smile(1, "0.00", 2, "7"));
  const auto served = streams().served();
  ASSERT_EQ(served.size(), 2U);
  EXPECT_EQ(served[1].name, "face-7");
  const std::string said = log.said();
  EXPECT_NE(said.find("face 0 gets no stream: another one here is called face-0"),
            std::string::npos)
      << said;
  EXPECT_EQ(said.find("face 0 is the stream"), std::string::npos) << said;
}

TEST_F(LiveStreamsTest, TheFirstRowOfAFaceMayComeInTwoPieces) {
  options_.each.reader.recording.all_faces = true;
  fed(kOpenFace2Header);
  const std::string row = smile(1, "0.00", 2, "7");
  fed(row.substr(0, row.size() / 2));
  fed(row.substr(row.size() / 2));
  ASSERT_EQ(new_faces_, 1);
  ASSERT_NE(streams().served()[1].live()->newest(), nullptr);
  EXPECT_EQ(streams().served()[1].live()->newest()->full, "{12:40;40}");
}

TEST_F(LiveStreamsTest, RowsThatEndInAReturnAreReadOneByOneToo) {
  options_.each.reader.recording.all_faces = true;
  std::string table = kOpenFace2Header + smile(1, "0.00", 1, "0") + smile(2, "0.00", 2, "7") +
                      smile(3, "0.04", 3, "7");
  std::replace(table.begin(), table.end(), '\n', '\r');
  fed(table);
  ASSERT_EQ(new_faces_, 2);
  after(40ms);
  EXPECT_EQ(streams().served()[2].live()->newest()->full, "{12:60;40}");
}

TEST_F(LiveStreamsTest, ManyFacesGetNoMoreStreamsThanAreToldApart) {
  options_.each.reader.recording.all_faces = true;
  fed(kOpenFace2Header);
  for (int face = 0; face < 40; ++face) fed(smile(1, "0.00", 1, std::to_string(face)));
  EXPECT_EQ(streams().served().size(), 1 + LiveStreams::kFaceStreamsMax);
}

TEST_F(LiveStreamsTest, WhatIsServedIsRecorded) {
  const test::TempFolder folder;
  options_.record = folder.path() / "kept.txt";
  ASSERT_TRUE(streams().start());
  fed(kOpenFace2Header + smile(1, "0.00", 1));
  clock_.advance(40ms);
  fed(smile(2, "0.04", 2));
  ASSERT_TRUE(streams().finish_record());
  const auto kept = protocol::parse_stream_file(folder.read("kept.txt"), "kept.txt");
  ASSERT_TRUE(kept) << kept.error().message;
  EXPECT_EQ(kept->keyframes.size(), 2U);
}

TEST_F(LiveStreamsTest, ARecordThatCannotBeMadeIsAnError) {
  options_.record = "/nowhere/kept.txt";
  EXPECT_FALSE(streams().start());
}

}  // namespace
}  // namespace aucast::server

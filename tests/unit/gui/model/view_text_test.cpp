#include "client/gui/model/view_text.h"

#include <gtest/gtest.h>

#include "client/gui/storage/language_file.h"
#include "client/gui/texts/texts.h"

namespace aucast::gui {
namespace {

using playback::EndReason;
using playback::PlaybackState;
using playback::SourceStatus;

SourceStatus connected(std::size_t receiver = 0, std::size_t playout = 0) {
  SourceStatus status;
  status.connected = true;
  status.receiver_fill = receiver;
  status.playout_fill = playout;
  return status;
}

AuFrame frame(std::initializer_list<AuTerm> terms) {
  return frame_from_terms({terms.begin(), terms.size()});
}

/// A face that has every AU.
const face::AuRecordings kAll = [] {
  face::AuRecordings all;
  for (int number = 0; number <= kAuNumberMax; ++number) all[number].number = number;
  return all;
}();

TEST(ViewText, TheStateIsSaidInWords) {
  const playback::BufferOptions buffers;  // 40 of 100
  EXPECT_EQ(state_in_words(PlaybackState::Buffering, {}, buffers), "connecting");
  EXPECT_EQ(state_in_words(PlaybackState::Buffering, connected(), buffers), "buffering 0 %");
  EXPECT_EQ(state_in_words(PlaybackState::Buffering, connected(17), buffers), "buffering 42 %");
  EXPECT_EQ(state_in_words(PlaybackState::Buffering, connected(70, 30), buffers),
            "buffering 100 %");
  EXPECT_EQ(state_in_words(PlaybackState::Playing, connected(), buffers), "playing");
  EXPECT_EQ(state_in_words(PlaybackState::Lost, {}, buffers), "lost");
  playback::SourceStatus never;
  never.end = playback::EndReason::Unreachable;
  EXPECT_EQ(state_in_words(PlaybackState::Lost, never, buffers), "no connection");
  EXPECT_FALSE(plays_the_rest(PlaybackState::Playing, connected()));
  playback::SourceStatus gone;
  gone.reconnects = 1;
  EXPECT_TRUE(plays_the_rest(PlaybackState::Playing, gone));
  gone = {};
  gone.end = playback::EndReason::EndOfStream;
  EXPECT_FALSE(plays_the_rest(PlaybackState::Playing, gone)) << "it has sent all";
  gone.end = playback::EndReason::ConnectionLost;
  EXPECT_TRUE(plays_the_rest(PlaybackState::Playing, gone));
  EXPECT_FALSE(plays_the_rest(PlaybackState::Lost, gone));
}

TEST(ViewText, WhatIsConnectedToAnewIsNotWaitedForInVain) {
  playback::SourceStatus gone;
  gone.reconnects = 2;
  EXPECT_EQ(state_in_words(PlaybackState::Stalled, gone, {}), "reconnecting");
  EXPECT_EQ(state_in_words(PlaybackState::Stale, gone, {}), "reconnecting");
  EXPECT_EQ(state_in_words(PlaybackState::Stale, connected(), {}), "waiting, nothing comes");
}

TEST(ViewText, AThresholdIsRoundedUpAsTheBuffersHaveIt) {
  EXPECT_EQ(state_in_words(PlaybackState::Buffering, connected(1), {10, 5, 1}), "buffering 100 %");
  EXPECT_EQ(state_in_words(PlaybackState::Buffering, connected(2), {10, 5, 25}), "buffering 66 %")
      << "playing begins with three";
}

TEST(ViewText, ConnectingEndsWithTheConnectionOrItsFailure) {
  EXPECT_EQ(activity_of(PlaybackState::Buffering, {}), Activity::Connecting);
  EXPECT_EQ(activity_of(PlaybackState::Buffering, connected()), Activity::Playing);
  SourceStatus failed;
  failed.end = EndReason::Unreachable;
  EXPECT_EQ(activity_of(PlaybackState::Buffering, failed), Activity::Playing);
  EXPECT_EQ(activity_of(PlaybackState::Stalled, connected()), Activity::Playing);
  EXPECT_EQ(activity_of(PlaybackState::Paused, connected()), Activity::Paused);
  for (const PlaybackState over :
       {PlaybackState::Ended, PlaybackState::Stopped, PlaybackState::Lost}) {
    EXPECT_EQ(activity_of(over, connected()), Activity::Over);
  }
}

TEST(ViewText, BytesGetTheUnitThatFits) {
  EXPECT_EQ(bytes_text(0), "0 B");
  EXPECT_EQ(bytes_text(999), "999 B");
  EXPECT_EQ(bytes_text(1234), "1.2 kB");
  EXPECT_EQ(bytes_text(3.4e6), "3.4 MB");
  EXPECT_EQ(bytes_text(999'999), "1.0 MB");
  EXPECT_EQ(bytes_text(5e12), "5000.0 GB");
  EXPECT_EQ(bit_rate_text(40), "320 bit/s");
  EXPECT_EQ(bit_rate_text(150), "1.2 kbit/s");
  EXPECT_EQ(traffic_text(893, 150, 40), "893 B, 1.2 kbit/s");
  EXPECT_EQ(traffic_text(893, 0, 40), "893 B, mean 320 bit/s");
  EXPECT_EQ(traffic_text(0, 0, 0), "0 B");
}

TEST(ViewText, BytesAndSecondsAreWrittenAsInTheLanguage) {
  EXPECT_EQ(seconds_text(1), "1.00");
  auto french = load_language(std::string(AUCAST_TEST_DATA) + "/languages/fr.toml");
  ASSERT_TRUE(french) << french.error().message;
  use_language(std::move(french->language));
  EXPECT_EQ(bytes_text(2100), "2,1 ko");
  EXPECT_EQ(bit_rate_text(150), "1,2 kbit/s");
  EXPECT_EQ(seconds_text(1.254), "1,25");
  use_english();
}

TEST(ViewText, APlaceIsRoundedBeforeItIsSplitIntoMinutes) {
  EXPECT_EQ(time_text(Milliseconds(65'250)), "1:05.25");
  EXPECT_EQ(time_text(Milliseconds(59'994)), "0:59.99");
  EXPECT_EQ(time_text(Milliseconds(59'996)), "1:00.00");
}

TEST(ViewText, OfAStreamItIsSaidWhetherItIsLiveOrHowLong) {
  EXPECT_EQ(stream_in_words({"a", true, 60'000}), "live") << "how long it was matters less";
  EXPECT_EQ(stream_in_words({"a", false, 83'000}), "1:23");
  EXPECT_EQ(stream_in_words({"a", false}), "recorded");
  EXPECT_EQ(stream_in_words({"a", std::nullopt, 83'000}), "1:23");
  EXPECT_EQ(stream_in_words({"a", std::nullopt, std::nullopt, "A title"}), "");
  auto french = load_language(std::string(AUCAST_TEST_DATA) + "/languages/fr.toml");
  ASSERT_TRUE(french) << french.error().message;
  use_language(std::move(french->language));
  EXPECT_EQ(stream_in_words({"a", true}), "en direct");
  EXPECT_EQ(stream_in_words({"a", false, 83'000}), "1:23");
  EXPECT_EQ(stream_in_words({"a", false}), "enregistré");
  use_english();
}

TEST(ViewText, UnchangedAusHaveNoReason) {
  const AuFrame both = frame({{12, Side::Both, 80}, {1, Side::Both, 100}});
  EXPECT_EQ(au_rows(both, both, {}, kAll),
            (std::vector<AuRow>{{"1", "Inner Brow Raiser", 100, 100, ""},
                                {"12", "Lip Corner Puller", 80, 80, ""}}));
  EXPECT_TRUE(au_rows({}, {}, {}, kAll).empty());
}

TEST(ViewText, SidesThatDifferHaveRowsOfTheirOwn) {
  const AuFrame aus = frame({{12, Side::Left, 80}, {14, Side::Left, 10}, {14, Side::Right, 20}});
  const auto rows = au_rows(aus, aus, {}, kAll);
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0].label, "L12");
  EXPECT_EQ(rows[1].label, "L14");
  EXPECT_EQ(rows[2].label, "R14");
  EXPECT_EQ(rows[2].shown_percent, 20);
}

TEST(ViewText, AnAuThatFacsDoesNotNameHasTheNameThatItWasSavedWith) {
  face::AuRecordings recordings = kAll;
  recordings[90].note = "Puffy cheeks";
  recordings[12].note = "a smile";
  const AuFrame aus = frame({{12, Side::Both, 100}, {90, Side::Both, 100}});
  const auto rows = au_rows(aus, aus, {}, recordings);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].name, "Lip Corner Puller");
  EXPECT_EQ(rows[1].name, "Puffy cheeks");
  GuiModel model;
  EXPECT_EQ(au_name_of(model, 12), "Lip Corner Puller");
  std::vector<AuEntry> known(2);
  known[0].number = 12;
  known[0].name = "Lip Corner Puller";
  known[1].number = 90;
  known[1].name = "Puffy cheeks";
  model.known_aus = std::make_shared<const std::vector<AuEntry>>(known);
  EXPECT_EQ(au_name_of(model, 90), "Puffy cheeks");
  EXPECT_EQ(au_name_of(model, 91), "");
}

TEST(ViewText, AChangedAuNamesTheRule) {
  face::RuleSet rules;
  rules.rules.push_back({face::RuleKind::Opposition, {51, 52}, {}, 1, false, false, ""});
  const AuFrame received =
      frame({{51, Side::Both, 100}, {52, Side::Both, 40}, {1, Side::Both, 50}});
  std::vector<face::RuleFired> fired;
  const AuFrame blended = face::blend(rules, received, &fired);
  const auto rows = au_rows(received, blended, face::explain(fired), kAll);
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0].why, "");
  const std::string why = "opposition: 51 100 % and 52 40 %: 51 60 %, 52 gone";
  EXPECT_EQ(rows[1], (AuRow{"51", std::string(*facs_name(51)), 100, 60, why}));
  EXPECT_EQ(rows[2], (AuRow{"52", std::string(*facs_name(52)), 40, 0, why}));
}

}  // namespace
}  // namespace aucast::gui

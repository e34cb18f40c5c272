#include "client/app/window/playing/playback_history.h"

#include <gtest/gtest.h>

namespace aucast::app {
namespace {

AuFrame aus(std::initializer_list<AuTerm> terms) {
  return frame_from_terms({terms.begin(), terms.size()});
}

Instant at(int ms) {
  return Instant{} + Milliseconds(ms);
}

playback::SourceStatus bytes(std::uint64_t in, std::uint64_t out) {
  playback::SourceStatus status;
  status.bytes_received = in;
  status.bytes_sent = out;
  return status;
}

TEST(PlaybackHistory, SamplesFourTimesASecondForHalfAMinute) {
  PlaybackHistory history;
  int taken = 0;
  for (int ms = 0; ms <= 60'000; ms += 50) {
    if (!history.due(at(ms))) continue;
    history.add(at(ms), 0.5F, {}, {});
    ++taken;
  }
  EXPECT_EQ(taken, 241);
  EXPECT_EQ(history.fills().size(), 121U);
}

TEST(PlaybackHistory, IsEvenInTimeWhenThePlayerWasBusy) {
  PlaybackHistory history;
  history.add(at(0), 0.2F, {}, {});
  history.add(at(1000), 0.8F, {}, {});
  EXPECT_EQ(history.fills(), (std::vector<float>{0.2F, 0.2F, 0.2F, 0.2F, 0.8F}));
  history.add(at(3'600'000), 0.5F, {}, {});
  EXPECT_LE(history.fills().size(), 122U);
}

TEST(PlaybackHistory, CoversHalfAMinuteHoweverSlowTheDrawing) {
  PlaybackHistory history;
  for (int ms = 0; ms <= 60'000; ms += 380) {
    if (history.due(at(ms))) history.add(at(ms), 0.5F, {}, {});
  }
  EXPECT_GE(history.fills().size(), 120U);
}

TEST(PlaybackHistory, RatesAreOfTheLastTwoSeconds) {
  PlaybackHistory history;
  EXPECT_EQ(history.rates().in, 0);
  for (int i = 0; i <= 40; ++i) {
    const bool late = i > 32;
    history.add(at(250 * i), 0, bytes(late ? 1000U + 25U * static_cast<unsigned>(i - 32) : 1000, 8),
                {});
  }
  EXPECT_DOUBLE_EQ(history.rates().in, 100);
  EXPECT_DOUBLE_EQ(history.rates().out, 0);
}

TEST(PlaybackHistory, MeanRatesAreOfAllThatWas) {
  PlaybackHistory history;
  EXPECT_EQ(history.mean_rates().in, 0);
  history.add(at(0), 0, bytes(90, 0), {});  // quicker than the first sample
  EXPECT_EQ(history.mean_rates().in, 0);
  // All of it comes in the first second; a minute later the first samples are long forgotten.
  for (int i = 1; i <= 240; ++i) {
    history.add(at(250 * i), 0, bytes(i < 4 ? 150U * static_cast<unsigned>(i) : 600, 30), {});
  }
  EXPECT_EQ(history.rates().in, 0);
  EXPECT_DOUBLE_EQ(history.mean_rates().in, 10);
  EXPECT_DOUBLE_EQ(history.mean_rates().out, 0.5);
}

TEST(PlaybackHistory, TheStrongestAusAreTraced) {
  PlaybackHistory history;
  history.add(at(0), 0, {}, aus({{12, Side::Left, 40}}));
  history.add(at(250), 0, {}, aus({{12, Side::Right, 80}, {1, Side::Both, 10}}));
  auto traces = history.traces();
  ASSERT_EQ(traces.size(), 2U);
  EXPECT_EQ(traces[0], (gui::AuTrace{1, {0, 0.1F}}));
  EXPECT_EQ(traces[1], (gui::AuTrace{12, {0.4F, 0.8F}}));
  history.add(at(500), 0, {},
              aus({{2, Side::Both, 50},
                   {4, Side::Both, 50},
                   {5, Side::Both, 50},
                   {6, Side::Both, 50},
                   {7, Side::Both, 50}}));
  traces = history.traces();
  ASSERT_EQ(traces.size(), gui::kTracesMax);
  EXPECT_EQ(traces[0].number, 2);  // AU 1 was the weakest
  EXPECT_EQ(traces.back().number, 12);
}

}  // namespace
}  // namespace aucast::app

#include "client/sound/voice_track.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <map>

#include "client/playback/keyframe_source.h"
#include "client/sound/sound_mixer.h"
#include "common/voice/voice_encoder.h"
#include "tests/unit/sound/cranked_out.h"
#include "tests/unit/voice/speech_like.h"

namespace aucast::sound {
namespace {

using protocol::VoicePacket;
using test::largest_step;

std::vector<VoicePacket> packets(double seconds) {
  voice::VoiceEncoder encoder({});
  std::vector<VoicePacket> packets;
  encoder.add(voice::test::speech_like(seconds), packets);
  encoder.finish(packets);
  return packets;
}

void add(VoiceTrack& track, const std::vector<VoicePacket>& packets) {
  for (const VoicePacket& packet : packets) track.add(packet.place, packet.opus);
}

std::vector<float> read(VoiceTrack& track, int begin_ms, int count_ms) {
  std::vector<float> samples(static_cast<std::size_t>(count_ms) * kSamplesPerMs);
  track.read(std::int64_t{begin_ms} * kSamplesPerMs, samples);
  return samples;
}

float loudest(const std::vector<float>& samples) {
  float most = 0;
  for (const float sample : samples) most = std::max(most, std::abs(sample));
  return most;
}

TEST(VoiceTrack, EverySampleIsWhereItsPacketPutsIt) {
  VoiceTrack track;
  add(track, packets(2));
  std::vector<float> heard;
  // In portions that have nothing to do with the packets.
  for (int ms = 0; ms < 2000; ms += 25) {
    const auto portion = read(track, ms, 25);
    for (std::size_t i = 0; i < portion.size(); i += 3) heard.push_back(portion[i]);
  }
  const auto source = voice::test::speech_like(2);
  int best = -100;
  for (int lag = -100; lag <= 100; ++lag) {
    const double better = voice::test::correlation(source, heard, lag);
    if (better > voice::test::correlation(source, heard, best)) best = lag;
  }
  EXPECT_LE(std::abs(best), 2) << "samples of 1/16 ms";
  EXPECT_EQ(track.counts().gaps, 0U);
  EXPECT_EQ(track.counts().too_late, 0U);
  EXPECT_EQ(track.counts().packets, packets(2).size());
}

TEST(VoiceTrack, IsSilentBeforeAndAfter) {
  VoiceTrack track;
  EXPECT_EQ(loudest(read(track, 0, 50)), 0);
  for (const VoicePacket& packet : packets(0.5)) {
    track.add(packet.place + Milliseconds(100), packet.opus);
  }
  EXPECT_EQ(loudest(read(track, 50, 50)), 0);
  EXPECT_GT(loudest(read(track, 100, 500)), 0.1F);
  EXPECT_EQ(loudest(read(track, 700, 100)), 0);
}

TEST(VoiceTrack, EndsAtMostTwoSecondsAfterTheLastKeyframe) {
  VoiceTrack track;
  const auto spoken = packets(0.3);
  add(track, spoken);
  const std::int64_t voice_end = track.end();
  const auto second = std::int64_t{1000} * kSamplesPerMs;
  const std::string& opus = spoken.front().opus;
  track.add(Milliseconds(2900), opus);
  track.add(Milliseconds(3000), opus);
  track.add(Milliseconds(1'000'000'000'000), opus);
  track.end_at(second);
  EXPECT_EQ(track.counts().left_out, 2U);
  EXPECT_GT(track.end(), second * 29 / 10);
  EXPECT_LE(track.end(), 3 * second);
  track.end_at(second / 2);
  EXPECT_EQ(track.counts().left_out, 3U);
  EXPECT_EQ(track.end(), voice_end);
}

TEST(VoiceTrack, EndsWhereItIsReadIfNoPacketIsLeft) {
  VoiceTrack track;
  read(track, 0, 500);
  track.add(Milliseconds(1'000'000'000'000), packets(0.1).front().opus);
  track.end_at(std::int64_t{500} * kSamplesPerMs);
  EXPECT_LE(track.end(), std::int64_t{500} * kSamplesPerMs);
}

TEST(VoiceTrack, AGapFadesOutAndInAgain) {
  auto all = packets(3);
  // 300 ms in the middle of a syllable are not there.
  all.erase(all.begin() + 16, all.begin() + 21);
  VoiceTrack track;
  add(track, all);
  const auto heard = read(track, 0, 3000);
  VoiceTrack whole;
  add(whole, packets(3));
  const float smooth = largest_step(read(whole, 0, 3000));
  EXPECT_LE(largest_step(heard), smooth * 1.2F);
  EXPECT_EQ(track.counts().gaps, 1U);
  const std::vector<float> hole(heard.begin() + (16 * 60 + 20) * kSamplesPerMs,
                                heard.begin() + 21 * 60 * kSamplesPerMs);
  EXPECT_EQ(loudest(hole), 0);
}

TEST(VoiceTrack, APacketThatComesTooLateIsCountedAndDoesNotClick) {
  const auto all = packets(1);
  VoiceTrack track;
  std::vector<float> heard;
  // Packet 5 comes when its first third has been silent, packet 8 not before it is over.
  const std::map<std::size_t, int> late{{5, 5 * 60 + 20}, {8, 10 * 60}};
  std::size_t next = 0;
  for (int ms = 0; ms < 900; ms += 10) {
    while (next < all.size() && late.contains(next) == false && all[next].place.count() <= ms) {
      track.add(all[next].place, all[next].opus);
      ++next;
    }
    if (late.contains(next) && ms >= late.at(next)) {
      track.add(all[next].place, all[next].opus);
      ++next;
    }
    const auto portion = read(track, ms, 10);
    heard.insert(heard.end(), portion.begin(), portion.end());
  }
  VoiceTrack whole;
  add(whole, all);
  EXPECT_LE(largest_step(heard), largest_step(read(whole, 0, 1000)) * 1.2F);
  EXPECT_GE(track.counts().too_late, 1U);
  EXPECT_GE(track.counts().gaps, 2U);
}

TEST(VoiceTrack, AfterALeapTheVoiceIsAsIfNothingHadBeenLeftOut) {
  const auto all = packets(20);
  VoiceTrack leapt;
  add(leapt, all);
  (void)read(leapt, 0, 100);
  const auto heard = read(leapt, 15'000, 1000);
  VoiceTrack straight;
  add(straight, all);
  (void)read(straight, 0, 15'000);
  const auto expected = read(straight, 15'000, 1000);
  double error = 0;
  double power = 0;
  for (std::size_t i = 0; i < heard.size(); ++i) {
    error += std::pow(heard[i] - expected[i], 2);
    power += std::pow(expected[i], 2);
  }
  EXPECT_LT(error, power / 100);
  EXPECT_EQ(leapt.counts().too_late, 0U) << "what was leapt over was not late";
}

TEST(VoiceTrack, KeepsNoMoreThanItsLimitOfWhatNobodyReads) {
  VoiceTrack track;
  const std::string opus = packets(0.1).front().opus;
  const std::size_t fit = playback::kVoiceBytesMax / opus.size();
  for (std::size_t i = 0; i < fit + 10; ++i) {
    track.add(Milliseconds(60 * static_cast<int>(i)), opus);
  }
  EXPECT_EQ(track.counts().left_out, 10U);
  EXPECT_EQ(track.counts().too_late, 0U);
}

TEST(VoiceTrack, PacketsOfOneByteHaveTheirLimitToo) {
  VoiceTrack track;
  const std::string opus(1, '\0');  // 10 ms
  for (std::size_t i = 0; i < playback::kVoicePacketsMax + 10; ++i) {
    track.add(Milliseconds(10 * static_cast<int>(i)), opus);
  }
  EXPECT_EQ(track.counts().left_out, 10U);
  EXPECT_EQ(track.end(), std::int64_t{playback::kVoicePacketsMax} * 10 * kSamplesPerMs);
}

TEST(VoiceTrack, WhatIsNoOpusPacketOrOutOfOrderIsLeftOut) {
  VoiceTrack track;
  track.add(Milliseconds(0), "");
  EXPECT_EQ(track.counts().unreadable, 1U);
  const auto all = packets(0.5);
  add(track, all);
  track.add(Milliseconds(0), all[0].opus);
  EXPECT_EQ(track.counts().out_of_order, 1U);
  track.add(Milliseconds(6000), std::string(1, '\x08') + std::string(50, '\xff'));
  EXPECT_GT(loudest(read(track, 0, 500)), 0.1F);
  for (const float sample : read(track, 6000, 60)) EXPECT_TRUE(std::isfinite(sample));
  // Two frames of the same length in an odd number of bytes.
  track.add(Milliseconds(7000), std::string(1, '\x09') + std::string(3, '\xff'));
  (void)read(track, 7000, 60);
  EXPECT_EQ(track.counts().unreadable, 2U);
  EXPECT_EQ(track.counts().too_late, 0U);
}

}  // namespace
}  // namespace aucast::sound

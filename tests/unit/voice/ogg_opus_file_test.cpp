#include "common/voice/ogg_opus_file.h"

#include <gtest/gtest.h>

#include "common/voice/sound_file.h"
#include "common/voice/voice_encoder.h"
#include "tests/support/temp_folder.h"
#include "tests/unit/voice/speech_like.h"

namespace aucast::voice {
namespace {

using aucast::test::TempFolder;
using test::correlation;
using test::speech_like;

std::vector<protocol::VoicePacket> packets_of(const std::vector<float>& samples,
                                              Milliseconds begin) {
  VoiceEncoder encoder({}, begin);
  std::vector<protocol::VoicePacket> packets;
  encoder.add(samples, packets);
  encoder.finish(packets);
  return packets;
}

std::vector<float> read_back(const TempFolder& folder, const std::string& bytes) {
  auto file = SoundFile::open(folder.write("voice.opus", bytes));
  EXPECT_TRUE(file) << file.error().message;
  if (!file) return {};
  std::vector<float> samples(100 * kEncoderRate);
  samples.resize(file->read(samples));
  return samples;
}

TEST(OggOpusWriter, WhatIsWrittenIsReadBackInPlace) {
  const TempFolder folder;
  const auto source = speech_like(3.2);
  OggOpusWriter writer(Milliseconds(5000), 7);
  for (const auto& packet : packets_of(source, Milliseconds(5000))) {
    EXPECT_TRUE(writer.add(packet));
  }
  const auto samples = read_back(folder, writer.take() + writer.finish(Milliseconds(8500)));
  EXPECT_NEAR(static_cast<double>(samples.size()), 3.5 * kEncoderRate, 400);
  EXPECT_GT(correlation(source, samples, 0), 0.8);
}

TEST(OggOpusWriter, AGapIsSilenceOfItsLength) {
  const TempFolder folder;
  OggOpusWriter writer(Milliseconds(0), 7);
  // Who falls silent is sent for 0.24 s more: the decoder knows then what the silence is like.
  auto source = speech_like(0.6);
  source.resize(kEncoderRate);
  for (const auto& packet : packets_of(source, Milliseconds(0))) (void)writer.add(packet);
  for (const auto& packet : packets_of(source, Milliseconds(4000))) (void)writer.add(packet);
  const auto samples = read_back(folder, writer.take() + writer.finish(Milliseconds(5200)));
  ASSERT_EQ(samples.size(), std::size_t{52} * kEncoderRate / 10);
  float loudest = 0;
  for (int i = 2 * kEncoderRate; i < 3 * kEncoderRate; ++i) {
    loudest = std::max(loudest, std::abs(samples[static_cast<std::size_t>(i)]));
  }
  EXPECT_LT(loudest, 0.01F);
}

TEST(OggOpusWriter, EndsToTheSampleWhereItIsTold) {
  const TempFolder folder;
  for (const int end_ms : {600, 605, 610, 619, 620, 1007}) {
    OggOpusWriter writer(Milliseconds(0), 7);
    for (const auto& packet : packets_of(speech_like(0.6), Milliseconds(0))) {
      (void)writer.add(packet);
    }
    const auto samples = read_back(folder, writer.take() + writer.finish(Milliseconds(end_ms)));
    EXPECT_EQ(samples.size(), static_cast<std::size_t>(end_ms) * kEncoderSamplesPerMs) << end_ms;
  }
}

TEST(OggOpusWriter, WhatFollowsAGapOfAnyLengthIsLessThanTenMillisecondsEarly) {
  for (int gap_ms = 300; gap_ms < 340; ++gap_ms) {
    OggOpusWriter writer(Milliseconds(0), 7);
    const auto packets = packets_of(speech_like(0.06), Milliseconds(0));
    const Milliseconds place(60 + gap_ms);
    EXPECT_TRUE(writer.add(packets[0]));
    EXPECT_TRUE(writer.add({place, packets[0].opus}));
    // What begins before the end of what is there is refused.
    EXPECT_FALSE(writer.add({place + Milliseconds(50), packets[0].opus}));
    EXPECT_TRUE(writer.add({place + Milliseconds(60), packets[0].opus}));
  }
}

TEST(OggOpusWriter, PlaysWhereverItIsCutAtASecond) {
  const TempFolder folder;
  OggOpusWriter writer(Milliseconds(0), 7);
  for (const auto& packet : packets_of(speech_like(5), Milliseconds(0))) (void)writer.add(packet);
  const auto samples = read_back(folder, writer.take());  // never finished
  EXPECT_GE(samples.size(), 4U * kEncoderRate - 400U);
}

TEST(OggOpusWriter, LeavesOutWhatOverlapsOrIsNoPacket) {
  OggOpusWriter writer(Milliseconds(0), 7);
  const auto packets = packets_of(speech_like(0.3), Milliseconds(0));
  EXPECT_TRUE(writer.add(packets[1]));
  EXPECT_FALSE(writer.add(packets[0]));
  EXPECT_FALSE(writer.add({Milliseconds(1000), ""}));
}

}  // namespace
}  // namespace aucast::voice

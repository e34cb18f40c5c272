#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "common/voice/voice_decoder.h"
#include "common/voice/voice_encoder.h"
#include "tests/unit/voice/speech_like.h"

namespace aucast::voice {
namespace {

using protocol::VoicePacket;
using test::correlation;
using test::speech_like;

std::vector<VoicePacket> encode(const std::vector<float>& samples, VoiceSettings settings = {},
                                std::size_t at_once = 1000) {
  VoiceEncoder encoder(settings);
  std::vector<VoicePacket> packets;
  for (std::size_t at = 0; at < samples.size(); at += at_once) {
    const std::size_t count = std::min(at_once, samples.size() - at);
    encoder.add({samples.data() + at, count}, packets);
  }
  encoder.finish(packets);
  return packets;
}

/// Every third sample of what is decoded: the encoder's rate.
std::vector<float> decode(const std::vector<VoicePacket>& packets) {
  VoiceDecoder decoder;
  std::vector<float> samples;
  for (const VoicePacket& packet : packets) {
    const auto sound = decoder.decode(packet.opus);
    samples.resize(static_cast<std::size_t>(packet.place.count()) * kEncoderSamplesPerMs);
    for (std::size_t i = 0; i < sound.size(); i += 3) samples.push_back(sound[i]);
  }
  return samples;
}

TEST(VoiceCodec, DecodesToWhereTheSoundWas) {
  const auto source = speech_like(4);
  const auto decoded = decode(encode(source));
  ASSERT_GE(decoded.size(), source.size());
  int best = -100;
  for (int lag = -100; lag <= 100; ++lag) {
    if (correlation(source, decoded, lag) > correlation(source, decoded, best)) best = lag;
  }
  EXPECT_LE(std::abs(best), 1) << "samples of 1/16 ms";
  EXPECT_GT(correlation(source, decoded, 0), 0.7);
}

TEST(VoiceCodec, PacketsFollowEachOtherAndHaveTheLengthAskedFor) {
  for (const int ms : {20, 40, 60}) {
    const auto packets = encode(speech_like(2), {10000, Milliseconds(ms)});
    for (std::size_t i = 0; i < packets.size(); ++i) {
      EXPECT_EQ(packets[i].place, Milliseconds(ms) * static_cast<int>(i));
      EXPECT_EQ(protocol::opus_duration(packets[i].opus), Milliseconds(ms));
    }
    EXPECT_GE(packets.back().place + Milliseconds(ms), Milliseconds(2000));
  }
}

TEST(VoiceCodec, KeepsTheRate) {
  std::size_t bytes = 0;
  for (const VoicePacket& packet : encode(speech_like(10))) bytes += packet.opus.size();
  EXPECT_LT(static_cast<double>(bytes) * 8 / 10, 11500);
  EXPECT_GT(static_cast<double>(bytes) * 8 / 10, 6000);
}

TEST(VoiceCodec, CuttingTheSamplesChangesNothing) {
  const auto source = speech_like(1);
  EXPECT_EQ(encode(source, {}, 1), encode(source, {}, 16000));
}

TEST(VoiceCodec, SilenceMakesNoPacketsButPausesOfSpeechDo) {
  const auto silence = encode(std::vector<float>(32000, 0.001F));
  ASSERT_EQ(silence.size(), 1U) << "only its end";
  EXPECT_EQ(silence.front().place, Milliseconds(1980));

  auto source = speech_like(1);
  source.resize(2 * kEncoderRate);  // a second of silence
  const auto more = speech_like(1);
  source.insert(source.end(), more.begin(), more.end());
  const auto packets = encode(source);
  std::vector<Milliseconds> holes;
  for (std::size_t i = 1; i < packets.size(); ++i) {
    const Milliseconds end = packets[i - 1].place + Milliseconds(60);
    if (packets[i].place != end) holes.push_back(packets[i].place - end);
  }
  ASSERT_EQ(holes.size(), 1U);
  EXPECT_GE(holes[0], Milliseconds(600));
  EXPECT_LE(holes[0], Milliseconds(1000));
}

TEST(VoiceCodec, WhatDecodesIsAsLongAsTheSoundEvenIfItEndsInSilence) {
  for (const int ms : {20, 40, 60}) {
    const std::size_t frame = static_cast<std::size_t>(ms) * kEncoderSamplesPerMs;
    for (const std::size_t length : {std::size_t{3}, 48 * frame, 48 * frame + 1, 49 * frame - 1}) {
      auto source = speech_like(1);
      source.resize(length);
      const std::size_t whole = (length + frame - 1) / frame * frame;
      EXPECT_EQ(decode(encode(source, {10000, Milliseconds(ms)})).size(), whole)
          << length << " samples in packets of " << ms << " ms";
    }
  }
}

TEST(VoiceCodec, GoesOnElsewhere) {
  VoiceEncoder encoder({});
  std::vector<VoicePacket> packets;
  const auto source = speech_like(0.5);
  encoder.add(source, packets);
  encoder.go_on_at(Milliseconds(10000));
  encoder.add(source, packets);
  encoder.finish(packets);
  EXPECT_EQ(packets.front().place, Milliseconds(0));
  EXPECT_EQ(packets.back().place, Milliseconds(10480));
}

TEST(VoiceDecoder, BytesThatAreNoPacketMakeNoSound) {
  VoiceDecoder decoder;
  EXPECT_TRUE(decoder.decode("").empty());
  EXPECT_TRUE(decoder.decode("\xff\xff\xff").empty());
  EXPECT_EQ(decoder.conceal().size(), 960U);
}

}  // namespace
}  // namespace aucast::voice

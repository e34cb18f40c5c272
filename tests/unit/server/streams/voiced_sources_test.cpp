// Sources with a voice: how they are loaded, served and reported on.
#include <sys/stat.h>

#include "server/streams/check_report.h"
#include "server/streams/estimate.h"
#include "server/streams/load_sources.h"
#include "server/streams/repertoire.h"
#include "tests/unit/server/voice/voiced_folder.h"
#include "tests/unit/voice/speech_like.h"

namespace aucast::server {
namespace {

using namespace std::chrono_literals;

void append(std::vector<float>& samples, const std::vector<float>& more) {
  samples.insert(samples.end(), more.begin(), more.end());
}

using VoicedSources = VoicedFolder;

TEST_F(VoicedSources, GoesWithItsStreamUnlessItIsNotWanted) {
  const auto face = write_face("talk.txt", 2);
  const auto other = write_face("zoo.txt", 2);
  const auto sound = write_wav("talk.wav", voice::test::speech_like(2));
  folder_.write("talk.vtt", "WEBVTT\n\n00:00.500 --> 00:01.000\nGood morning\n");
  const auto found = load_sources({folder_.path()});
  ASSERT_TRUE(found) << found.error().message;
  ASSERT_EQ(found->size(), 2U) << "a sound file is no source";
  EXPECT_EQ(found->at(0).voice->path, sound);
  EXPECT_EQ(found->at(0).title.text, "A talk");
  ASSERT_EQ(found->at(0).captions.size(), 2U);
  EXPECT_FALSE(found->at(1).voice);

  EncodingOptions encoding;
  encoding.voice.file = sound;
  const auto named = load_sources({other, face}, {}, encoding);
  ASSERT_TRUE(named);
  EXPECT_EQ(named->at(0).voice->path, sound) << "the first source's";
  EXPECT_EQ(named->at(1).voice->path, sound) << "its own";

  encoding.voice.none = true;
  const auto faces = load_sources({face}, {}, encoding);
  ASSERT_TRUE(faces);
  EXPECT_FALSE(faces->at(0).voice);
  EXPECT_EQ(faces->at(0).captions.size(), 2U);
}

TEST_F(VoicedSources, WhatIsNoSoundIsSaidWithARemedy) {
  const auto face = write_face("talk.txt", 2);
  folder_.write("talk.wav", "no sound at all");
  const auto bad = load_sources({face});
  ASSERT_FALSE(bad);
  EXPECT_EQ(bad.error().kind, ErrorKind::BadData);
  EXPECT_NE(bad.error().message.find("talk.wav: no sound that can be read"), std::string::npos);
  EXPECT_NE(bad.error().message.find("--no-voice"), std::string::npos);
  std::filesystem::remove(folder_.path() / "talk.wav");
  ASSERT_EQ(::mkfifo((folder_.path() / "talk.wav").c_str(), 0600), 0);
  EXPECT_EQ(load_sources({face}).error().kind, ErrorKind::Unreadable);
  EncodingOptions encoding;
  encoding.voice.none = true;
  EXPECT_TRUE(load_sources({face}, {}, encoding));
}

TEST_F(VoicedSources, IsAlignedWithTheRowsOfARecording) {
  const auto table = folder_.write(
      "talk.csv", "frame,timestamp,confidence,AU12_r\n1,0.00,1,1\n2,0.04,1,2\n3,0.08,1,3\n");
  write_wav("talk.wav", voice::test::speech_like(1));
  const auto sources = load_sources({table});
  ASSERT_TRUE(sources) << sources.error().message;
  EXPECT_EQ(sources->front().voice->begin, 40ms)
      << "the first row is reached when the first keyframe is over";
}

TEST_F(VoicedSources, ADelayThatLeavesNothingOfTheSoundIsRefused) {
  const auto face = write_face("talk.txt", 3);
  write_wav("talk.wav", voice::test::speech_like(2));
  EncodingOptions early;
  early.voice.delay = -1900ms;
  EXPECT_TRUE(load_sources({face}, {}, early));
  early.voice.delay = -2000ms;
  const auto refused = load_sources({face}, {}, early);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::Usage);
  EXPECT_NE(refused.error().message.find(
                "talk.wav: --voice-delay -2000 leaves nothing of a sound of 2000 ms"),
            std::string::npos)
      << refused.error().message;
}

TEST_F(VoicedSources, ASoundThatIsTooShortIsNotBlamedOnTheDelay) {
  const auto face = write_face("talk.txt", 3);
  write_wav("talk.wav", std::vector<float>(voice::kEncoderSamplesPerMs - 1));
  const auto refused = load_sources({face});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::BadData);
  EXPECT_NE(refused.error().message.find("talk.wav: it has less than a millisecond of sound (--no"),
            std::string::npos)
      << refused.error().message;
  write_wav("talk.wav", std::vector<float>(voice::kEncoderSamplesPerMs));
  EXPECT_TRUE(load_sources({face}));
}

TEST_F(VoicedSources, TheVoicedStreamHoldsTheFaceUntilTheVoiceIsOver) {
  const auto face = write_face("talk.txt", 2);
  write_wav("talk.wav", voice::test::speech_like(6));
  const auto sources = load_sources({face});
  ASSERT_TRUE(sources);
  const Repertoire repertoire = make_repertoire(*sources);
  const protocol::RecordedStream& stream = *repertoire.front().stream.recorded();
  EXPECT_EQ(repertoire.front().stream.title, "A talk");
  ASSERT_TRUE(stream.voiced);
  EXPECT_EQ(stream.encoded->duration_ms, 2000U);
  EXPECT_GE(stream.voiced->duration_ms, 6000U);
  ASSERT_TRUE(repertoire.front().voice);
}

TEST_F(VoicedSources, CheckTellsLengthsAndSilence) {
  const auto face = write_face("talk.txt", 2);
  std::vector<float> sound = voice::test::speech_like(3);
  append(sound, std::vector<float>(std::size_t{4} * voice::kEncoderRate));
  append(sound, voice::test::speech_like(1));
  write_wav("talk.wav", sound);
  const auto sources = load_sources({face});
  ASSERT_TRUE(sources);
  const auto summary = summarise_voice(*sources->front().voice, {});
  ASSERT_TRUE(summary);
  ASSERT_EQ(summary->silences.size(), 1U);
  EXPECT_NEAR(static_cast<double>(summary->silences[0].begin.count()), 3200, 100);
  EXPECT_NEAR(static_cast<double>(summary->silences[0].end.count()), 7000, 100);
  const std::string report = check_report(sources->front(), 250, &*summary);
  EXPECT_NE(report.find("the voice ends at 8.000 s"), std::string::npos) << report;
  EXPECT_NE(report.find(", the face at 2.000 s"), std::string::npos) << report;
  EXPECT_NE(report.find("  silence     3."), std::string::npos) << report;
  EXPECT_NE(report.find("  title       A talk\n"), std::string::npos) << report;
  const std::string estimate = estimate_report(sources->front(), 0ms, &*summary);
  EXPECT_NE(estimate.find("  voice alone "), std::string::npos) << estimate;
  EXPECT_NE(estimate.find("  changes+voice "), std::string::npos) << estimate;
}

TEST_F(VoicedSources, CheckTellsThatTheSoundWasCutOff) {
  const auto face = write_face("talk.txt", 2);
  const auto sound = write_wav("talk.wav", voice::test::speech_like(2));
  std::filesystem::resize_file(sound, std::filesystem::file_size(sound) / 2);
  const auto sources = load_sources({face});
  ASSERT_TRUE(sources);
  const auto summary = summarise_voice(*sources->front().voice, {});
  ASSERT_TRUE(summary);
  const std::string report = check_report(sources->front(), 250, &*summary);
  EXPECT_NE(report.find("talk.wav: the sound breaks off before its end: of 64000 bytes of sound"),
            std::string::npos)
      << report;
}

}  // namespace
}  // namespace aucast::server

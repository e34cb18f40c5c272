// The files beside a source, and a voice that is encoded in the background.
#include "server/voice/voice_file.h"

#include <sys/stat.h>

#include <gtest/gtest.h>
#include <sndfile.h>

#include <asio/executor_work_guard.hpp>

#include "server/streams/check_report.h"
#include "server/streams/estimate.h"
#include "server/streams/repertoire.h"
#include "server/voice/companions.h"
#include "server/voice/voice_summary.h"
#include "server/voice/voice_tracks.h"
#include "tests/support/quiet_log.h"
#include "tests/support/run_until.h"
#include "tests/support/temp_folder.h"
#include "tests/unit/voice/speech_like.h"

namespace aucast::server {
namespace {

using namespace std::chrono_literals;
using test::TempFolder;

void append(std::vector<float>& samples, const std::vector<float>& more) {
  samples.insert(samples.end(), more.begin(), more.end());
}

class VoiceFileTest : public ::testing::Test {
 protected:
  std::filesystem::path write_wav(const std::string& name, const std::vector<float>& samples) {
    const auto path = folder_.path() / name;
    SF_INFO info{};
    info.samplerate = voice::kEncoderRate;
    info.channels = 1;
    info.format = SF_FORMAT_WAV | SF_FORMAT_PCM_16;
    SNDFILE* const file = sf_open(path.c_str(), SFM_WRITE, &info);
    EXPECT_NE(file, nullptr);
    sf_write_float(file, samples.data(), static_cast<sf_count_t>(samples.size()));
    sf_close(file);
    return path;
  }
  std::filesystem::path write_face(const std::string& name, int seconds) {
    std::string text = "# title: A talk\nBeg_Stream\n";
    for (int i = 0; i < seconds; ++i) text += i % 2 == 0 ? "12:50;1000\n" : "12:10;1000\n";
    return folder_.write(name, text + "End_Stream\n");
  }
  [[nodiscard]] std::vector<protocol::VoicePacket> encoded(const VoiceFile& file) const {
    const auto summary = summarise_voice(file, {});
    EXPECT_TRUE(summary);
    return summary->packets;
  }

  const test::QuietLog quiet_;
  const TempFolder folder_;
};

TEST_F(VoiceFileTest, ASoundFileOfTheSameNameIsTheVoice) {
  const auto face = write_face("talk.txt", 2);
  EXPECT_FALSE(companions_of(face).sound);
  EXPECT_FALSE(companions_of(face).captions);
  folder_.write("talk.mp3", "");
  folder_.write("talk.flac", "");
  folder_.write("other.wav", "");
  folder_.write("talk.vtt", "");
  EXPECT_EQ(companions_of(face).sound, folder_.path() / "talk.flac");
  EXPECT_EQ(companions_of(face).captions, folder_.path() / "talk.vtt");
}

TEST_F(VoiceFileTest, GoesWithItsStreamUnlessItIsNotWanted) {
  const auto face = write_face("talk.txt", 2);
  const auto other = write_face("zoo.txt", 2);
  const auto sound = write_wav("talk.wav", voice::test::speech_like(2));
  folder_.write("talk.vtt", "WEBVTT\n\n00:00.500 --> 00:01.000\nGood morning\n");
  const auto found = load_sources({folder_.path()});
  ASSERT_TRUE(found) << found.error().message;
  ASSERT_EQ(found->size(), 2U) << "a sound file is no source";
  EXPECT_EQ(found->at(0).voice->path, sound);
  EXPECT_EQ(found->at(0).title, "A talk");
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

TEST_F(VoiceFileTest, WhatIsNoSoundIsSaidWithARemedy) {
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

TEST_F(VoiceFileTest, IsAlignedWithTheRowsOfARecording) {
  const auto table = folder_.write(
      "talk.csv", "frame,timestamp,confidence,AU12_r\n1,0.00,1,1\n2,0.04,1,2\n3,0.08,1,3\n");
  write_wav("talk.wav", voice::test::speech_like(1));
  const auto sources = load_sources({table});
  ASSERT_TRUE(sources) << sources.error().message;
  EXPECT_EQ(sources->front().voice->begin, 40ms)
      << "the first row is reached when the first keyframe is over";
}

TEST_F(VoiceFileTest, WhatLiesBeforeTheStreamIsLeftOut) {
  const auto path = write_wav("talk.wav", voice::test::speech_like(3));
  const auto later = encoded(*find_voice_file(path, 500ms));
  EXPECT_EQ(later.front().place, 500ms);
  const auto sooner = encoded(*find_voice_file(path, -500ms));
  EXPECT_EQ(sooner.front().place, 0ms);
  EXPECT_LT(sooner.size(), later.size());
}

TEST_F(VoiceFileTest, TheVoicedStreamHoldsTheFaceUntilTheVoiceIsOver) {
  const auto face = write_face("talk.txt", 2);
  write_wav("talk.wav", voice::test::speech_like(6));
  const auto sources = load_sources({face});
  ASSERT_TRUE(sources);
  const Repertoire repertoire = make_repertoire(*sources, 250, false);
  const protocol::RecordedStream& stream = *repertoire.catalogue.streams.front().recorded();
  EXPECT_EQ(repertoire.catalogue.streams.front().title, "A talk");
  ASSERT_TRUE(stream.voiced);
  EXPECT_EQ(stream.encoded->duration_ms, 2000U);
  EXPECT_GE(stream.voiced->duration_ms, 6000U);
  ASSERT_TRUE(repertoire.voices.front());
}

TEST_F(VoiceFileTest, MaxBitrateTakesTheVoiceFirst) {
  EXPECT_EQ(voice_kbits({}), 14U);
  EXPECT_EQ(voice_kbits({24000, 20ms}), 34U);
  EXPECT_EQ(*face_kbits(24, {}, "talk.txt"), 10U);
  EXPECT_EQ(*face_kbits(0, {}, "talk.txt"), 0U) << "no limit stays none";
  const auto refused = face_kbits(15, {}, "talk.txt");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::Usage);
}

TEST_F(VoiceFileTest, CheckTellsLengthsAndSilence) {
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

class VoiceTracksTest : public VoiceFileTest {
 protected:
  void run_until_complete(const protocol::EncodedTrack& track) {
    EXPECT_TRUE(test::run_until(io_, [&track] { return track.complete(); }));
  }

  asio::io_context io_;
  const asio::executor_work_guard<asio::io_context::executor_type> work_ =
      asio::make_work_guard(io_);
  int grown_ = 0;
  VoiceTracks tracks_{io_, {}, [this] { ++grown_; }};
};

TEST_F(VoiceTracksTest, EncodesAFileOnceInTheBackground) {
  const auto file = *find_voice_file(write_wav("talk.wav", voice::test::speech_like(5)), 0ms);
  const auto track = tracks_.track_of(file);
  EXPECT_FALSE(track->complete());
  EXPECT_EQ(tracks_.track_of(file), track) << "the same file is the same voice";
  run_until_complete(*track);
  EXPECT_GT(grown_, 1) << "it comes in pieces";
  EXPECT_EQ(track->packets().size(), encoded(file).size());
  EXPECT_EQ(tracks_.track_of(file), track) << "not encoded again";
}

TEST_F(VoiceTracksTest, AFileThatChangedIsAnotherVoice) {
  const auto path = write_wav("talk.wav", voice::test::speech_like(1));
  const auto before = tracks_.track_of(*find_voice_file(path, 0ms));
  write_wav("talk.wav", voice::test::speech_like(2));
  EXPECT_NE(tracks_.track_of(*find_voice_file(path, 0ms)), before);
  EXPECT_NE(tracks_.track_of(*find_voice_file(path, 40ms)), before);
}

TEST_F(VoiceTracksTest, AFileThatIsGoneWhenItsTurnComesIsNoVoice) {
  const auto path = write_wav("talk.wav", voice::test::speech_like(1));
  const auto file = *find_voice_file(path, 0ms);
  std::filesystem::remove(path);
  const auto track = tracks_.track_of(file);
  run_until_complete(*track);
  EXPECT_TRUE(track->packets().empty());
}

}  // namespace
}  // namespace aucast::server

// The files beside a source, and a voice that is encoded in the background.
#include "server/voice/voice_file.h"

#include <asio/executor_work_guard.hpp>

#include "server/voice/accompaniment.h"
#include "server/voice/voice_tracks.h"
#include "tests/support/run_until.h"
#include "tests/unit/server/voice/voiced_folder.h"
#include "tests/unit/voice/speech_like.h"

namespace aucast::server {
namespace {

using namespace std::chrono_literals;

using VoiceFileTest = VoicedFolder;

TEST_F(VoiceFileTest, ASoundFileOfTheSameNameIsTheVoice) {
  const auto face = write_face("talk.txt", 2);
  const auto alone = accompaniment_of(face, {}, true);
  ASSERT_TRUE(alone);
  EXPECT_FALSE(alone->voice);
  EXPECT_TRUE(alone->captions.empty());
  folder_.write("talk.mp3", "");
  std::filesystem::create_directory(folder_.path() / "talk.wav");
  write_wav("other.wav", voice::test::speech_like(1));
  write_wav("talk.flac", voice::test::speech_like(1));
  folder_.write("talk.vtt", "WEBVTT\n\n00:00.000 --> 00:01.000\nHello\n");
  const auto all = accompaniment_of(face, {}, true);
  ASSERT_TRUE(all) << all.error().message;
  EXPECT_EQ(all->voice->path, folder_.path() / "talk.flac");
  EXPECT_FALSE(all->captions.empty());
  VoiceOptions asked;
  asked.file = folder_.path() / "other.wav";
  EXPECT_EQ(accompaniment_of(face, asked, true)->voice->path, asked.file);
  EXPECT_EQ(accompaniment_of(face, asked, false)->voice->path, folder_.path() / "talk.flac");
  asked.none = true;
  EXPECT_FALSE(accompaniment_of(face, asked, true)->voice);
}

TEST_F(VoiceFileTest, ALinkToNowhereIsSaid) {
  const auto face = write_face("talk.txt", 2);
  std::filesystem::create_symlink("gone.vtt", folder_.path() / "talk.vtt");
  EXPECT_EQ(accompaniment_of(face, {}, true).error().kind, ErrorKind::Unreadable);
}

TEST_F(VoiceFileTest, WhatLiesBeforeTheStreamIsLeftOut) {
  const auto path = write_wav("talk.wav", voice::test::speech_like(3));
  const auto later = encoded(*find_voice_file(path, 500ms));
  EXPECT_EQ(later.front().place, 500ms);
  const auto sooner = encoded(*find_voice_file(path, -500ms));
  EXPECT_EQ(sooner.front().place, 0ms);
  EXPECT_LT(sooner.size(), later.size());
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

class VoiceTracksTest : public VoicedFolder {
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

TEST_F(VoiceTracksTest, TheEncoderWaitsForALoopThatIsBusy) {
  const auto talk = *find_voice_file(write_wav("talk.wav", voice::test::speech_like(20)), 0ms);
  const auto other = *find_voice_file(write_wav("other.wav", voice::test::speech_like(20)), 0ms);
  int pieces = 0;
  std::size_t waiting = 0;
  VoiceTracks busy(io_, {}, [&] {
    if (++pieces > 1) return;
    static_cast<void>(encoded(other));  // so long as another thread needs for all of its pieces
    waiting = io_.poll();
  });
  const auto track = busy.track_of(talk);
  run_until_complete(*track);
  EXPECT_EQ(waiting, 0U) << "pieces were encoded that nobody had taken yet";
  EXPECT_GT(pieces, 2);
}

TEST_F(VoiceTracksTest, AfterAStopNoMoreIsEncoded) {
  const auto talk = *find_voice_file(write_wav("talk.wav", voice::test::speech_like(20)), 0ms);
  const auto other = *find_voice_file(write_wav("other.wav", voice::test::speech_like(1)), 0ms);
  const auto track = tracks_.track_of(talk);
  EXPECT_TRUE(test::run_until(io_, [this] { return grown_ > 0; }));
  tracks_.stop();
  const auto late = tracks_.track_of(other);
  // The piece that was being read may still come.
  io_.run_for(200ms);
  EXPECT_LE(grown_, 2);
  EXPECT_FALSE(track->complete() || late->complete());
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

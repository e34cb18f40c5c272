#include "client/pipeline/player.h"

#include <gtest/gtest.h>

#include <memory>
#include <utility>
#include <vector>

#include "client/playback/seekable_playback.h"
#include "client/playback/source_playback.h"
#include "tests/support/allocations.h"
#include "tests/support/manual_clock.h"
#include "tests/unit/playback/scripted_source.h"

namespace aucast::pipeline {
namespace {

using playback::Keyframe;
using playback::KeyframeBegun;
using playback::PlaybackState;
using playback::SeekablePlayback;
using playback::SourcePlayback;
using playback::test::ScriptedSource;

/// AU 26 opens the jaw by 4, AU 27 by 2; nothing else moves.
face::Face jaw_face() {
  face::Face face;
  face.channels = {{"jaw", Side::Both, 4}};
  face.recordings[26] = {26, {4}, ""};
  face.recordings[27] = {27, {2}, ""};
  return face;
}

AuFrame aus(int number) {
  const AuTerm term{static_cast<std::uint8_t>(number)};
  return frame_from_terms({&term, 1});
}

Keyframe keyframe(int number, int ms) {
  return {aus(number), Milliseconds(ms)};
}

class PlayerTest : public ::testing::Test {
 protected:
  ScriptedSource& play_source(std::vector<Keyframe> keyframes,
                              const SourcePlayback::Options& options = {}) {
    auto source = std::make_unique<ScriptedSource>();
    ScriptedSource& scripted = *source;
    scripted.keyframes = {keyframes.begin(), keyframes.end()};
    playback_ = std::make_unique<SourcePlayback>(std::move(source), options);
    player_.open(playback_.get());
    return scripted;
  }
  SeekablePlayback& play_whole(std::vector<Keyframe> keyframes) {
    auto whole = std::make_unique<SeekablePlayback>(std::move(keyframes), Milliseconds(250));
    SeekablePlayback& seekable = *whole;
    playback_ = std::move(whole);
    player_.open(playback_.get());
    return seekable;
  }
  /// `whole`: as a file that is all there, otherwise as what a source brings.
  void play(bool whole, std::vector<Keyframe> keyframes) {
    if (whole) {
      play_whole(std::move(keyframes));
    } else {
      play_source(std::move(keyframes));
    }
  }
  /// The jaw after so much more time.
  float jaw_after(int ms) {
    clock_.advance(Milliseconds(ms));
    player_.advance(clock_.now());
    return player_.face().activations[0];
  }

  face::Face face_ = jaw_face();
  AuMapping mapping_{face_, face_.recordings, {}, face::Mixer::Maximum};
  Player player_{mapping_, playback::Interpolation::Linear};
  std::unique_ptr<playback::Playback> playback_;
  test::ManualClock clock_;
};

TEST_F(PlayerTest, WithNothingOpenTheFaceIsNeutral) {
  EXPECT_EQ(jaw_after(100), 0);
  player_.remake();
  EXPECT_EQ(jaw_after(100), 0);
}

TEST_F(PlayerTest, BothKindsShowTheSameFace) {
  const std::vector<Keyframe> keyframes = {keyframe(26, 100), keyframe(27, 200), keyframe(0, 100)};
  const auto faces = [&] {
    std::vector<float> shown;
    for (int i = 0; i <= 40; ++i) shown.push_back(jaw_after(i == 0 ? 0 : 10));
    return shown;
  };
  play_source(keyframes);
  const std::vector<float> of_a_source = faces();
  player_.set_face(std::vector<float>{0});
  play_whole(keyframes);
  const std::vector<float> of_a_whole = faces();
  ASSERT_EQ(of_a_source.size(), of_a_whole.size());
  for (std::size_t i = 0; i < of_a_source.size(); ++i) {
    EXPECT_NEAR(of_a_source[i], of_a_whole[i], 1e-5F) << i;
  }
  EXPECT_EQ(of_a_source[10], 4);
}

TEST_F(PlayerTest, SaysEachKeyframeThatBeginsAlsoWhenSeveralAreOver) {
  play_source({keyframe(26, 10), keyframe(27, 0), keyframe(0, 10)});
  std::vector<int> begun;
  const auto note = [&](const KeyframeBegun& one) {
    EXPECT_EQ(player_.pipeline().received(), one.target.aus);
    begun.push_back(static_cast<int>(one.time.count()));
  };
  player_.advance(clock_.now(), note);
  clock_.advance(Milliseconds(15));
  player_.advance(clock_.now(), note);
  EXPECT_EQ(begun, (std::vector<int>{10, 0, 10}));
  EXPECT_FLOAT_EQ(player_.face().activations[0], 1) << "half the way from 2 to 0";
}

TEST_F(PlayerTest, AnotherStreamSetsOutFromTheFaceThatIsShown) {
  play_source({keyframe(26, 100)});
  jaw_after(0);
  EXPECT_FLOAT_EQ(jaw_after(50), 2);
  play_source({keyframe(0, 100)});
  EXPECT_FLOAT_EQ(player_.face().activations[0], 2);
  EXPECT_FLOAT_EQ(jaw_after(0), 2);
  EXPECT_FLOAT_EQ(jaw_after(50), 1);
}

TEST_F(PlayerTest, AFaceThatCameFromElsewhereIsLeftWithoutAJump) {
  player_.set_face(std::vector<float>{3});
  play_source({keyframe(0, 100)});
  EXPECT_FLOAT_EQ(jaw_after(0), 3);
  EXPECT_FLOAT_EQ(jaw_after(50), 1.5F);
}

TEST_F(PlayerTest, TheEasingToNeutralIsLeftWhereItIs) {
  ScriptedSource& source =
      play_source({keyframe(26, 100)}, {.speed = {}, .hold = Milliseconds(200)});
  jaw_after(0);
  EXPECT_EQ(jaw_after(100), 4);
  EXPECT_EQ(jaw_after(200), 4);
  EXPECT_FLOAT_EQ(jaw_after(500), 2);
  source.keyframes.push_back(keyframe(26, 100));
  EXPECT_FLOAT_EQ(jaw_after(0), 2);
  EXPECT_FLOAT_EQ(jaw_after(50), 3);
}

TEST_F(PlayerTest, APlaceHasTheSameFaceHoweverItIsReached) {
  SeekablePlayback& whole = play_whole({keyframe(26, 100), keyframe(27, 200), keyframe(0, 100)});
  jaw_after(0);
  const float played = jaw_after(150);
  whole.playhead(clock_.now()).seek(Milliseconds(350), clock_.now());
  EXPECT_NE(jaw_after(0), played);
  whole.playhead(clock_.now()).seek(Milliseconds(150), clock_.now());
  EXPECT_EQ(jaw_after(0), played);
}

TEST_F(PlayerTest, AStepStandsOnTheKeyframeThatTheAusSay) {
  SeekablePlayback& whole = play_whole({keyframe(26, 100), keyframe(27, 200)});
  jaw_after(0);
  whole.playhead(clock_.now()).step_keyframe(1, clock_.now());
  EXPECT_EQ(jaw_after(0), 4);
  EXPECT_EQ(player_.pipeline().received(), aus(26));
  EXPECT_EQ(player_.face().aus, aus(26));
}

TEST_F(PlayerTest, AnotherMappingIsSeenAtOnce) {
  for (const bool whole : {false, true}) {
    mapping_.recordings = face_.recordings;
    player_.set_face(std::vector<float>{0});
    play(whole, {keyframe(26, 100), keyframe(27, 100)});
    jaw_after(0);
    EXPECT_FLOAT_EQ(jaw_after(50), 2);
    mapping_.recordings[26].activation[0] = 1;
    player_.remake();
    EXPECT_FLOAT_EQ(player_.face().activations[0], 0.5F) << whole;
  }
}

TEST_F(PlayerTest, AnotherFaceStandsWhereTheOneBeforeDid) {
  for (const bool whole : {false, true}) {
    face_ = jaw_face();
    mapping_.recordings = face_.recordings;
    player_.change_face();
    player_.set_face(std::vector<float>{0});
    play(whole, {keyframe(26, 100), keyframe(27, 100)});
    jaw_after(0);
    jaw_after(100);
    jaw_after(50);
    face_.channels.insert(face_.channels.begin(), {"left_brow", Side::Left, 2});
    face_.recordings[26] = {26, {0, 2}, ""};
    face_.recordings[27] = {27, {1, 1}, ""};
    mapping_.recordings = face_.recordings;
    player_.change_face();
    EXPECT_EQ(player_.face().activations, (std::vector<float>{0.5F, 1.5F})) << whole;
  }
}

TEST_F(PlayerTest, AdvancingAllocatesNothing) {
  for (const bool whole : {false, true}) {
    std::vector<Keyframe> keyframes;
    for (int i = 0; i < 20; ++i) keyframes.push_back(keyframe(26 + i % 2, 20));
    play(whole, keyframes);
    jaw_after(0);
    const std::size_t before = test::allocations();
    for (int i = 0; i < 35; ++i) jaw_after(10);
    EXPECT_EQ(test::allocations(), before) << whole;
  }
}

}  // namespace
}  // namespace aucast::pipeline

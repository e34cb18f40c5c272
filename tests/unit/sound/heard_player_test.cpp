#include "client/sound/heard_player.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "client/playback/source_playback.h"
#include "tests/unit/playback/scripted_source.h"
#include "tests/unit/sound/cranked_out.h"

namespace aucast::sound {
namespace {

using playback::Keyframe;
using playback::SourcePlayback;

constexpr Milliseconds kFrameTime{10};

/// AU 26 opens the jaw by 1; nothing else moves.
face::Face jaw_face() {
  face::Face face;
  face.channels = {{"jaw", Side::Both, 1}};
  face.recordings[26] = {26, {1}, ""};
  return face;
}

class ShortTrack final : public SoundTrack {
 public:
  void read(std::int64_t /*begin*/, std::span<float> samples) override {
    std::fill(samples.begin(), samples.end(), 0.1F);
  }
  [[nodiscard]] std::int64_t end() const override { return std::int64_t{1'100} * kSamplesPerMs; }
};

/// A stream in which the jaw opens in a second, a device that the test cranks, and the player.
class HeardPlayerTest : public ::testing::Test {
 protected:
  HeardPlayerTest() {
    auto source = std::make_unique<playback::test::ScriptedSource>();
    source_ = source.get();
    Keyframe open_jaw;
    set_intensity(open_jaw.aus, 26, Side::Both, 1);
    open_jaw.time = open_jaw.place = open_jaw.span = Milliseconds(1'000);
    source->keyframes.push_back(open_jaw);
    playback_ = std::make_unique<SourcePlayback>(std::move(source), SourcePlayback::Options{});
  }

  void open(SoundTrack* track) {
    player_.open(playback_.get(), std::array{0.0F});
    player_.sound().open(playback_.get(), track);
  }
  void tick(int times) {
    for (int i = 0; i < times; ++i) {
      steady_ += kFrameTime;
      crank_.turn(kFrameTime);
      const Instant at = player_.advance(
          steady_,
          [this](const playback::KeyframeBegun&, Instant begun) { begun_.push_back(begun); });
      EXPECT_EQ(at, player_.now(steady_));
    }
  }
  [[nodiscard]] double heard_jaw() { return static_cast<double>(player_.activations().front()); }
  [[nodiscard]] double ahead_jaw() {
    return static_cast<double>(player_.face().face().activations.front());
  }
  [[nodiscard]] double lead_s() const { return seconds(player_.sound().lead()); }

  const face::Face face_ = jaw_face();
  const pipeline::AuMapping mapping_{face_, face_.recordings, {}};
  test::Crank crank_;
  ShortTrack track_;
  playback::test::ScriptedSource* source_ = nullptr;
  std::unique_ptr<SourcePlayback> playback_;
  HeardPlayer player_{mapping_, playback::Interpolation::Linear};
  std::vector<Instant> begun_;
  Instant steady_{std::chrono::hours(1)};
};

TEST_F(HeardPlayerTest, WithoutSoundTheFaceIsTheOneOfTheMoment) {
  open(nullptr);
  tick(50);
  EXPECT_EQ(begun_, std::vector<Instant>{Instant(std::chrono::hours(1)) + kFrameTime});
  EXPECT_NEAR(heard_jaw(), 0.49, 1e-6);
  EXPECT_EQ(heard_jaw(), ahead_jaw());
  EXPECT_EQ(player_.heard_place(), playback_->passing()->place);
}

TEST_F(HeardPlayerTest, WithSoundTheFaceIsTheOneThatIsHeard) {
  player_.sound().set_out(std::make_unique<test::CrankedOut>(crank_));
  open(&track_);
  tick(50);
  ASSERT_TRUE(player_.sound().sounds());
  ASSERT_GE(lead_s(), 0.09);
  EXPECT_NEAR(heard_jaw(), ahead_jaw() - lead_s(), 1e-3);
  EXPECT_NEAR(seconds(*player_.heard_place()), seconds(playback_->passing()->place) - lead_s(),
              1e-6);
}

TEST_F(HeardPlayerTest, IsOverWhenItsSoundIs) {
  EXPECT_FALSE(player_.over()) << "nothing is open";
  player_.sound().set_out(std::make_unique<test::CrankedOut>(crank_));
  open(&track_);
  tick(20);
  source_->now.end = playback::EndReason::EndOfStream;
  while (!playback_->over()) tick(1);
  EXPECT_FALSE(player_.over());
  EXPECT_LT(heard_jaw(), 0.99);
  tick(60);
  EXPECT_TRUE(player_.over());
  EXPECT_NEAR(heard_jaw(), 1, 1e-6);
}

TEST_F(HeardPlayerTest, GoesOnFromTheFaceThatItIsGiven) {
  open(nullptr);
  tick(50);
  player_.open(nullptr, std::array{0.25F});
  tick(10);
  EXPECT_EQ(heard_jaw(), 0.25);
  EXPECT_EQ(player_.heard_place(), std::nullopt);
  EXPECT_FALSE(player_.over());
}

}  // namespace
}  // namespace aucast::sound

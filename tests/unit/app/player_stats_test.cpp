#include "client/app/player_stats.h"
#include "client/playback/source_playback.h"

#include <optional>
#include <utility>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace aucast::app {
namespace {

TEST(PlayerStats, HasEveryDocumentedField) {
  PlayerStats stats;
  stats.keyframes_played = 6;
  stats.playback_seconds = 1.5;
  const auto json = nlohmann::json::parse(to_json(stats));
  for (const char* field :
       {"packets_received", "bytes_received", "receive_seconds", "keyframes_played", "frames",
        "frames_drawn", "fps", "pauses_sent", "resumes_sent", "stalls", "playback_seconds",
        "media_seconds", "first_frame_ms", "end_reason"}) {
    EXPECT_TRUE(json.contains(field)) << field;
  }
  EXPECT_EQ(json["frames"], 300);
  EXPECT_DOUBLE_EQ(json["fps"].get<double>(), 200.0);
  EXPECT_EQ(json["end_reason"], "failed");
}

TEST(PlayerStats, TakesOverWhatASourceCounted) {
  playback::SourceStatus status;
  status.end = playback::EndReason::Unreachable;
  status.detail = "cannot reach \xff host";
  status.keyframes_received = 3;
  status.bytes_received = 57;
  status.pauses_sent = 2;
  status.resumes_sent = 1;
  status.live = true;
  status.keyframes_dropped = 4;
  status.voice_left_out = 6;
  status.captions_left_out = 7;
  status.reconnects = 5;
  PlayerStats stats;
  stats.take(status);
  stats.sound.voice = {.too_late = 8, .left_out = 100, .out_of_order = 9, .unreadable = 10};
  const auto json = nlohmann::json::parse(to_json(stats));
  EXPECT_EQ(json["packets_received"], 3);
  EXPECT_EQ(json["bytes_received"], 57);
  EXPECT_EQ(json["pauses_sent"], 2);
  EXPECT_EQ(json["resumes_sent"], 1);
  EXPECT_EQ(json["live"], true);
  EXPECT_EQ(json["keyframes_dropped"], 4);
  EXPECT_EQ(json["voice_left_out"], 106) << "by the source and by the sound";
  EXPECT_EQ(json["voice_late"], 8);
  EXPECT_EQ(json["voice_out_of_order"], 9);
  EXPECT_EQ(json["voice_unreadable"], 10);
  EXPECT_EQ(json["captions_left_out"], 7);
  EXPECT_EQ(json["reconnects"], 5);
  EXPECT_EQ(json["live_delay_p50_ms"], nullptr) << "nothing was played";
  EXPECT_EQ(json["end_reason"], "unreachable");
  EXPECT_EQ(json["fps"], 0.0);
}

TEST(PlayerStats, AFileHasNoProtocol) {
  playback::SourceStatus status;
  PlayerStats stats;
  const auto level = [&] { return nlohmann::json::parse(to_json(stats))["protocol_level"]; };
  stats.take(status);
  EXPECT_EQ(level(), 1) << "a server that could not be reached";
  status.local = true;
  stats.take(status);
  EXPECT_EQ(level(), nullptr) << "though nothing was played";
  status.local = false;
  status.keyframes_received = 1;
  stats.take(status);
  EXPECT_EQ(level(), 1) << "though no bytes are counted";
  status.negotiated = true;
  stats.take(status);
  EXPECT_EQ(level(), 2);
}

/// Gives one live keyframe.
class OneKeyframe final : public playback::KeyframeSource {
 public:
  explicit OneKeyframe(playback::Keyframe keyframe) : keyframe_(std::move(keyframe)) {}
  [[nodiscard]] std::optional<playback::Keyframe> take() override {
    return std::exchange(keyframe_, std::nullopt);
  }
  [[nodiscard]] bool ready() const override { return keyframe_.has_value(); }
  bool wait_until(Instant /*until*/) override { return ready(); }
  [[nodiscard]] playback::SourceStatus status() const override { return {}; }
  void stop() override {}

 private:
  std::optional<playback::Keyframe> keyframe_;
};

TEST(PlayerStats, HasTheDelayOfALiveStream) {
  const auto json_of = [](std::optional<Duration> due) {
    playback::Keyframe keyframe{{}, Milliseconds(40)};
    keyframe.arrived = Instant{};
    if (due) keyframe.due = Instant{} + *due;
    playback::SourcePlayback playback(std::make_unique<OneKeyframe>(keyframe), {});
    EXPECT_TRUE(playback.advance(Instant{} + std::chrono::microseconds(2'500)));
    EXPECT_FALSE(playback.advance(Instant{} + std::chrono::milliseconds(45)));
    PlayerStats stats;
    stats.take(playback);
    playback::SourceStatus status;
    status.live = true;
    status.delay = Milliseconds(300);
    stats.take(status);
    EXPECT_EQ(stats.keyframes_played, 1U);
    return nlohmann::json::parse(to_json(stats));
  };
  const auto low = json_of(std::chrono::milliseconds(42));
  EXPECT_EQ(low["live_delay_p50_ms"], 45);
  EXPECT_EQ(low["live_delay_max_ms"], 45);
  EXPECT_EQ(low["live_delay_target_ms"], 42);
  EXPECT_EQ(json_of(std::nullopt)["live_delay_target_ms"], 300) << "without --live";
}

}  // namespace
}  // namespace aucast::app

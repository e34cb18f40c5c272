#include "client/app/player_stats.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace aucast::app {
namespace {

TEST(PlayerStats, HasEveryFieldOfTheContract) {
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
  status.packets_received = 3;
  status.bytes_received = 57;
  status.pauses_sent = 2;
  status.resumes_sent = 1;
  status.live = true;
  status.keyframes_dropped = 4;
  status.reconnects = 5;
  PlayerStats stats;
  stats.take(status);
  const auto json = nlohmann::json::parse(to_json(stats));
  EXPECT_EQ(json["packets_received"], 3);
  EXPECT_EQ(json["bytes_received"], 57);
  EXPECT_EQ(json["pauses_sent"], 2);
  EXPECT_EQ(json["resumes_sent"], 1);
  EXPECT_EQ(json["live"], true);
  EXPECT_EQ(json["keyframes_dropped"], 4);
  EXPECT_EQ(json["reconnects"], 5);
  EXPECT_EQ(json["end_reason"], "unreachable");
  EXPECT_EQ(json["fps"], 0.0);
}

}  // namespace
}  // namespace aucast::app

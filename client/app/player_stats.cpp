#include "client/app/player_stats.h"

#include <nlohmann/json.hpp>

#include "client/playback/playback_controller.h"

namespace aucast::app {

void PlayerStats::take(const playback::SourceStatus& status) {
  packets_received = status.packets_received;
  bytes_received = status.bytes_received;
  receive_seconds = status.receive_seconds;
  pauses_sent = status.pauses_sent;
  resumes_sent = status.resumes_sent;
  negotiated = status.negotiated;
  live = status.live;
  keyframes_dropped = status.keyframes_dropped;
  reconnects = status.reconnects;
  if (status.end != playback::EndReason::NotEnded) end_reason = name(status.end);
  detail = status.detail;
}

std::string to_json(const PlayerStats& stats) {
  const std::uint64_t frames = stats.keyframes_played * playback::kPositionsPerKeyframe;
  const double fps_count =
      static_cast<double>(stats.frames_drawn > 0 ? stats.frames_drawn : frames);
  const double fps_time = stats.frames_drawn > 0 ? stats.draw_seconds : stats.playback_seconds;
  nlohmann::ordered_json json;
  json["packets_received"] = stats.packets_received;
  json["bytes_received"] = stats.bytes_received;
  json["receive_seconds"] = stats.receive_seconds;
  json["keyframes_played"] = stats.keyframes_played;
  json["frames"] = frames;
  json["frames_drawn"] = stats.frames_drawn;
  json["fps"] = fps_time > 0 ? fps_count / fps_time : 0.0;
  json["pauses_sent"] = stats.pauses_sent;
  json["resumes_sent"] = stats.resumes_sent;
  json["stalls"] = stats.stalls;
  json["playback_seconds"] = stats.playback_seconds;
  json["media_seconds"] = stats.media_seconds;
  json["first_frame_ms"] = stats.first_frame_ms;
  json["protocol_level"] = stats.negotiated ? 2 : 1;
  json["live"] = stats.live;
  json["keyframes_dropped"] = stats.keyframes_dropped;
  json["reconnects"] = stats.reconnects;
  json["end_reason"] = stats.end_reason;
  json["detail"] = stats.detail;
  return json.dump(2, ' ', true, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace aucast::app

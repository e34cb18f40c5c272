#include "client/app/player_stats.h"
#include "client/playback/movement.h"

#include <cmath>

#include <nlohmann/json.hpp>

namespace aucast::app {
namespace {

/// In milliseconds, rounded to the microsecond.
double milliseconds(Duration time) {
  return std::round(seconds(time) * 1e6) / 1000;
}

void add_sound(const sound::SoundCounts& sound, nlohmann::ordered_json& json) {
  json["voice_packets"] = sound.voice.packets;
  json["voice_bytes"] = sound.voice.bytes;
  json["voice_gaps"] = sound.voice.gaps;
  json["voice_late"] = sound.voice.too_late;
  json["voice_out_of_order"] = sound.voice.out_of_order;
  json["voice_unreadable"] = sound.voice.unreadable;
  json["sound_underruns"] = sound.underruns;
  json["sound_drift_ppm"] =
      sound.drift_ppm ? nlohmann::ordered_json(std::round(*sound.drift_ppm * 10) / 10) : nullptr;
  const auto shift = [&sound](Duration time) {
    return sound.shift.count > 0 ? nlohmann::ordered_json(milliseconds(time)) : nullptr;
  };
  json["face_to_sound_p50_ms"] = shift(sound.shift.median);
  json["face_to_sound_p5_ms"] = shift(sound.shift.low);
  json["face_to_sound_p95_ms"] = shift(sound.shift.high);
}

}  // namespace

void PlayerStats::take(const playback::Playback& playback) {
  keyframes_played = playback.keyframes_played();
  stalls = playback.stalls();
  media_seconds = seconds(playback.media_time());
  delay_measured = playback.delays().all();
  const playback::DelaySummary meant = playback.delays_meant().all();
  if (meant.keyframes > 0) delay_aimed_at = meant.median;
}

void PlayerStats::take(const playback::SourceStatus& status) {
  keyframes_received = status.keyframes_received;
  bytes_received = status.bytes_received;
  receive_seconds = status.receive_seconds;
  pauses_sent = status.pauses_sent;
  resumes_sent = status.resumes_sent;
  local = status.local;
  negotiated = status.negotiated;
  live = status.live;
  if (live && !delay_aimed_at) delay_aimed_at = status.delay;
  keyframes_dropped = status.keyframes_dropped;
  voice_left_out = status.voice_left_out;
  captions_left_out = status.captions_left_out;
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
  json["packets_received"] = stats.keyframes_received;
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
  json["protocol_level"] =
      stats.local ? nlohmann::ordered_json() : nlohmann::ordered_json(stats.negotiated ? 2 : 1);
  json["live"] = stats.live;
  const bool measured = stats.delay_measured.keyframes > 0;
  const auto delay = [measured](Duration time) {
    return measured ? nlohmann::ordered_json(milliseconds(time)) : nlohmann::ordered_json();
  };
  json["live_delay_p50_ms"] = delay(stats.delay_measured.median);
  json["live_delay_max_ms"] = delay(stats.delay_measured.longest);
  json["live_delay_target_ms"] = delay(stats.delay_aimed_at.value_or(Duration::zero()));
  json["keyframes_dropped"] = stats.keyframes_dropped;
  json["voice_left_out"] = stats.voice_left_out + stats.sound.voice.left_out;
  json["captions_left_out"] = stats.captions_left_out;
  json["reconnects"] = stats.reconnects;
  add_sound(stats.sound, json);
  json["end_reason"] = stats.end_reason;
  json["detail"] = stats.detail;
  return json.dump(2, ' ', true, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace aucast::app

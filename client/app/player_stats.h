#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "client/playback/keyframe_source.h"
#include "client/playback/playback.h"
#include "client/sound/sound_player.h"
#include "common/result.h"

namespace aucast::app {

/// What --stats writes: one JSON object when playing ends, also if it fails; not after wrong
/// options, certificates or tokens.
struct PlayerStats {
  std::uint64_t keyframes_received = 0;
  std::uint64_t bytes_received = 0;  ///< of the keyframes' packets
  double receive_seconds = 0;        ///< from the connection to {-2} or the end
  std::uint64_t keyframes_played = 0;
  std::uint64_t frames_drawn = 0;
  double draw_seconds = 0;  ///< time spent deforming, drawing and writing pictures
  std::uint64_t pauses_sent = 0;
  std::uint64_t resumes_sent = 0;
  std::uint64_t stalls = 0;
  double playback_seconds = 0;  ///< measured on the steady clock
  double media_seconds = 0;
  double first_frame_ms = 0;  ///< time from the start of the program
  bool local = false;         ///< no server's stream: a file
  bool negotiated = false;    ///< level 2
  bool live = false;
  /// Live: the time from the arrival of a keyframe until the face had reached it.
  playback::DelaySummary delay_measured;
  std::optional<Duration> delay_aimed_at;  ///< with --live, the median of the times from a
                                           ///< keyframe's arrival until it is due; else the delay
                                           ///< that the source aims at; nullopt: not live
  std::uint64_t keyframes_dropped = 0;     ///< live: skipped to catch up
  std::uint64_t voice_left_out = 0;        ///< packets for which the source had no room
  std::uint64_t captions_left_out = 0;     ///< likewise
  std::uint64_t reconnects = 0;            ///< attempts after a loss
  sound::SoundCounts sound;
  std::string end_reason = "failed";  ///< a name of EndReason, or "failed" if the player itself
                                      ///< failed
  std::string detail;

  /// Takes the counts of a source.
  void take(const playback::SourceStatus& status);
  /// Takes the counts of `playback`, but not those of its source.
  void take(const playback::Playback& playback);
};

[[nodiscard]] std::string to_json(const PlayerStats& stats);

}  // namespace aucast::app

#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <thread>
#include <utility>
#include <vector>

#include <asio/io_context.hpp>

#include "common/link/loop_gate.h"
#include "common/shared.h"
#include "common/voice/voice_encoder.h"
#include "protocol/encoded_track.h"
#include "server/voice/voice_file.h"

namespace aucast::server {

/// Encodes the voices of the streams that are served: each sound file once, in the background. The
/// files take turns, some seconds at a time, so that every voice begins soon and no client waits.
/// Thread: that of the io_context, which must outlive it; the thread that encodes is its own.
class VoiceTracks {
 public:
  /// `on_grown` is called when a track has grown.
  VoiceTracks(asio::io_context& io, const voice::VoiceSettings& settings,
              std::function<void()> on_grown);
  /// Waits until the piece that is being read has been read.
  ~VoiceTracks() { gate_->close(); }
  VoiceTracks(const VoiceTracks&) = delete;
  VoiceTracks& operator=(const VoiceTracks&) = delete;

  /// The voice of a file, which grows from now on. As long as it is in use, an equal file gets the
  /// same voice.
  [[nodiscard]] std::shared_ptr<const protocol::EncodedTrack> track_of(const VoiceFile& file);
  /// Encodes no more, except for the piece of two seconds that is being read.
  void stop();

 private:
  struct Job {
    VoiceFile file;
    std::weak_ptr<protocol::EncodedTrack> track;
    std::optional<VoiceReader> reader;  ///< nullopt: its first turn has not come
  };

  void encode_until_stopped(const std::stop_token& stop);
  /// Returns false when the job is done.
  [[nodiscard]] bool encode_some(Job& job);
  void deliver(const Job& job, std::vector<protocol::VoicePacket> packets, bool last);

  voice::VoiceSettings settings_;
  std::function<void()> on_grown_;
  std::vector<std::pair<VoiceFile, std::weak_ptr<protocol::EncodedTrack>>> tracks_;
  bool stopped_ = false;
  Shared<std::deque<Job>> jobs_;
  std::shared_ptr<link::LoopGate> gate_;
  std::jthread thread_;  ///< last: it ends before anything it uses is gone
};

}  // namespace aucast::server

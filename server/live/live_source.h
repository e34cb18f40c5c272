#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

#include <asio/io_context.hpp>

#include "common/camera/camera_feed.h"
#include "common/camera/film_reader.h"
#include "common/camera/picture_source.h"
#include "common/link/loop_timer.h"
#include "common/result.h"
#include "common/stopped.h"
#include "common/time.h"
#include "server/live/live_input.h"
#include "server/live/live_streams.h"

namespace aucast::server {

struct LiveSourceOptions {
  LiveStreamsOptions streams;
  std::filesystem::path voice{};  ///< raw sound: "-" or a FIFO; empty: none
  camera::CameraOptions camera;   ///< if the source is a camera
  camera::FaceOptions faces;      ///< of a camera
  camera::OnSight on_sight{};     ///< likewise
  GivenUp given_up{};             ///< likewise
};

/// A source that is still being written, on the event loop. Feeds its LiveStreams with the time,
/// the bytes of a LiveInput and, if there is a voice, those of a second LiveInput.
/// Thread: that of the io_context, which must outlive it.
class LiveSource {
 public:
  using Clock = std::function<Instant()>;

  LiveSource(asio::io_context& io, const LiveSourceOptions& options, LiveStreams::Events events,
             Clock clock = std::chrono::steady_clock::now);
  LiveSource(const LiveSource&) = delete;
  LiveSource& operator=(const LiveSource&) = delete;

  /// Opens the inputs and the record. Errors are those of LiveInput and LiveStreams.
  [[nodiscard]] Result<void> start();
  void stop();

  /// Waits until the records are written. If the source had an error that did not end it, fails
  /// with that error.
  [[nodiscard]] Result<void> finish();

  [[nodiscard]] LiveStreams& streams() { return streams_; }
  [[nodiscard]] const LiveStreams& streams() const { return streams_; }

 private:
  [[nodiscard]] LiveInput::Opener opener(const LiveSourceOptions& options);
  void say_what_is_lost();
  void on_end();
  void go_on();

  Clock clock_;
  LiveStreams streams_;
  std::unique_ptr<camera::CameraFeed> camera_;
  LiveInput input_;
  std::optional<LiveInput> voice_;
  link::LoopTimer timer_;  ///< for what is due next
  bool stopped_ = false;
  bool loss_said_ = false;
};

}  // namespace aucast::server

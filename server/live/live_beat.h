#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <asio/io_context.hpp>

#include "common/link/loop_timer.h"
#include "common/time.h"
#include "server/live/served_replay.h"

namespace aucast::server {

/// The timer of recorded streams that are sent live: moves each on to its next moment for as long
/// as the stream is in use, tells the owner when any has moved, and logs moments that were left
/// out.
/// Thread: that of the io_context. The io_context and whatever the callback captures must outlive
/// this object.
class LiveBeat {
 public:
  using OnMoment = std::function<void()>;

  LiveBeat(asio::io_context& io, OnMoment on_moment, const ReplayLimits& limits = {})
      : timer_(io), on_moment_(std::move(on_moment)), limits_(limits) {}
  LiveBeat(const LiveBeat&) = delete;
  LiveBeat& operator=(const LiveBeat&) = delete;

  /// Plays the stream live, with its voice and captions, if it has any. If a stream with the same
  /// name, content, voice and captions is still running, returns that one, which goes on without a
  /// gap; else the stream begins now.
  [[nodiscard]] std::shared_ptr<const protocol::LiveChannel> play(
      const std::string& name, std::shared_ptr<const protocol::EncodedStream> stream, bool loop,
      std::shared_ptr<const protocol::SpokenTrack> spoken = nullptr);
  void stop();
  /// Does now what is due. For callers that take long, such as one that lets in many clients: the
  /// timer gets no turn until they have returned.
  void catch_up();

  /// How late the latest call of OnMoment was.
  [[nodiscard]] Duration lag() const { return lag_; }

 private:
  struct Playing {
    std::string name;
    std::weak_ptr<ServedReplay> replay;
  };

  void beat();
  void wait(Instant earliest);

  link::LoopTimer timer_;  ///< for the next beat
  OnMoment on_moment_;
  ReplayLimits limits_;
  std::vector<Playing> playing_;
  Duration lag_{0};
  bool stopped_ = false;
};

}  // namespace aucast::server

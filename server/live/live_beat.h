#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <asio/io_context.hpp>
#include <asio/steady_timer.hpp>

#include "common/time.h"
#include "server/live/served_replay.h"

namespace aucast::server {

/// Moves the recorded streams that are sent live on, each for as long as anybody holds it, tells
/// when any has moved and warns of moments left out.
/// Thread: that of the io_context, which must outlive it together with the callback's captures.
class LiveBeat {
 public:
  using OnMoment = std::function<void()>;

  LiveBeat(asio::io_context& io, OnMoment on_moment, const ReplayLimits& limits = {})
      : timer_(io), on_moment_(std::move(on_moment)), limits_(limits) {}
  LiveBeat(const LiveBeat&) = delete;
  LiveBeat& operator=(const LiveBeat&) = delete;

  /// The stream as a live one, with its sound, if it has any. If one of that name and content is
  /// running still, it is that one, without a gap; else one that begins now.
  [[nodiscard]] std::shared_ptr<const protocol::LiveChannel> play(
      const std::string& name, std::shared_ptr<const protocol::EncodedStream> stream, bool loop,
      std::shared_ptr<const protocol::Soundtrack> sound = nullptr);
  void stop();
  /// Tells now of what is due. For who is about to do something that takes time, such as letting
  /// in one of many newcomers: the timer is only looked at when all of that is done.
  void catch_up();

  /// How late the latest moment was told of.
  [[nodiscard]] Duration lag() const { return lag_; }

 private:
  struct Playing {
    std::string name;
    std::weak_ptr<ServedReplay> replay;
  };

  void beat();
  void wait(Instant earliest);

  asio::steady_timer timer_;
  OnMoment on_moment_;
  ReplayLimits limits_;
  std::vector<Playing> playing_;
  Duration lag_{0};
  bool stopped_ = false;
  /// What a handler that is queued already goes by when this object is gone.
  std::shared_ptr<LiveBeat*> self_ = std::make_shared<LiveBeat*>(this);
};

}  // namespace aucast::server

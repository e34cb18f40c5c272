#pragma once

#include <functional>
#include <vector>

#include <asio/io_context.hpp>
#include <asio/steady_timer.hpp>

#include "common/time.h"
#include "protocol/live_clock.h"
#include "protocol/server_session.h"

namespace aucast::server {

/// Keeps the clocks of the live streams going, tells of each moment and warns of those left out.
/// Thread: that of the io_context, which must outlive it together with the callback's captures.
class LiveBeat {
 public:
  using OnMoment = std::function<void()>;

  explicit LiveBeat(asio::io_context& io) : timer_(io) {}
  LiveBeat(const LiveBeat&) = delete;
  LiveBeat& operator=(const LiveBeat&) = delete;

  /// Begins all streams of `catalogue` that have no clock now and gives them theirs, which live as
  /// long as this object. A stream that is live in `before` as it is here goes on where it is
  /// there. Once.
  void start(protocol::ServerCatalogue& catalogue, const protocol::ServerCatalogue* before,
             OnMoment on_moment);
  void stop();
  /// Tells now of what is due. For who is about to do something that takes time, such as letting
  /// in one of many newcomers: the timer is only looked at when all of that is done.
  void catch_up();

  /// How late the latest moment was told of.
  [[nodiscard]] Duration lag() const { return lag_; }

 private:
  void beat();
  void wait(Instant earliest);

  asio::steady_timer timer_;
  std::vector<protocol::LiveClock> clocks_;
  OnMoment on_moment_;
  Duration lag_{0};
  bool stopped_ = false;
};

}  // namespace aucast::server

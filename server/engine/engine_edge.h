#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <asio/io_context.hpp>

#include "common/link/loop_timer.h"
#include "common/result.h"
#include "server/engine/bus.h"
#include "server/engine/follower.h"
#include "server/engine/joined_link.h"
#include "server/upstream/upstream.h"

namespace aucast::server {

/// A stream of an engine as a source: follows what its origin sends there. Each time the stream
/// begins or begins anew, its Reception gets a new connection (JoinedLink).
/// Thread: that of the io_context, which must outlive it.
class EngineEdge final : public Upstream {
 public:
  /// `options.name`: the stream's name at the engine. `open` opens the bus. `on_moment` is called
  /// when the stream has something new.
  EngineEdge(asio::io_context& io, const Reception::Options& options, OpenBus open,
             std::function<void()> on_moment);

  [[nodiscard]] Result<void> start() override;
  void stop() override;
  [[nodiscard]] const Reception& reception() const override { return reception_; }
  void describe(Status& status) const override;

 private:
  void on_message(const Bus::Message& message);
  void on_connected(const std::string& server);
  void on_disconnected();
  void on_over(const Parent::Outcome& outcome);
  void carry_out(const std::vector<Follower::Event>& events);
  void handle(const Follower::Ask& event);
  void handle(const Follower::Begin& event);
  void handle(const Follower::GoOn& event);
  void handle(const Follower::Lose& event);
  void handle(const Follower::Say& event);
  void wait();

  std::string name_;
  OpenBus open_;
  Reception reception_;
  Follower follower_;
  std::unique_ptr<Bus> bus_;
  std::shared_ptr<JoinedLink> link_;  ///< null: the stream has not begun
  bool over_ = false;      ///< the Reception has ended the connection during the running call
  std::string server_;     ///< the engine's server; empty: none is connected
  std::string reason_;     ///< why the stream ended, as logged last; empty: it has gone on since
  link::LoopTimer timer_;  ///< for the follower's deadline
  bool stopped_ = false;
};

}  // namespace aucast::server

#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <asio/io_context.hpp>
#include <asio/steady_timer.hpp>

#include "common/result.h"
#include "common/time.h"
#include "protocol/server_session.h"
#include "server/engine/bus.h"
#include "server/engine/follower.h"
#include "server/engine/joined_link.h"
#include "server/status/status.h"
#include "server/upstream/reception.h"

namespace aucast::server {

/// A stream of an engine as a source: follows what is published there, and each time that it begins
/// anew is a connection for its Reception. Sibling of Upstream.
/// Thread: that of the io_context, which must outlive it.
class EngineEdge {
 public:
  struct Options {
    std::string stream;
    std::string id;             ///< of this server, to find loops by
    Milliseconds wait{10'000};  ///< how long clients hold while nobody sends
    int classic_min = 20;
  };

  /// `on_moment`: the stream has something new.
  EngineEdge(asio::io_context& io, const Options& options, std::function<void()> on_moment);
  EngineEdge(const EngineEdge&) = delete;
  EngineEdge& operator=(const EngineEdge&) = delete;

  /// As the bus opens.
  [[nodiscard]] Result<void> start(const OpenBus& open);
  void stop();

  [[nodiscard]] protocol::ServedStream stream() const { return reception_.served(); }
  [[nodiscard]] UpstreamStatus status() const { return reception_.status(); }

 private:
  void on_message(const Bus::Message& message);
  void on_connected(const std::string& server);
  void on_disconnected();
  void on_over(const Parent::Ending& ending);
  void carry_out(const std::vector<Follower::Event>& events);
  void handle(const Follower::Ask& event);
  void handle(const Follower::Begin& event);
  void handle(const Follower::GoOn& event);
  void handle(const Follower::Lose& event);
  void handle(const Follower::Say& event);
  void wait();

  std::string name_;
  Reception reception_;
  Follower follower_;
  std::unique_ptr<Bus> bus_;
  std::shared_ptr<JoinedLink> link_;  ///< null: nothing has begun
  bool over_ = false;                 ///< the receiver has left it, in the running call
  std::string server_;                ///< of the engine; empty: none is connected
  std::string reason_;                ///< said last of why it was left
  asio::steady_timer timer_;
  bool stopped_ = false;
};

}  // namespace aucast::server

#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <asio/io_context.hpp>

#include "common/link/link.h"
#include "common/time.h"
#include "protocol/packet.h"
#include "protocol/server_session.h"
#include "server/status/status.h"
#include "server/upstream/reception.h"

namespace aucast::server {

/// The streams that publishers bring (--accept-push), one publisher per name. A live one, or one
/// that did not come whole, is forgotten when no publisher has sent it for a while; a recorded one
/// stays, until its publisher brings another or room is needed.
/// Thread: that of the io_context, which must outlive it.
class PushedStreams {
 public:
  struct Options {
    std::string id;     ///< of this server, to find loops by
    Milliseconds wait;  ///< how long clients hold while nobody sends
    int classic_min = 20;
  };
  struct Events {
    std::function<void()> on_moment;   ///< a stream has something new
    std::function<void()> on_changed;  ///< streams() has changed
  };

  PushedStreams(asio::io_context& io, Options options, Events events);
  ~PushedStreams();  // where a Slot is known
  PushedStreams(const PushedStreams&) = delete;
  PushedStreams& operator=(const PushedStreams&) = delete;

  /// Why the stream cannot be taken now, if so: another publisher sends it, or there are too many.
  [[nodiscard]] std::optional<protocol::ErrorReply> refusal(
      const protocol::HelloAsked& hello) const;
  /// Takes the stream that the open `link` brings, unless there is a refusal(). It replaces an
  /// earlier connection of the same publisher, which may be dead.
  void take(std::shared_ptr<link::Link> link, const protocol::HelloAsked& hello, std::string peer);
  /// Gives up the pushed stream of this name, which a stream of this server itself needs.
  void give_way(const std::string& name);
  void stop();

  /// The streams in the form in which they are served, in the order in which they came.
  [[nodiscard]] std::vector<protocol::ServedStream> streams() const;
  [[nodiscard]] std::vector<UpstreamStatus> statuses() const;

 private:
  struct Slot;

  [[nodiscard]] std::shared_ptr<Slot> find(const std::string& name) const;
  void add(const std::string& name);
  void on_over(Slot& slot, const Parent::Outcome& outcome);
  void forget_later(const std::string& name);
  void make_room();
  void retire(std::shared_ptr<Slot> slot);

  asio::io_context& io_;
  Options options_;
  Events events_;
  std::vector<std::shared_ptr<Slot>> slots_;
};

}  // namespace aucast::server

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

/// The streams that publishers send here (--accept-push), one publisher per name. A live stream, or
/// a recorded one that is incomplete, is forgotten when no publisher has sent it for Options::wait;
/// a complete recorded stream is kept until its publisher sends another or room is needed.
/// Thread: that of the io_context, which must outlive it.
class PushedStreams {
 public:
  struct Options {
    std::string id;     ///< of this server, by which it notices its own streams
    Milliseconds wait;  ///< how long clients wait while nobody sends
    int classic_min = 20;
  };
  struct Events {
    std::function<void()> on_moment;   ///< a stream has something new
    std::function<void()> on_changed;  ///< streams() has changed
  };

  PushedStreams(asio::io_context& io, Options options, Events events);
  ~PushedStreams();  // in the .cpp, where Slot is complete
  PushedStreams(const PushedStreams&) = delete;
  PushedStreams& operator=(const PushedStreams&) = delete;

  /// Why the stream cannot be taken now: another publisher sends it, or too many streams are here.
  /// nullopt: it can be taken.
  [[nodiscard]] std::optional<protocol::ErrorReply> refusal(
      const protocol::HelloAsked& hello) const;
  /// Receives the stream over the open `link`; there must be no refusal(). The link replaces an
  /// earlier connection of the same publisher, which may be dead.
  void take(std::shared_ptr<link::Link> link, const protocol::HelloAsked& hello, std::string peer);
  /// Gives up the pushed stream of this name, since this server has a stream of that name itself.
  void give_way(const std::string& name);
  void stop();

  /// The streams as they are served, in the order in which they came.
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

#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <asio/io_context.hpp>
#include <asio/steady_timer.hpp>

#include "common/link/dialler.h"
#include "common/time.h"
#include "common/tls/context.h"
#include "protocol/endpoint.h"
#include "protocol/server_session.h"
#include "server/status/status.h"
#include "server/upstream/parent.h"
#include "server/upstream/parent_turns.h"
#include "server/upstream/relayed_stream.h"

namespace aucast::server {

struct UpstreamOptions {
  protocol::StreamAddress address;
  std::optional<tls::Context> tls{};  ///< when the address wants it
  std::string token{};                ///< shown to the parents; empty: none
  std::string id;                     ///< of this server, to find loops by
  Milliseconds wait{10'000};          ///< how long clients hold while no parent sends
  int classic_min = 20;
};

/// A stream of another server as a source: dials the parents that its address names, one at a time,
/// and takes the next one when one is lost. One connection, however many clients.
/// Thread: that of the io_context, which must outlive it.
class Upstream {
 public:
  /// `on_moment`: the stream has something new.
  Upstream(asio::io_context& io, UpstreamOptions options, std::function<void()> on_moment);
  ~Upstream() { stop(); }
  Upstream(const Upstream&) = delete;
  Upstream& operator=(const Upstream&) = delete;

  void start();
  void stop();

  /// As what it is served, under the name that its address gives it, if any.
  [[nodiscard]] protocol::ServedStream stream() const;
  [[nodiscard]] UpstreamStatus status() const;

 private:
  void dial();
  void on_dialled(link::Dialled dialled);
  void begin(std::shared_ptr<link::Link> link);
  void on_moved_on();
  void on_over(const Parent::Ending& ending);
  void drop_parent();
  void try_next(const std::string& reason);
  void say_goes_on();
  void await_giving_up();
  void give_up();
  [[nodiscard]] std::string name() const;
  [[nodiscard]] std::string peer() const;

  UpstreamOptions options_;
  std::function<void()> on_moment_;
  RelayedStream stream_;
  ParentTurns turns_;
  link::Dialler dialler_;
  asio::steady_timer dial_timer_;
  asio::steady_timer wait_timer_;
  std::unique_ptr<Parent> parent_;  ///< nothing: none is connected
  bool receiving_ = false;          ///< the parent has sent a keyframe
  bool ever_received_ = false;
  bool stopped_ = false;
  Instant silent_since_{};            ///< while not receiving
  std::vector<std::string> reasons_;  ///< said last of each parent
  std::uint64_t connects_ = 0;
  std::uint64_t losses_ = 0;
  std::uint64_t packets_before_ = 0;  ///< of parents that were left
  std::uint64_t bytes_before_ = 0;
};

}  // namespace aucast::server

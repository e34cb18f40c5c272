#pragma once

#include <functional>
#include <string>

#include <asio/io_context.hpp>

#include "common/time.h"
#include "protocol/server_session.h"
#include "server/status/status.h"
#include "server/upstream/dialled_address.h"
#include "server/upstream/reception.h"
#include "server/upstream/redialler.h"

namespace aucast::server {

struct UpstreamOptions {
  DialledAddress from;
  std::string id;             ///< of this server, to find loops by
  Milliseconds wait{10'000};  ///< how long clients hold while no parent sends
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
  [[nodiscard]] protocol::ServedStream stream() const { return reception_.served(); }
  [[nodiscard]] UpstreamStatus status() const { return reception_.status(); }

 private:
  void on_over(const Parent::Ending& ending);

  UpstreamOptions options_;
  Reception reception_;
  Redialler redialler_;
};

}  // namespace aucast::server

#pragma once

#include <memory>
#include <utility>
#include <vector>

#include <asio/io_context.hpp>

#include "common/result.h"
#include "server/push/pusher.h"
#include "server/settings/other_servers.h"
#include "server/status/status.h"

namespace aucast::server {

/// Sends streams to other servers (--push), each over a connection of its own.
/// Thread: that of the io_context. The io_context and what the hooks refer to must outlive the
/// Pushers.
class Pushers {
 public:
  Pushers(asio::io_context& io, Pusher::Hooks hooks) : io_(io), hooks_(std::move(hooks)) {}

  /// Reads the addresses, and the secrets for them. `held_back_max` as Pusher's. Errors are those
  /// of dialled_address().
  [[nodiscard]] Result<void> open(const PushSettings& settings, int held_back_max);
  void start();
  /// Dials no more. Streams that are being sent go on.
  void stop();
  /// Adds the state of each to `status`.
  void describe(Status& status) const;

 private:
  asio::io_context& io_;
  Pusher::Hooks hooks_;
  std::vector<std::unique_ptr<Pusher>> all_;
};

}  // namespace aucast::server

#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <asio/io_context.hpp>

#include "common/link/link.h"
#include "common/result.h"
#include "protocol/served_stream.h"
#include "server/push/pusher.h"
#include "server/settings/push_settings.h"
#include "server/status/status.h"

namespace aucast::server {

/// Sends streams to other servers (--push), each over a connection of its own.
/// Thread: that of the io_context. The io_context and what the hooks refer to must outlive the
/// Pushers.
class Pushers {
 public:
  /// As Pusher::Hooks. `name`: the stream's name in the address; empty: the first stream.
  struct Hooks {
    std::function<const protocol::ServedStream*(const std::string& name)> stream;
    std::function<void(const std::string& name, std::string peer, std::shared_ptr<link::Link>,
                       std::string_view bytes, Pusher::OnServed)>
        serve;
  };

  Pushers(asio::io_context& io, Hooks hooks) : io_(io), hooks_(std::move(hooks)) {}

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
  Hooks hooks_;
  std::vector<std::unique_ptr<Pusher>> all_;
};

}  // namespace aucast::server

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

/// All that --push brings to other servers, each stream over a connection of its own.
/// Thread: that of the io_context, which must outlive it together with what the hooks refer to.
class Pushers {
 public:
  /// Those of each Pusher; `name`: of its stream, as its address has it; empty: the first.
  struct Hooks {
    std::function<const protocol::ServedStream*(const std::string& name)> stream;
    std::function<void(const std::string& name, std::string peer, std::shared_ptr<link::Link>,
                       std::string_view bytes, Pusher::OnServed)>
        serve;
  };

  Pushers(asio::io_context& io, Hooks hooks) : io_(io), hooks_(std::move(hooks)) {}

  /// Reads the addresses and what is shown there; Pusher has the rest. As dialled_address() fails.
  [[nodiscard]] Result<void> open(const PushSettings& settings, const std::string& id,
                                  int held_back_max);
  void start();
  /// Nothing is dialled any more. What is being served goes on.
  void stop();
  /// Adds how each goes.
  void describe(Status& status) const;

 private:
  asio::io_context& io_;
  Hooks hooks_;
  std::vector<std::unique_ptr<Pusher>> all_;
};

}  // namespace aucast::server

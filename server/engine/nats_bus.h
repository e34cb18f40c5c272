#pragma once

#include <chrono>
#include <memory>

#include <asio/io_context.hpp>

#include "common/result.h"
#include "server/engine/bus.h"
#include "server/engine/nats_library.h"
#include "server/engine/nats_options.h"

namespace aucast::server {

/// A connection to servers of NATS by their client library, which is loaded for it (nats_loader.h).
/// Connecting is tried for ever, at the servers in their order; the first attempt takes up to a
/// second for each that does not answer. Usage error where the module is not installed, and when
/// the library does not take the options; unreadable where the module cannot be used.
[[nodiscard]] Result<std::unique_ptr<Bus>> open_nats_bus(asio::io_context& io,
                                                         const NatsOptions& options,
                                                         Bus::Events events);

/// The same with a module that is loaded. After a refusal it is asked again, `refused_pause` later
/// and in a thread of its own, so that a server that does not answer keeps nobody waiting.
[[nodiscard]] Result<std::unique_ptr<Bus>> open_nats_bus(
    asio::io_context& io, const NatsModule& module, NatsServers servers, Bus::Events events,
    std::chrono::milliseconds refused_pause = std::chrono::seconds(4));

}  // namespace aucast::server

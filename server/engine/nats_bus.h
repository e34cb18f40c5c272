#pragma once

#include <chrono>
#include <memory>

#include <asio/io_context.hpp>

#include "common/result.h"
#include "server/engine/bus.h"
#include "server/engine/nats_library.h"
#include "server/engine/nats_options.h"

namespace aucast::server {

/// Loads the module aucast-nats.so (nats_loader.h), which contains NATS's client library, and opens
/// a connection to NATS servers. The servers are tried in their order, again and again; the first
/// attempt takes up to a second for each server that does not answer. Fails with a Usage error if
/// the module is not installed or the library refuses the options, and with Unreadable if the
/// module is unusable.
[[nodiscard]] Result<std::unique_ptr<Bus>> open_nats_bus(asio::io_context& io,
                                                         const NatsOptions& options,
                                                         Bus::Events events);

/// The same with a module that is already loaded. A server that refuses us is asked again after
/// `refused_pause`, on another thread, so that the event loop never waits for a server that does
/// not answer.
[[nodiscard]] Result<std::unique_ptr<Bus>> open_nats_bus(
    asio::io_context& io, const NatsModule& module, NatsServers servers, Bus::Events events,
    std::chrono::milliseconds refused_pause = std::chrono::seconds(4));

}  // namespace aucast::server

#pragma once

#include <chrono>
#include <memory>

#include <asio/io_context.hpp>

#include "common/result.h"
#include "server/engine/bus.h"
#include "server/engine/nats_library.h"
#include "server/engine/nats_options.h"

namespace aucast::server {

/// A connection to NATS servers by their client library, in the module aucast-nats.so, which is
/// loaded here (nats_loader.h). The servers are tried in their order, again and again; the first
/// attempt takes up to a second for each that does not answer. Usage error when the module is not
/// installed or the library refuses the options; Unreadable when the module cannot be used.
[[nodiscard]] Result<std::unique_ptr<Bus>> open_nats_bus(asio::io_context& io,
                                                         const NatsOptions& options,
                                                         Bus::Events events);

/// The same with a module that is already loaded. When a server refuses us, it is asked again after
/// `refused_pause`, in a thread of its own, so that nothing here waits for a server that does not
/// answer.
[[nodiscard]] Result<std::unique_ptr<Bus>> open_nats_bus(
    asio::io_context& io, const NatsModule& module, NatsServers servers, Bus::Events events,
    std::chrono::milliseconds refused_pause = std::chrono::seconds(4));

}  // namespace aucast::server

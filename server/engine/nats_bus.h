#pragma once

#include <memory>

#include <asio/io_context.hpp>

#include "common/result.h"
#include "server/engine/bus.h"
#include "server/engine/nats_options.h"

namespace aucast::server {

/// A connection to servers of NATS by their client library. It is tried on for ever, at the servers
/// in their order; the first attempt takes up to a second for each that does not answer. Usage
/// error where this program was built without the library, and when it does not take the options.
[[nodiscard]] Result<std::unique_ptr<Bus>> open_nats_bus(asio::io_context& io,
                                                         const NatsOptions& options,
                                                         Bus::Events events);

}  // namespace aucast::server

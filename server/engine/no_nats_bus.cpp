#include "server/engine/nats_bus.h"

namespace aucast::server {

// As nats_bus.cpp has it, which keeps the events.
// NOLINTBEGIN(performance-unnecessary-value-param)
Result<std::unique_ptr<Bus>> open_nats_bus(asio::io_context& /*io*/, const NatsOptions& /*options*/,
                                           Bus::Events /*events*/) {
  // NOLINTEND(performance-unnecessary-value-param)
  return Error{ErrorKind::Usage,
               "this au-transmitter was built without NATS: install libnats-dev and build it again "
               "with AUCAST_NATS, or use aucast:// for relays"};
}

}  // namespace aucast::server

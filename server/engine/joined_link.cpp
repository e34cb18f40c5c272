#include "server/engine/joined_link.h"

#include <chrono>
#include <utility>

#include "protocol/engine_message.h"

namespace aucast::server {

void JoinedLink::start(link::LinkUser& user) {
  user_ = &user;
  user_->on_open();
}

void JoinedLink::deliver(std::string_view packets) {
  const auto self = shared_from_this();
  while (user_ != nullptr && !packets.empty()) {
    const std::string_view packet = protocol::first_packet(packets);
    packets.remove_prefix(packet.size());
    user_->on_bytes(packet);
  }
}

void JoinedLink::lose(const std::string& reason) {
  const auto self = shared_from_this();
  if (user_ == nullptr) return;
  std::exchange(user_, nullptr)->on_closed({link::Ending::Why::Lost, reason});
}

Instant JoinedLink::now() const {
  return std::chrono::steady_clock::now();
}

}  // namespace aucast::server

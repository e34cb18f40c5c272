#include "server/push/pushers.h"

#include <utility>

#include "server/upstream/dialled_address.h"

namespace aucast::server {

Result<void> Pushers::open(const PushSettings& settings, int held_back_max) {
  for (const std::string& address : settings.addresses) {
    auto to = dialled_address(address, {settings.token, settings.tls, "--push-tls"});
    if (!to) return to.error();
    all_.push_back(std::make_unique<Pusher>(io_, *std::move(to), held_back_max, hooks_));
  }
  return {};
}

void Pushers::start() {
  for (const auto& pusher : all_) pusher->start();
}

void Pushers::stop() {
  for (const auto& pusher : all_) pusher->stop();
}

void Pushers::describe(Status& status) const {
  for (const auto& pusher : all_) status.pushes.push_back(pusher->status());
}

}  // namespace aucast::server

#include "client/web/socket_link.h"

#include <map>
#include <utility>

#include "client/web/browser.h"

namespace aucast::web {
namespace {

using Why = link::Ending::Why;

/// The links whose sockets the browser still has.
std::map<std::uint32_t, SocketLink*>& sockets() {
  static std::map<std::uint32_t, SocketLink*> all;
  return all;
}

std::shared_ptr<SocketLink> find(std::uint32_t socket) {
  const auto found = sockets().find(socket);
  return found == sockets().end() ? nullptr : found->second->shared_from_this();
}

std::uint32_t new_socket_id() {
  static std::uint32_t last = 0;
  return ++last;
}

}  // namespace

std::shared_ptr<SocketLink> SocketLink::create() {
  return std::shared_ptr<SocketLink>(new SocketLink);
}

SocketLink::SocketLink()
    : id_(new_socket_id()),
      timer_([this] {
        const auto self = shared_from_this();
        if (user_ != nullptr) user_->on_time();
      }),
      later_([this] { hand_out(); }) {}

SocketLink::~SocketLink() {
  close();
}

void SocketLink::start(link::LinkUser& user) {
  user_ = &user;
  sockets()[id_] = this;
  browser::open_socket(id_);
}

void SocketLink::write(std::string_view bytes) {
  if (!open_ || finishing_) return;
  wire_bytes_ += bytes.size();
  browser::send(id_, bytes);
}

void SocketLink::finish() {
  finishing_ = true;
  gone_ ? later_.set(now()) : browser::end_socket(id_);
}

void SocketLink::close() {
  user_ = nullptr;
  timer_.set(std::nullopt);
  later_.set(std::nullopt);
  if (sockets().erase(id_) != 0) browser::drop_socket(id_);
}

void SocketLink::set_reading(bool reading) {
  reading_ = reading;
  if (reading && (!held_.empty() || peer_ended_)) later_.set(now());
}

void SocketLink::opened(std::uint32_t socket) {
  const auto self = find(socket);
  if (!self) return;
  self->open_ = true;
  self->user_->on_open();
}

void SocketLink::received(std::uint32_t socket, std::string_view bytes) {
  const auto self = find(socket);
  if (!self || self->finishing_) return;
  self->held_ += bytes;
  if (self->held_.size() > kHeldMax) {
    self->end({Why::Lost, "the server sends more than it was asked for"});
  } else {
    self->hand_out();
  }
}

void SocketLink::closed(std::uint32_t socket) {
  const auto self = find(socket);
  if (!self) return;
  self->gone_ = true;
  if (self->finishing_) {
    self->end({Why::Finished, ""});
  } else if (!self->open_) {
    self->end({Why::NotMade, "it is not there, or does not let this page in"});
  } else {
    self->peer_ended_ = true;
    self->hand_out();
  }
}

/// Hands out everything as long as reading is on; after finish() nothing but the end.
void SocketLink::hand_out() {
  const auto self = shared_from_this();
  if (finishing_) {
    if (gone_) end({Why::Finished, ""});
    return;
  }
  if (reading_ && user_ != nullptr && !held_.empty()) {
    const std::string bytes = std::exchange(held_, {});
    user_->on_bytes(bytes);
  }
  if (reading_ && user_ != nullptr && !finishing_ && held_.empty() &&
      std::exchange(peer_ended_, false)) {
    user_->on_peer_end();
  }
}

void SocketLink::end(const link::Ending& ending) {
  link::LinkUser* const user = user_;
  close();
  if (user != nullptr) user->on_closed(ending);
}

}  // namespace aucast::web

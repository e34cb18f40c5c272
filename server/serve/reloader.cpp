#include "server/serve/reloader.h"

#include <utility>

#include <asio/post.hpp>

namespace aucast::server {

Reloader::Reloader(asio::io_context& io, Load load, OnDone on_done)
    : io_(io), load_(std::move(load)), on_done_(std::move(on_done)) {}

void Reloader::start() {
  if (running_) {
    again_ = true;
    return;
  }
  running_ = true;
  thread_ = std::jthread([this] {
    // A failure to load is a Result; what else can be thrown is the lack of memory.
    Result<protocol::ServerCatalogue> loaded = Error{ErrorKind::Failed, "not enough memory"};
    try {
      loaded = load_();
    } catch (const std::bad_alloc&) {
    }
    asio::post(io_, [this, result = std::move(loaded)]() mutable { done(std::move(result)); });
  });
}

void Reloader::done(Result<protocol::ServerCatalogue> loaded) {
  running_ = false;
  on_done_(std::move(loaded));
  if (std::exchange(again_, false)) start();
}

}  // namespace aucast::server

#pragma once

#include <functional>
#include <thread>

#include <asio/io_context.hpp>

#include "common/result.h"
#include "protocol/server_session.h"

namespace aucast::server {

/// Reads the sources again on a thread of its own, so that nobody who is being served waits for a
/// disk. Thread: that of the io_context, where `on_done` is called too; the load function runs on
/// the other one and must not touch what the first one uses.
class Reloader {
 public:
  using Load = std::function<Result<protocol::ServerCatalogue>()>;
  using OnDone = std::function<void(Result<protocol::ServerCatalogue>)>;

  /// `io` must outlive it. Waits in its destructor for a load that is under way: an owner that must
  /// not wait keeps it, and all that the load uses, until the process ends.
  Reloader(asio::io_context& io, Load load, OnDone on_done);
  Reloader(const Reloader&) = delete;
  Reloader& operator=(const Reloader&) = delete;

  /// Loads now; once more afterwards if it is doing so already.
  void start();
  /// A load is under way.
  [[nodiscard]] bool running() const { return running_; }

 private:
  void done(Result<protocol::ServerCatalogue> loaded);

  asio::io_context& io_;
  Load load_;
  OnDone on_done_;
  bool running_ = false;
  bool again_ = false;
  std::jthread thread_;
};

}  // namespace aucast::server

#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <asio/io_context.hpp>
#include <asio/ip/tcp.hpp>

#include "common/link/loop_gate.h"

namespace aucast::link {

using Addresses = std::vector<asio::ip::tcp::endpoint>;

/// The addresses of a host that needs no look-up: a numeric address, or localhost. Empty for any
/// other.
[[nodiscard]] Addresses known_addresses(const std::string& host, std::uint16_t port);

/// Finds the addresses of a host. The system's own look-up cannot be interrupted, so it runs in a
/// thread that nobody waits for, and a late result is dropped.
class NameLookup {
 public:
  /// `failure`: cause and remedy; empty when there are addresses.
  using OnFound = std::function<void(const std::string& failure, Addresses found)>;

  explicit NameLookup(asio::io_context& io) : io_(io) {}
  ~NameLookup() { cancel(); }
  NameLookup(const NameLookup&) = delete;
  NameLookup& operator=(const NameLookup&) = delete;

  /// Calls `on_found` once in the thread of the io_context, never from within start(), and not at
  /// all if it is cancelled before. One look-up at a time: a new one cancels the previous one.
  void start(const std::string& host, std::uint16_t port, OnFound on_found);
  void cancel();

 private:
  asio::io_context& io_;
  std::shared_ptr<LoopGate> gate_;  ///< of the latest look-up; null: there was none
  OnFound on_found_;
};

}  // namespace aucast::link

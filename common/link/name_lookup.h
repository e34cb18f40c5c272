#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <asio/io_context.hpp>
#include <asio/ip/tcp.hpp>

#include "common/link/loop_gate.h"

namespace aucast::link {

using Addresses = std::vector<asio::ip::tcp::endpoint>;

/// The addresses of a host that needs no look-up: a numeric address, or localhost. Empty for any
/// other host.
[[nodiscard]] Addresses known_addresses(const std::string& host, std::uint16_t port);

/// Finds the addresses of a host. The system's own look-up cannot be interrupted, so it runs in a
/// thread that nobody waits for. For each host only one look-up runs at a time, however
/// often it is cancelled and started again: a resolver that never answers costs one thread.
class NameLookup {
 public:
  /// `failure`: cause and remedy; empty when there are addresses.
  using OnFound = std::function<void(const std::string& failure, Addresses found)>;
  /// Blocks. Adds the addresses of a host to `found`; their ports do not matter. Returns the
  /// failure; empty when there is none.
  using Resolve = std::function<std::string(const std::string& host, Addresses& found)>;

  explicit NameLookup(asio::io_context& io);
  NameLookup(asio::io_context& io, Resolve resolve)
      : gate_(std::make_shared<LoopGate>(io)), resolve_(std::move(resolve)) {}
  ~NameLookup() { gate_->close(); }
  NameLookup(const NameLookup&) = delete;
  NameLookup& operator=(const NameLookup&) = delete;

  /// Calls `on_found` once in the thread of the io_context, never from within start(), and not at
  /// all if cancel() or another start() comes before. A look-up of the same host that still runs
  /// answers the new question.
  void start(const std::string& host, std::uint16_t port, OnFound on_found);
  void cancel() { on_found_ = nullptr; }

 private:
  void answer_later(const std::string& failure, Addresses found);
  void answer(const std::string& failure, Addresses found);

  const std::shared_ptr<LoopGate> gate_;
  const Resolve resolve_;
  std::set<std::string> running_;  ///< hosts that are being looked up
  std::uint64_t question_ = 0;     ///< the number of the latest question
  std::string host_;               ///< of the latest question, like port_
  std::uint16_t port_ = 0;
  OnFound on_found_;  ///< null: nothing is asked
};

}  // namespace aucast::link

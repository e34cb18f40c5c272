#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include <asio/io_context.hpp>
#include <asio/ip/address.hpp>
#include <asio/ip/tcp.hpp>
#include <asio/steady_timer.hpp>

#include "common/link_limits.h"
#include "common/result.h"
#include "common/waits.h"

namespace aucast::link {

/// Raises this process's limit of descriptors as far as the system allows: every client needs one.
void raise_descriptor_limit();

/// The address; an IPv4 address that is mapped into IPv6 becomes plain IPv4.
[[nodiscard]] asio::ip::address without_mapping(const asio::ip::address& address);

/// ADDR:PORT, with brackets around an IPv6 address; without :PORT if that is 0, for unknown.
[[nodiscard]] std::string endpoint_text(const asio::ip::tcp::endpoint& endpoint);

/// Whether listeners at these two addresses (as Listener::open() takes them) and one port would get
/// each other's connections. Names other than localhost are not looked up.
[[nodiscard]] bool overlap(const std::string& bind, const std::string& other);

/// How to listen. `address` and `port` name the options that error messages point to.
struct ListenOptions {
  const char* address = "--bind";
  const char* port = "--port";
  /// Several processes of one user that all set this may listen on the same port; the system
  /// spreads the clients over them.
  bool shared = false;
};

/// Accepts connections at one address and hands them out. When the system is out of descriptors or
/// memory it logs that once, waits and goes on: connected clients do not notice.
/// Thread: that of the io_context, which must outlive it together with the callback's captures. The
/// callback may stop it, but neither start nor destroy it.
class Listener {
 public:
  using OnSocket = std::function<void(asio::ip::tcp::socket, const asio::ip::tcp::endpoint& peer)>;

  Listener(asio::io_context& io, const AcceptLimits& limits);
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;

  /// Listens on `bind`, an address or a name (brackets allowed), and `port`, 0 for any free one.
  /// Fails with Network and a message that names the address, the port, the cause, and the option
  /// to change.
  [[nodiscard]] Result<void> open(const std::string& bind, std::uint16_t port,
                                  const ListenOptions& options = {});
  /// Takes over a socket that is already listening.
  [[nodiscard]] Result<void> open_passed(int descriptor);

  /// Where it listens, with the real port; only after open().
  [[nodiscard]] const asio::ip::tcp::endpoint& endpoint() const { return endpoint_; }

  void start(OnSocket on_socket);
  /// Hands out no more connections. open() may be called again.
  void stop();

  /// How many times accepting had to pause.
  [[nodiscard]] std::uint64_t failures() const { return failures_; }

 private:
  void accept();
  void accept_waiting(const Waits::Token& wait);
  void accept_later(const std::error_code& cause);

  AcceptLimits limits_;
  asio::ip::tcp::acceptor acceptor_;
  asio::steady_timer pause_;
  asio::ip::tcp::endpoint endpoint_;
  asio::ip::tcp::endpoint peer_;  ///< of the connection being accepted
  OnSocket on_socket_;
  std::uint64_t failures_ = 0;
  bool failing_ = false;  ///< the last accept failed and was reported
  Waits waits_;
};

}  // namespace aucast::link

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include <asio/io_context.hpp>
#include <asio/ip/tcp.hpp>
#include <asio/steady_timer.hpp>

#include "common/link/link.h"
#include "common/link/name_lookup.h"
#include "common/link_limits.h"
#include "common/time.h"
#include "common/tls/context.h"
#include "common/waits.h"

namespace aucast::link {

struct DialOptions {
  std::string host;
  std::uint16_t port = 0;
  /// How long looking up the name, connecting and the TLS handshake may take together.
  Milliseconds time_max{10'000};
  std::optional<tls::Context> tls{};  ///< nullopt: no TLS
  /// Whether a secret will be sent: then only TLS, or a connection to this computer, is allowed.
  bool secret = false;
  /// The remedy in the message about a connection that `secret` forbids.
  const char* secret_remedy = "--tls, or --insecure-token";
  Limits limits{};
  int held_back_max = 0;  ///< see tcp_link()
};

/// Why no connection could be made.
struct DialFailure {
  bool final = false;  ///< another attempt would fail in the same way
  std::string reason;  ///< cause and remedy
};

using Dialled = std::variant<std::shared_ptr<Link>, DialFailure>;

/// Makes connections, one at a time: looks the name up and tries its addresses in turn. Each
/// address may take an equal share of the time that is left. The new link is not started yet. With
/// TLS, once an address has answered, the rest of `time_max` is for the handshake, which checks
/// that the certificate is for `host`.
/// Thread: that of the io_context, which must outlive this object.
class Dialler {
 public:
  using OnDialled = std::function<void(Dialled)>;

  explicit Dialler(asio::io_context& io) : lookup_(io), socket_(io), timer_(io) {}
  ~Dialler() { cancel(); }
  Dialler(const Dialler&) = delete;
  Dialler& operator=(const Dialler&) = delete;

  /// Calls `on_dialled` once, never from within dial(), and not at all if cancel() or another
  /// dial() comes before.
  void dial(DialOptions options, OnDialled on_dialled);
  void cancel();

 private:
  void try_next_address();
  void on_connected();
  void fail(std::string cause, const char* remedy);
  void end(Dialled dialled);
  void drop_socket();

  NameLookup lookup_;
  asio::ip::tcp::socket socket_;
  asio::steady_timer timer_;  ///< for the name, then for each address
  DialOptions options_;
  OnDialled on_dialled_;
  Instant until_{};
  Addresses addresses_;
  std::size_t next_address_ = 0;
  std::string first_failure_;
  Waits attempts_;
};

}  // namespace aucast::link

#include "common/link/listener.h"

#include <sys/resource.h>
#include <sys/socket.h>

#include <cerrno>
#include <utility>

#include <asio/ip/v6_only.hpp>

#include "common/link/host.h"
#include "common/link/name_lookup.h"
#include "common/log.h"
#include "common/text.h"

namespace aucast::link {
namespace {

using asio::ip::tcp;

std::string without_brackets(const std::string& bind) {
  const bool bracketed = bind.size() > 2 && bind.front() == '[' && bind.back() == ']';
  return bracketed ? bind.substr(1, bind.size() - 2) : bind;
}

/// Whether the error means that the address is not one of this host: another address of the same
/// name may be.
bool is_elsewhere(const std::error_code& cause) {
  // Asio's category maps only some of errno to std::errc, so the numbers are compared.
  return cause.category() == asio::error::get_system_category() &&
         (cause.value() == EADDRNOTAVAIL || cause.value() == EAFNOSUPPORT);
}

std::string hint(const std::error_code& cause, const ListenOptions& options) {
  const std::string address(options.address);
  const std::string port(options.port);
  if (cause == asio::error::address_in_use) {
    if (options.shared) {
      return "; another program has this port for itself, or is another user's: all that share it "
             "need --reuse-port and one user";
    }
    return "; another program has this port: stop it, or choose one with " + port +
           " (0 takes any free one)";
  }
  if (cause == asio::error::access_denied) {
    return "; ports below 1024 are for root: choose another with " + port;
  }
  if (is_elsewhere(cause)) {
    return "; that is not an address of this host: choose one with " + address +
           " (127.0.0.1 for this host only, 0.0.0.0 for all addresses)";
  }
  return "; choose another address with " + address;
}

/// Whether `all` stands for every address of this host, `one` among them: :: is those of IPv4 too.
bool is_within(const asio::ip::address& one, const asio::ip::address& all) {
  return all.is_unspecified() && (all.is_v6() || one.is_v4());
}

Error cannot_listen(const std::string& bind, std::uint16_t port, const std::error_code& cause,
                    const ListenOptions& options) {
  return {ErrorKind::Network, "cannot listen on " + host_and_port(bind, port) + ": " +
                                  cause.message() + hint(cause, options)};
}

std::error_code share_port(tcp::acceptor& acceptor) {
  const int yes = 1;
  if (::setsockopt(acceptor.native_handle(), SOL_SOCKET, SO_REUSEPORT, &yes, sizeof(yes)) == 0)
    return {};
  return {errno, asio::error::get_system_category()};
}

std::error_code listen_at(tcp::acceptor& acceptor, const tcp::endpoint& endpoint, bool shared) {
  std::error_code error;
  const auto ok = [&error] { return !error; };
  acceptor.open(endpoint.protocol(), error);
  if (ok()) acceptor.set_option(tcp::acceptor::reuse_address(true), error);
  if (ok() && endpoint.address().is_v6() && endpoint.address().is_unspecified()) {
    // --bind :: means all addresses, whatever the system's default is.
    acceptor.set_option(asio::ip::v6_only(false), error);
  }
  if (ok() && shared) error = share_port(acceptor);
  if (ok()) acceptor.bind(endpoint, error);
  if (ok()) acceptor.listen(asio::socket_base::max_listen_connections, error);
  if (error) {
    std::error_code ignored;
    acceptor.close(ignored);
  }
  return error;
}

}  // namespace

bool overlap(const std::string& bind, const std::string& other) {
  const std::string host = without_brackets(bind);
  const std::string other_host = without_brackets(other);
  if (host == other_host) return true;
  const Addresses known = known_addresses(host, 0);
  const Addresses other_known = known_addresses(other_host, 0);
  if (known.empty() || other_known.empty()) return false;
  const auto one = known.front().address();
  const auto two = other_known.front().address();
  return one == two || is_within(one, two) || is_within(two, one);
}

void raise_descriptor_limit() {
  rlimit limit{};
  if (::getrlimit(RLIMIT_NOFILE, &limit) != 0 || limit.rlim_cur == limit.rlim_max) return;
  limit.rlim_cur = limit.rlim_max;
  ::setrlimit(RLIMIT_NOFILE, &limit);
}

asio::ip::address without_mapping(const asio::ip::address& address) {
  if (!address.is_v6() || !address.to_v6().is_v4_mapped()) return address;
  return asio::ip::make_address_v4(asio::ip::v4_mapped, address.to_v6());
}

std::string endpoint_text(const tcp::endpoint& endpoint) {
  const auto address = without_mapping(endpoint.address());
  const std::string port = endpoint.port() == 0 ? "" : ":" + std::to_string(endpoint.port());
  return (address.is_v4() ? address.to_string() : "[" + address.to_string() + "]") + port;
}

Listener::Listener(asio::io_context& io, const AcceptLimits& limits)
    : limits_(limits), acceptor_(io), pause_(io) {}

Result<void> Listener::open(const std::string& bind, std::uint16_t port,
                            const ListenOptions& options) {
  std::error_code error;
  const std::string host = without_brackets(bind);
  Addresses addresses = known_addresses(host, port);
  if (addresses.empty()) {
    tcp::resolver resolver(acceptor_.get_executor());
    const auto found = resolver.resolve(
        host, std::to_string(port), tcp::resolver::passive | tcp::resolver::numeric_service, error);
    if (error) return cannot_listen(bind, port, error, options);
    for (const auto& entry : found) addresses.push_back(entry.endpoint());
  }
  for (const tcp::endpoint& address : addresses) {
    error = listen_at(acceptor_, address, options.shared);
    if (!error) {
      endpoint_ = acceptor_.local_endpoint(error);
      break;
    }
    // A port that is taken at the first address is taken: trying the next would hide it.
    if (!is_elsewhere(error)) break;
  }
  if (error) return cannot_listen(bind, port, error, options);
  return {};
}

Result<void> Listener::open_passed(int descriptor) {
  sockaddr_storage address{};
  socklen_t length = sizeof(address);
  // The call wants the general type for every family.
  ::getsockname(descriptor, reinterpret_cast<sockaddr*>(&address), &length);
  std::error_code error;
  acceptor_.assign(address.ss_family == AF_INET6 ? tcp::v6() : tcp::v4(), descriptor, error);
  if (!error) endpoint_ = acceptor_.local_endpoint(error);
  if (!error) return {};
  return Error{ErrorKind::Network, "the socket that was passed cannot be used: " + error.message()};
}

void Listener::start(OnSocket on_socket) {
  on_socket_ = std::move(on_socket);
  std::error_code ignored;
  acceptor_.non_blocking(true, ignored);
  accept();
}

void Listener::stop() {
  waits_.cancel();
  std::error_code ignored;
  acceptor_.close(ignored);
  pause_.cancel();
}

void Listener::accept() {
  acceptor_.async_accept(
      peer_, [this, wait = waits_.begin()](const std::error_code& error, tcp::socket socket) {
        // It may have been opened again meanwhile.
        if (!wait.current()) return;
        if (error == asio::error::connection_aborted) {
          // The peer left between its knock and our opening the door.
          spdlog::debug("a connection was gone before it was accepted");
          accept();
          return;
        }
        if (error) {
          accept_later(error);
          return;
        }
        if (std::exchange(failing_, false)) spdlog::info("accepting connections again");
        on_socket_(std::move(socket), peer_);
        accept_waiting(wait);
        if (wait.current()) accept();
      });
}

/// Accepts those who are already waiting, unless it is stopped. accept() will meet any error.
void Listener::accept_waiting(const Waits::Token& wait) {
  for (int taken = 1; taken < limits_.in_a_row && wait.current(); ++taken) {
    std::error_code error;
    tcp::socket socket = acceptor_.accept(peer_, error);
    if (error) return;
    on_socket_(std::move(socket), peer_);
  }
}

void Listener::accept_later(const std::error_code& cause) {
  ++failures_;
  if (!std::exchange(failing_, true)) {
    const bool too_many = cause == std::errc::too_many_files_open ||
                          cause == std::errc::too_many_files_open_in_system;
    spdlog::warn("cannot accept connections for now: {}{}", cause.message(),
                 too_many ? " (more clients need a higher ulimit -n)" : "");
  }
  pause_.expires_after(limits_.pause);
  pause_.async_wait([this, wait = waits_.begin()](const std::error_code& error) {
    if (!error && wait.current()) accept();
  });
}

}  // namespace aucast::link

#include "common/link/name_lookup.h"

#include <netdb.h>
#include <sys/socket.h>

#include <cerrno>
#include <cstring>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

#include <asio/post.hpp>

#include "common/link/host.h"
#include "common/own_computer.h"
#include "common/text.h"

namespace aucast::link {

/// Shared with the thread, which may outlive everybody else.
struct NameLookup::Request : std::enable_shared_from_this<Request> {
  std::mutex mutex;
  asio::io_context* io = nullptr;  ///< guarded by mutex; nothing: cancelled
  OnFound on_found;                ///< of the io_context's thread

  /// In the thread of the io_context, unless it was cancelled.
  void answer(std::string failure, Addresses found) {
    const std::lock_guard lock(mutex);
    if (io == nullptr) return;
    asio::post(*io,
               [self = shared_from_this(), failure = std::move(failure), found = std::move(found)] {
                 {
                   const std::lock_guard again(self->mutex);
                   if (self->io == nullptr) return;
                 }
                 self->on_found(failure, found);
               });
  }
};

namespace {

constexpr const char* kIsTheNameRight = "; check the host's name";

/// Blocks. Returns the failure with its remedy.
std::string look_up(const std::string& host, std::uint16_t port, Addresses& found) {
  addrinfo wanted{};
  wanted.ai_socktype = SOCK_STREAM;
  wanted.ai_flags = AI_ADDRCONFIG | AI_NUMERICSERV;
  addrinfo* list = nullptr;
  const int failure = ::getaddrinfo(host.c_str(), std::to_string(port).c_str(), &wanted, &list);
  if (failure == EAI_SYSTEM) return system_reason(errno) + kIsTheNameRight;
  if (failure != 0) return std::string(::gai_strerror(failure)) + kIsTheNameRight;
  for (const addrinfo* one = list; one != nullptr; one = one->ai_next) {
    asio::ip::tcp::endpoint endpoint;
    if (one->ai_addrlen > endpoint.capacity()) continue;
    std::memcpy(endpoint.data(), one->ai_addr, one->ai_addrlen);
    endpoint.resize(one->ai_addrlen);
    found.push_back(endpoint);
  }
  ::freeaddrinfo(list);
  return found.empty() ? std::string("it has no address") + kIsTheNameRight : std::string();
}

}  // namespace

Addresses known_addresses(const std::string& host, std::uint16_t port) {
  if (is_localhost(host)) {
    return {{asio::ip::address_v4::loopback(), port}, {asio::ip::address_v6::loopback(), port}};
  }
  std::error_code no_address;
  const auto address = asio::ip::make_address(host, no_address);
  if (no_address) return {};
  return {{address, port}};
}

void NameLookup::start(const std::string& host, std::uint16_t port, OnFound on_found) {
  cancel();
  request_ = std::make_shared<Request>();
  request_->io = &io_;
  request_->on_found = std::move(on_found);
  if (Addresses known = known_addresses(host, port); !known.empty()) {
    request_->answer({}, std::move(known));
    return;
  }
  // Thrown when the system has no thread left.
  try {
    std::thread([request = request_, host, port] {
      Addresses found;
      std::string failure = look_up(host, port, found);
      request->answer(std::move(failure), std::move(found));
    }).detach();
  } catch (const std::system_error& failure) {
    request_->answer(shortage_text(failure), {});
  }
}

void NameLookup::cancel() {
  if (!request_) return;
  const std::lock_guard lock(request_->mutex);
  request_->io = nullptr;
}

}  // namespace aucast::link

#include "common/link/name_lookup.h"

#include <netdb.h>
#include <sys/socket.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "common/link/host.h"
#include "common/own_computer.h"
#include "common/text.h"
#include "common/thread.h"

namespace aucast::link {

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
  gate_ = std::make_shared<LoopGate>(io_);
  on_found_ = std::move(on_found);
  const auto answer = [this, gate = gate_](std::string failure, Addresses found) {
    gate->post([this, failure = std::move(failure), found = std::move(found)] {
      std::exchange(on_found_, {})(failure, found);
    });
  };
  if (Addresses known = known_addresses(host, port); !known.empty()) {
    answer({}, std::move(known));
    return;
  }
  const auto started = start_unattended([answer, host, port] {
    Addresses found;
    std::string failure = look_up(host, port, found);
    answer(std::move(failure), std::move(found));
  });
  if (!started) answer(started.error().message, {});
}

void NameLookup::cancel() {
  if (gate_) gate_->close();
}

}  // namespace aucast::link

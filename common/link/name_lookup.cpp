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

/// See NameLookup::Resolve. The failure has its remedy.
std::string resolve_by_system(const std::string& host, Addresses& found) {
  addrinfo wanted{};
  wanted.ai_socktype = SOCK_STREAM;
  wanted.ai_flags = AI_ADDRCONFIG;
  addrinfo* list = nullptr;
  const int failure = ::getaddrinfo(host.c_str(), nullptr, &wanted, &list);
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

NameLookup::NameLookup(asio::io_context& io) : NameLookup(io, resolve_by_system) {}

void NameLookup::start(const std::string& host, std::uint16_t port, OnFound on_found) {
  ++question_;
  host_ = host;
  port_ = port;
  on_found_ = std::move(on_found);
  if (Addresses known = known_addresses(host, port); !known.empty()) {
    answer_later({}, std::move(known));
    return;
  }
  if (!running_.insert(host).second) return;
  const auto started = start_unattended([this, gate = gate_, resolve = resolve_, host] {
    Addresses found;
    std::string failure = resolve(host, found);
    gate->post([this, host, failure = std::move(failure), found = std::move(found)] {
      running_.erase(host);
      if (host == host_) answer(failure, found);
    });
  });
  if (started) return;
  running_.erase(host);
  answer_later(started.error().message, {});
}

void NameLookup::answer_later(const std::string& failure, Addresses found) {
  gate_->post([this, question = question_, failure, found = std::move(found)] {
    if (question == question_) answer(failure, found);
  });
}

void NameLookup::answer(const std::string& failure, Addresses found) {
  if (!on_found_) return;
  for (auto& endpoint : found) endpoint.port(port_);
  std::exchange(on_found_, {})(failure, std::move(found));
}

}  // namespace aucast::link

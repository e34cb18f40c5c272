#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>

#include <asio/ip/address.hpp>

namespace aucast::server {

/// How many clients there are from each address. Of IPv6 the first 64 bits count, which is what one
/// household or host has for itself; IPv4 within IPv6 counts as IPv4.
/// Thread: none of its own.
class AddressCounts {
 public:
  void add(std::uint64_t client, const asio::ip::address& address);
  /// Without effect for a client that was not added.
  void remove(std::uint64_t client);
  [[nodiscard]] std::size_t count(const asio::ip::address& address) const;

 private:
  std::map<std::uint64_t, std::string> of_client_;
  std::map<std::string, std::size_t> counts_;
};

}  // namespace aucast::server

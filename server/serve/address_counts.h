#pragma once

#include <cstddef>
#include <cstdint>
#include <map>

#include <asio/ip/address.hpp>

namespace aucast::server {

/// Identifies one household or host: by its IPv4 address, or by the first 64 bits of its IPv6
/// address, which belong to it alone. IPv4 mapped into IPv6 is the same as IPv4.
using AddressKey = std::uint64_t;

[[nodiscard]] AddressKey address_key(const asio::ip::address& address);

/// Counts the clients from each address. Thread: none of its own.
class AddressCounts {
 public:
  void add(AddressKey address) { ++counts_[address]; }
  /// The address must have been added.
  void remove(AddressKey address);
  [[nodiscard]] std::size_t count(AddressKey address) const;

 private:
  std::map<AddressKey, std::size_t> counts_;
};

}  // namespace aucast::server

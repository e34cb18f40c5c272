#pragma once

#include <cstddef>
#include <cstdint>
#include <map>

#include <asio/ip/address.hpp>

namespace aucast::server {

/// One household or host: an IPv4 address, or the first 64 bits of an IPv6 address, which is what
/// one has for itself. IPv4 within IPv6 is the same as IPv4.
using AddressKey = std::uint64_t;

[[nodiscard]] AddressKey address_key(const asio::ip::address& address);

/// How many clients there are from each address. Thread: none of its own.
class AddressCounts {
 public:
  void add(AddressKey address) { ++counts_[address]; }
  /// One that was added.
  void remove(AddressKey address);
  [[nodiscard]] std::size_t count(AddressKey address) const;

 private:
  std::map<AddressKey, std::size_t> counts_;
};

}  // namespace aucast::server

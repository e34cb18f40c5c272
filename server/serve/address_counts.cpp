#include "server/serve/address_counts.h"

namespace aucast::server {

AddressKey address_key(const asio::ip::address& address) {
  // No IPv6 address in use begins with the 32 zeros that an IPv4 address has here before it.
  if (address.is_v4()) return address.to_v4().to_uint();
  const auto v6 = address.to_v6();
  if (v6.is_v4_mapped()) return asio::ip::make_address_v4(asio::ip::v4_mapped, v6).to_uint();
  const auto bytes = v6.to_bytes();
  AddressKey key = 0;
  for (std::size_t i = 0; i < sizeof key; ++i) key = key << 8U | bytes[i];
  return key;
}

void AddressCounts::remove(AddressKey address) {
  const auto count = counts_.find(address);
  if (--count->second == 0) counts_.erase(count);
}

std::size_t AddressCounts::count(AddressKey address) const {
  const auto found = counts_.find(address);
  return found == counts_.end() ? 0 : found->second;
}

}  // namespace aucast::server

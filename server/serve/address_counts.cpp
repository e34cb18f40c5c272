#include "server/serve/address_counts.h"

#include "common/link/listener.h"

namespace aucast::server {

AddressKey address_key(const asio::ip::address& address) {
  // The key of an IPv4 address begins with 32 zeros. The only IPv6 address in use that does too is
  // ::1: its key is 0, that of 0.0.0.0, which no client has.
  const auto plain = link::without_mapping(address);
  if (plain.is_v4()) return plain.to_v4().to_uint();
  const auto bytes = plain.to_v6().to_bytes();
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

#include "server/serve/address_counts.h"

#include <algorithm>

namespace aucast::server {
namespace {

std::string key_of(const asio::ip::address& address) {
  if (address.is_v4()) return address.to_string();
  const auto v6 = address.to_v6();
  if (v6.is_v4_mapped()) {
    return asio::ip::make_address_v4(asio::ip::v4_mapped, v6).to_string();
  }
  const auto bytes = v6.to_bytes();
  return {bytes.begin(), bytes.begin() + 8};
}

}  // namespace

void AddressCounts::add(std::uint64_t client, const asio::ip::address& address) {
  const std::string key = key_of(address);
  of_client_[client] = key;
  ++counts_[key];
}

void AddressCounts::remove(std::uint64_t client) {
  const auto found = of_client_.find(client);
  if (found == of_client_.end()) return;
  const auto count = counts_.find(found->second);
  if (--count->second == 0) counts_.erase(count);
  of_client_.erase(found);
}

std::size_t AddressCounts::count(const asio::ip::address& address) const {
  const auto found = counts_.find(key_of(address));
  return found == counts_.end() ? 0 : found->second;
}

}  // namespace aucast::server

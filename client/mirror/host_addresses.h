#pragma once

#include <string>
#include <vector>

namespace aucast::mirror {

/// The IPv4 addresses under which others may reach this host, without loopback addresses.
[[nodiscard]] std::vector<std::string> host_addresses();

}  // namespace aucast::mirror

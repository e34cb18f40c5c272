#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "common/result.h"
#include "common/tls/context.h"
#include "protocol/endpoint.h"

namespace aucast::server {

/// What it takes to dial the servers of an address.
struct DialledAddress {
  protocol::StreamAddress address;
  std::optional<tls::Context> tls{};  ///< when the address wants it
  std::string token{};                ///< to be shown; empty: none
};

struct DialSecrets {
  std::filesystem::path token;  ///< a file; empty: none
  tls::Files tls;
  std::string tls_options;  ///< how the options that name its files begin: "--upstream-tls"
};

/// Reads the address and the files, and warns in the log of secrets that others can read. Usage
/// error when the token would go over the network for everybody to read.
[[nodiscard]] Result<DialledAddress> dialled_address(const std::string& address,
                                                     const DialSecrets& secrets);

}  // namespace aucast::server

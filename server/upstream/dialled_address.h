#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

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

/// Usage error when `what`, such as "the token", would go over the network for everybody to read;
/// `secure`: how an address over TLS begins.
[[nodiscard]] Result<void> check_hidden(const protocol::StreamAddress& address,
                                        std::string_view what, std::string_view secure);

/// The token of the file, to be shown at that address; empty when no file is given. Warns in the
/// log when others can read it. Usage error when it would go over the network for everybody to
/// read; `secure`: how an address over TLS begins.
[[nodiscard]] Result<std::string> token_for(const protocol::StreamAddress& address,
                                            const std::filesystem::path& file,
                                            std::string_view secure);

/// Reads the address and the files, and warns in the log of secrets that others can read. Usage
/// error when the token would go over the network for everybody to read.
[[nodiscard]] Result<DialledAddress> dialled_address(const std::string& address,
                                                     const DialSecrets& secrets);

}  // namespace aucast::server

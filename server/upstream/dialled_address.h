#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "common/result.h"
#include "common/tls/context.h"
#include "protocol/endpoint.h"

namespace aucast::server {

/// Everything needed to dial the servers of an address.
struct DialledAddress {
  protocol::StreamAddress address;
  std::optional<tls::Context> tls{};  ///< nullopt: the address is without TLS
  std::string token{};                ///< to show to these servers; empty: none
};

struct DialSecrets {
  std::filesystem::path token;  ///< the token's file; empty: none
  tls::Files tls;
  std::string tls_options;  ///< how the options for the files of `tls` begin: "--upstream-tls"
};

/// Fails with a Usage error if `what`, such as "the token", would be sent over the network
/// unencrypted. `secure`, for the message: how an address over TLS begins.
[[nodiscard]] Result<void> check_hidden(const protocol::StreamAddress& address,
                                        std::string_view what, std::string_view secure);

/// Reads the token to be shown at that address; empty when no file is given. Warns in the log when
/// others can read the file. Errors are those of read_token_file() and check_hidden().
[[nodiscard]] Result<std::string> token_for(const protocol::StreamAddress& address,
                                            const std::filesystem::path& file,
                                            std::string_view secure);

/// Reads the address and the files, and warns in the log of secrets that others can read. Errors
/// are those of parse_stream_address(), tls::Context::for_client() and token_for().
[[nodiscard]] Result<DialledAddress> dialled_address(const std::string& address,
                                                     const DialSecrets& secrets);

}  // namespace aucast::server

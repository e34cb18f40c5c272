#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace aucast::protocol {

/// Base64 (RFC 4648 section 4) without padding.
[[nodiscard]] std::string to_base64(std::string_view bytes);

/// Decodes base64 without padding. Returns nullopt for a character outside the alphabet, an
/// impossible length, or unused bits that are not 0, so that each byte string has only one
/// spelling.
[[nodiscard]] std::optional<std::string> from_base64(std::string_view text);

}  // namespace aucast::protocol

#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace aucast::protocol {

/// Base64 (RFC 4648 section 4) without padding.
[[nodiscard]] std::string to_base64(std::string_view bytes);

/// The bytes of base64 without padding. Nothing for a character outside the alphabet, a length that
/// no bytes have, and bits left over that are not 0: each byte string has one spelling only.
[[nodiscard]] std::optional<std::string> from_base64(std::string_view text);

}  // namespace aucast::protocol

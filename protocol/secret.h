#pragma once

#include <string_view>

namespace aucast::protocol {

/// Whether `shown` is the secret `kept`, which must not be empty. The time that this takes depends
/// only on the length of `shown`, so nobody can find out the secret byte by byte.
[[nodiscard]] bool same_secret(std::string_view shown, std::string_view kept);

}  // namespace aucast::protocol

#pragma once

#include <string_view>

namespace aucast::protocol {

/// Whether `shown` is the secret `kept`, which must not be empty. The time it takes depends on the
/// length of `shown` alone, so nobody can find the secret out byte by byte.
[[nodiscard]] bool same_secret(std::string_view shown, std::string_view kept);

}  // namespace aucast::protocol

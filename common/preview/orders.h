#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace aucast::preview {

/// Let others in at this address of this host.
struct GoLive {
  std::string bind;
  std::uint16_t port = 0;
  friend bool operator==(const GoLive&, const GoLive&) = default;
};
/// Send them away again.
struct GoPrivate {
  friend bool operator==(const GoPrivate&, const GoPrivate&) = default;
};
using Order = std::variant<GoLive, GoPrivate>;

/// A line, with its end.
[[nodiscard]] std::string order_text(const Order& order);
/// Reads an order from a line without its end; nullopt if it is none.
[[nodiscard]] std::optional<Order> parse_order(std::string_view line);

}  // namespace aucast::preview

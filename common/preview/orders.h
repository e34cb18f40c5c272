#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace aucast::preview {

/// An order: let others connect at this address of this host.
struct GoLive {
  std::string bind;
  std::uint16_t port = 0;
  friend bool operator==(const GoLive&, const GoLive&) = default;
};
/// An order: send the others away and let no more in.
struct GoPrivate {
  friend bool operator==(const GoPrivate&, const GoPrivate&) = default;
};
using Order = std::variant<GoLive, GoPrivate>;

/// The order as a line, with its line end.
[[nodiscard]] std::string order_text(const Order& order);
/// Reads an order from a line without its end; nullopt if the line is no order.
[[nodiscard]] std::optional<Order> parse_order(std::string_view line);

}  // namespace aucast::preview

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace aucast::preview {

/// Others are let in at this address of this host.
struct GoLive {
  std::string bind;
  std::uint16_t port = 0;
  friend bool operator==(const GoLive&, const GoLive&) = default;
};
/// They are shown out again.
struct GoPrivate {
  friend bool operator==(const GoPrivate&, const GoPrivate&) = default;
};
using Order = std::variant<GoLive, GoPrivate>;

/// A line, with its end.
[[nodiscard]] std::string order_text(const Order& order);
/// The order of a line without its end; nothing for what is none.
[[nodiscard]] std::optional<Order> parse_order(std::string_view line);

}  // namespace aucast::preview

#include "common/preview/orders.h"

#include "common/number_of.h"
#include "common/text.h"

namespace aucast::preview {

std::string order_text(const Order& order) {
  const auto* live = std::get_if<GoLive>(&order);
  if (live == nullptr) return "private\n";
  return "live " + std::to_string(live->port) + " " + live->bind + "\n";
}

std::optional<Order> parse_order(std::string_view line) {
  const auto words = split_words(line);
  if (words.size() == 1 && words[0] == "private") return GoPrivate{};
  if (words.size() != 3 || words[0] != "live") return std::nullopt;
  const auto port = number_of<std::uint16_t>(words[1]);
  if (!port) return std::nullopt;
  return GoLive{std::string(words[2]), *port};
}

}  // namespace aucast::preview

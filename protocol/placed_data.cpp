#include "protocol/placed_data.h"

#include "common/number_of.h"
#include "common/text.h"
#include "protocol/base64.h"
#include "protocol/limits.h"

namespace aucast::protocol {

std::variant<PlacedData, FieldFault> parse_placed_data(std::string_view text) {
  PlacedData placed;
  text.remove_prefix(1);
  placed.position = 2;
  if (text.starts_with('@')) {
    const std::string_view digits = text.substr(1, text.find(' ') - 1);
    if (digits.size() <= kNumberDigitsMax) placed.place_ms = number_of<std::uint64_t>(digits);
    if (!placed.place_ms || *placed.place_ms > static_cast<std::uint64_t>(kPlaceMsMax)) {
      return FieldFault{3, "a place is a number of 0-" + std::to_string(kPlaceMsMax) + ", found '" +
                               escaped(digits) + "'"};
    }
    text.remove_prefix(1 + digits.size());
    placed.position += 1 + digits.size();
  }
  if (text.empty()) return placed;
  text.remove_prefix(1);
  placed.position += 1;
  auto bytes = from_base64(text);
  if (!bytes) {
    return FieldFault{placed.position, "'" + escaped(text) + "' is no base64 without padding"};
  }
  placed.bytes = *std::move(bytes);
  return placed;
}

std::string encode_placed_data(char word, std::optional<std::uint64_t> place_ms,
                               std::string_view bytes) {
  std::string text{'{', word};
  if (place_ms) text.append("@").append(std::to_string(*place_ms));
  if (!bytes.empty()) text.append(" ").append(to_base64(bytes));
  return text + '}';
}

}  // namespace aucast::protocol
